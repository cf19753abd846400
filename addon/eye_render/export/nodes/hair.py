"""Hair shaders as the core has them."""

from .flat import Node

LOBES = "the lobes of light within a fibre (a mixture stands in) of"


def mix_lobes(node: Node) -> None:
    """Without what only tells the lobes apart."""
    node.inputs.pop("Offset", None)


def chiang_fibre(node: Node) -> None:
    """Chiang's model is the core's own, although Blender's default is Huang's."""
    node.changed.discard("model")


def round_fibre(node: Node) -> None:
    """Huang's fibre as Chiang's: as rough around as along, and with all of its lobes."""
    for name in ("Aspect Ratio", "Coat", "R lobe", "TT lobe", "TRT lobe"):
        node.inputs.pop(name, None)
    node.inputs["Radial Roughness"] = node.inputs["Roughness"]
    node.changed.discard("model")
