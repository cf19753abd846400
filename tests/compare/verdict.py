"""Whether a feature scene is as near to its reference as it must be."""

import references
from blender_batch import Rendered
from deviations import AS_CYCLES, FLIP_MARGIN, expected_of
from measure import Difference, excess_rmse, measure
from page import EXPECTED, FAILED, PASSED, Cost, Row
from picture import as_seen


def row_of(rendered: Rendered, version: tuple[int, ...], samples: int | None = None) -> Row:
    """The scene beside its reference. `samples` None: rendered with its own."""
    facts = rendered.facts
    expected = expected_of(facts, version)
    row = Row(facts["name"], facts["about"], FAILED, round(expected.flip + FLIP_MARGIN, 4))
    row.warnings = rendered.warnings
    if rendered.error or facts["refused"]:
        is_refused = bool(facts["refused"]) and facts["refused"] in rendered.error
        row.outcome = EXPECTED if is_refused else FAILED
        row.reason = rendered.error or f"rendered, in place of: {facts['refused']}"
        return row
    stored = references.path_of(facts["name"])
    if not stored.exists():
        row.reason = "no reference"
        return row
    reference = references.load(stored)
    picture = as_seen(rendered.pictures[0], facts["view"])
    row.noise, row.pictures = reference.noise, (reference.mean, picture)
    row.eye_render = Cost(rendered.seconds, rendered.peak_mb)
    row.difference = difference_of(reference, picture, samples or facts["samples"])
    if AS_CYCLES.is_near(row.difference):
        row.outcome = PASSED
    elif expected.is_near(row.difference):
        row.outcome, row.reason = EXPECTED, expected.why
    else:
        row.reason = f"expected is FLIP {expected.flip}, excess RMSE {expected.excess_rmse}"
        row.reason += f" ({expected.why})" if expected.why else ""
    return row


def difference_of(reference: references.Reference, picture, samples: int) -> Difference:
    difference = measure(reference.mean, picture)
    difference.excess_rmse = excess_rmse(
        reference.mean, reference.sigma, reference.samples, picture, samples
    )
    return difference
