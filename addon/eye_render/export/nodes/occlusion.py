"""How far Ambient Occlusion looks."""

from .flat import Node


def note_global_distance(node: Node) -> None:
    """A distance of zero stands for the world's own, which is not looked up."""
    distance = node.inputs["Distance"]
    if distance.source is None and distance.value == 0.0:
        node.notes.append("the world's distance for")
