"""How far Ambient Occlusion looks."""

from .flat import Node


def look_as_far_as_the_world(node: Node, world_distance: float) -> None:
    """A distance of zero stands for the world's own."""
    if node.kind != "AMBIENT_OCCLUSION":
        return
    distance = node.inputs["Distance"]
    if distance.source is None and distance.value == 0.0:
        distance.value = world_distance
