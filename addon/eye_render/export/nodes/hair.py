"""Hair shaders as the core has them: a mixture in place of each fibre's own lobes."""

from .flat import Node

LOBES = "the lobes of light within a fibre (a mixture stands in) of"

_OF_LOBES = ("Offset", "Aspect Ratio", "R lobe", "TT lobe", "TRT lobe")


def mix_lobes(node: Node) -> None:
    """Without what only tells the lobes apart."""
    for name in _OF_LOBES:
        node.inputs.pop(name, None)
    node.changed.discard("model")
