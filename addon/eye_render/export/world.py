"""The world: a colour, or an environment texture, times a strength."""

from collections.abc import Callable

import bpy
import numpy as np

from .. import compat
from .image import MISSING_COLOR, ImageTable
from .nodes import constant, find_input, node_label, own_value, source, source_node


def export_world(
    core_scene,
    depsgraph: bpy.types.Depsgraph,
    images: ImageTable,
    warn: Callable[[str], None],
) -> None:
    world = compat.world_of(depsgraph.scene_eval, depsgraph.view_layer_eval)
    if world is None:
        core_scene.set_world(color=(0.0, 0.0, 0.0))
        return
    if not compat.uses_nodes(world):
        core_scene.set_world(color=tuple(world.color))
        return
    left_out: list[str] = []
    inlined = compat.inline_shader_nodes(world)
    core_scene.set_world(**_read_nodes(inlined.node_tree, images, left_out))
    if left_out:
        warn(f"World '{world.name}': not supported and left out: {', '.join(left_out)}")


def _read_nodes(
    tree: bpy.types.NodeTree, images: ImageTable, left_out: list[str]
) -> dict[str, object]:
    output = tree.get_output_node("CYCLES")
    background = source_node(output.inputs["Surface"]) if output else None
    if background is None:
        return {"color": (0.0, 0.0, 0.0)}
    if background.bl_idname not in {"ShaderNodeBackground", "ShaderNodeEmission"}:
        left_out.append(node_label(background))
        return {"color": (0.0, 0.0, 0.0)}

    strength = constant(background.inputs["Strength"])
    if strength is None:
        left_out.append(f"{node_label(source_node(background.inputs['Strength']))} (Strength)")
        strength = own_value(background.inputs["Strength"])
    color = constant(background.inputs["Color"])
    if color is not None:
        return {"color": color, "strength": strength}

    node = source_node(background.inputs["Color"])
    if node.bl_idname != "ShaderNodeTexEnvironment":
        left_out.append(f"{node_label(node)} (Color)")
        return {"color": own_value(background.inputs["Color"]), "strength": strength}
    if node.projection != "EQUIRECTANGULAR":
        left_out.append(f"mirror-ball projection of {node_label(node)}")
    texture = None
    if node.image is None:
        left_out.append(f"{node_label(node)} without an image")
    else:
        texture = images.texture(node.image, "REPEAT", node.interpolation)
    if texture is None:
        return {"color": MISSING_COLOR, "strength": strength}
    return {
        "strength": strength,
        "texture": texture,
        "texture_from_world": _texture_from_world(node.inputs["Vector"], left_out),
    }


def _texture_from_world(vector: bpy.types.NodeSocket, left_out: list[str]) -> np.ndarray:
    """The rotation from a world direction to the direction to look up in the texture."""
    output = source(vector)
    if output is None:
        return np.eye(3)
    node = output.node
    if node.bl_idname != "ShaderNodeMapping":
        if node.bl_idname != "ShaderNodeTexCoord" or output.identifier != "Generated":
            left_out.append(f"{node_label(node)} ({vector.name})")
        return np.eye(3)
    _texture_from_world(node.inputs["Vector"], left_out)  # names what stands before the mapping
    angles = node.inputs["Rotation"]
    if source(angles) or not _only_rotates(node):
        left_out.append(f"all but constant Rotation of {node_label(node)}")
    texture_from_world = np.array(angles.default_value.to_matrix())
    return texture_from_world.T if node.vector_type == "TEXTURE" else texture_from_world


def _only_rotates(mapping: bpy.types.Node) -> bool:
    for identifier, still in (("Location", 0.0), ("Scale", 1.0)):
        socket = find_input(mapping, (identifier,))
        if socket is None:  # Blender takes away the sockets that the vector type does not use
            continue
        if source(socket) or not np.allclose(socket.default_value, still):
            return False
    return True
