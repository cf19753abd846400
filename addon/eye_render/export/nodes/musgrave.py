"""The Musgrave texture of Blender until 4.0 as the Noise texture that took its place."""

from dataclasses import replace

from .flat import Input, Node, math_node, math_result

_LEAST = 1e-5
_MOST_OCTAVES = 14.0
# Their first octave is not faded in where Detail is less than one.
_WHOLE_FIRST_OCTAVE = {"RIDGED_MULTIFRACTAL", "HETERO_TERRAIN"}


def musgrave_to_noise(node: Node) -> None:
    """Noise counts the octaves after the first, and wants how much weaker each is than the one
    before; Musgrave counts the first, too, and wants a fractal dimension."""
    detail, dimension = node.inputs["Detail"], node.inputs.pop("Dimension")
    kind = node.options.pop("musgrave_type")
    lacunarity = math_result(math_node("MAXIMUM", node.inputs["Lacunarity"], _LEAST))
    exponent = math_node("MULTIPLY", math_result(math_node("MAXIMUM", dimension, _LEAST)), -1.0)
    first: Input | float = 1.0
    if kind in _WHOLE_FIRST_OCTAVE:
        first = math_result(math_node("GREATER_THAN", detail, 1.0))
    after_first = math_result(math_node("SUBTRACT", detail, first))
    node.kind = "TEX_NOISE"
    node.inputs |= {
        "Detail": math_result(math_node("MINIMUM", after_first, _MOST_OCTAVES)),
        "Roughness": math_result(math_node("POWER", lacunarity, math_result(exponent))),
        "Lacunarity": lacunarity,
    }
    node.options |= {
        "noise_dimensions": node.options.pop("musgrave_dimensions"),
        "noise_type": kind,
        "normalize": False,
    }
    has_whole_octave = detail.source is None and detail.value >= 1.0
    if kind not in _WHOLE_FIRST_OCTAVE and not has_whole_octave:
        _fade_first_octave(node, detail, kind)


def _fade_first_octave(node: Node, detail: Input, kind: str) -> None:
    """Detail below one dims the texture; the node itself becomes what does that, because others
    are linked to it."""
    height = Input("VALUE", source=replace(node).output("Fac", "VALUE"))
    share = math_result(math_node("ADD", detail, 0.0, use_clamp=True))
    faded = math_node("MULTIPLY", height, share)
    if kind == "MULTIFRACTAL":  # a product, whose missing octaves are ones
        rest = math_result(math_node("SUBTRACT", 1.0, detail, use_clamp=True))
        faded = math_node("ADD", math_result(faded), rest)
    node.kind, node.options, node.inputs = faded.kind, faded.options, faded.inputs
    node.changed = set()
    node.renamed_outputs = {"Fac": "Value"}
