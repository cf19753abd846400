"""Whether a feature scene is as near to its reference as it must be."""

import references
from blender_batch import Rendered
from measure import measure
from not_yet import NOT_YET
from page import EXPECTED, FAILED, PASSED, Cost, Row
from picture import as_seen

THRESHOLD = 0.03  # of mean FLIP
ANYTHING = 1.0


def row_of(rendered: Rendered, version: tuple[int, ...]) -> Row:
    """The scene beside its reference."""
    facts = rendered.facts
    threshold, reason = allowed(facts, version)
    row = Row(facts["name"], facts["about"], FAILED, threshold, reason)
    row.warnings = rendered.warnings
    stored = references.path_of(facts["name"])
    if rendered.error:
        row.outcome = EXPECTED if threshold >= ANYTHING else FAILED
        row.reason = f"{rendered.error} ({reason})" if reason else rendered.error
        return row
    if not stored.exists():
        row.reason = "no reference"
        return row
    reference = references.load(stored)
    picture = as_seen(rendered.pictures[0], facts["view"])
    row.noise, row.pictures = reference.noise, (reference.mean, picture)
    row.eye_render = Cost(rendered.seconds, rendered.peak_mb)
    row.difference = measure(reference.mean, picture)
    figure = row.difference.figure()
    if figure <= THRESHOLD:
        row.outcome, row.reason = PASSED, ""
    elif figure <= threshold:
        row.outcome = EXPECTED
    else:
        row.reason = f"more than {threshold}" + (f" ({reason})" if reason else "")
    return row


def allowed(facts: dict, version: tuple[int, ...]) -> tuple[float, str]:
    """How far the scene may be off in that Blender, and why so far."""
    if facts["name"] in NOT_YET:
        return NOT_YET[facts["name"]]
    if version < (4, 0) and facts["before_4"]:
        reason, threshold = facts["before_4"]
        return threshold, reason
    return facts["threshold"], facts["differs"]
