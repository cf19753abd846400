"""The world: a colour, or what its nodes make of each direction."""

from collections.abc import Callable

import bpy

from .. import compat, cycles_settings, passes
from .image import ImageTable
from .nodes import BACKGROUND, aov_sockets, export_sockets

_BLACK = (0.0, 0.0, 0.0)
_RAYS = {
    "CAMERA": "camera",
    "DIFFUSE": "diffuse",
    "GLOSSY": "glossy",
    "TRANSMISSION": "transmission",
    "VOLUME_SCATTER": "scatter",
}


def export_world(
    core_scene,
    depsgraph: bpy.types.Depsgraph,
    images: ImageTable,
    warn: Callable[[str], None],
) -> None:
    view_layer = depsgraph.view_layer_eval
    world = compat.world_of(depsgraph.scene_eval, view_layer)
    if world is None or not view_layer.use_sky:
        core_scene.set_world(_BLACK)
        return
    if world.lightgroup in view_layer.lightgroups:
        core_scene.set_world_light_group(world.lightgroup)
    core_scene.set_world_visibility(
        [ray for ray, name in _RAYS.items() if not cycles_settings.sees_world(world, name)]
    )
    if not compat.uses_nodes(world):
        core_scene.set_world(tuple(world.color))
        return
    inlined = compat.inline_shader_nodes(world)
    output = inlined.node_tree.get_output_node("CYCLES")
    if output is None:
        core_scene.set_world(_BLACK)
        return
    sockets = (output.inputs["Surface"], output.inputs["Volume"])
    written = aov_sockets(inlined.node_tree, passes.aovs(view_layer))
    tree = export_sockets(sockets, images, BACKGROUND, written)
    left_out = list(tree.left_out)
    surface, volume = tree.sockets
    light = _BLACK if surface is None else surface
    try:
        core_scene.set_world(light, volume, aovs=tree.values)
    except ValueError as error:  # what the core sees only when all nodes are together
        left_out.append(str(error))
        core_scene.set_world(tuple(world.color))
    if left_out:
        warn(f"World '{world.name}': not supported: {', '.join(left_out)}")
