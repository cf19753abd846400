"""The world: a colour, or what its nodes make of each direction."""

from collections.abc import Callable

import bpy

from .. import compat
from .image import ImageTable
from .nodes import BACKGROUND, export_sockets, linked_label

_BLACK = (0.0, 0.0, 0.0)


def export_world(
    core_scene,
    depsgraph: bpy.types.Depsgraph,
    images: ImageTable,
    warn: Callable[[str], None],
) -> None:
    world = compat.world_of(depsgraph.scene_eval, depsgraph.view_layer_eval)
    if world is None:
        core_scene.set_world(_BLACK)
        return
    if not compat.uses_nodes(world):
        core_scene.set_world(tuple(world.color))
        return
    inlined = compat.inline_shader_nodes(world)
    output = inlined.node_tree.get_output_node("CYCLES")
    if output is None:
        core_scene.set_world(_BLACK)
        return
    tree = export_sockets([output.inputs["Surface"]], images, BACKGROUND)
    left_out = list(tree.left_out)
    volume = linked_label(output.inputs["Volume"])
    if volume:
        left_out.append(f"{volume} (Volume)")
    (surface,) = tree.sockets
    try:
        core_scene.set_world(_BLACK if surface is None else surface)
    except ValueError as error:  # what the core sees only when all nodes are together
        left_out.append(str(error))
        core_scene.set_world(tuple(world.color))
    if left_out:
        warn(f"World '{world.name}': not supported: {', '.join(left_out)}")
