"""The world: a colour, or what its nodes make of each direction."""

from collections.abc import Callable

import bpy

from .. import compat, passes
from .image import ImageTable
from .nodes import BACKGROUND, aov_sockets, export_sockets

_BLACK = (0.0, 0.0, 0.0)
# The outputs of Light Path that are all one for a ray of the kind. A ray through glass is glossy,
# too.
_RAYS = {
    "camera": ["Is Camera Ray"],
    "diffuse": ["Is Diffuse Ray"],
    "glossy": ["Is Glossy Ray", "Is Reflection Ray"],
    "transmission": ["Is Transmission Ray"],
    "scatter": ["Is Volume Scatter Ray"],
}


def export_world(
    core_scene,
    depsgraph: bpy.types.Depsgraph,
    images: ImageTable,
    warn: Callable[[str], None],
) -> None:
    view_layer = depsgraph.view_layer_eval
    world = compat.world_of(depsgraph.scene_eval, view_layer)
    if world is None:
        core_scene.set_world(_BLACK)
        return
    if world.lightgroup in view_layer.lightgroups:
        core_scene.set_world_light_group(world.lightgroup)
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
    light = _BLACK if surface is None else _seen_by_some(tree.graph, surface, world)
    try:
        core_scene.set_world(light, volume, aovs=tree.values)
    except ValueError as error:  # what the core sees only when all nodes are together
        left_out.append(str(error))
        core_scene.set_world(tuple(world.color))
    if left_out:
        warn(f"World '{world.name}': not supported: {', '.join(left_out)}")


def _seen_by_some(graph, surface: object, world: bpy.types.World) -> object:
    """The surface for the rays that the world's ray visibility lets see it; black for others."""
    for kind, outputs in _RAYS.items():
        if getattr(world.cycles_visibility, kind):
            continue
        path = graph.add("LIGHT_PATH")
        hidden = path[outputs[0]]
        for output in outputs[1:]:
            product = graph.add(
                "MATH", {"Value": hidden, "Value_001": path[output]}, operation="MULTIPLY"
            )
            hidden = product["Value"]
        surface = graph.add("MIX_SHADER", {"Fac": hidden, "Shader": surface})["Shader"]
    return surface
