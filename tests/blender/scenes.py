"""Building blocks of test scenes, and a scene of the core that writes down what it is told."""

import subprocess
from types import SimpleNamespace
from typing import NamedTuple

import bpy
import numpy as np
from eye_render import core


def add_object(data: bpy.types.ID | None, name: str = "Object") -> bpy.types.Object:
    shown = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(shown)
    return shown


def add_camera() -> bpy.types.Object:
    camera = add_object(bpy.data.cameras.new("Camera"), "Camera")
    camera.data.eye_render.pupil_mode = "MANUAL"
    return camera


def quad_mesh(name: str = "Quad", size: float = 1.0) -> bpy.types.Mesh:
    """A square in the XY plane, normal +Z, with UVs from 0 to 1."""
    half = size / 2
    mesh = bpy.data.meshes.new(name)
    corners = [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)]
    mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
    layer = mesh.uv_layers.new(name="UVMap")
    for corner, uv in zip(layer.data, [(0, 0), (1, 0), (1, 1), (0, 1)], strict=True):
        corner.uv = uv
    return mesh


def node_material(name: str = "Material") -> bpy.types.Material:
    """A material with only an output node; link to it with `surface`."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.node_tree.nodes.clear()
    material.node_tree.nodes.new("ShaderNodeOutputMaterial")
    return material


def add_node(datablock: bpy.types.ID, kind: str, **settings) -> bpy.types.Node:
    node = datablock.node_tree.nodes.new(kind)
    for name, value in settings.items():
        setattr(node, name, value)
    return node


def link(datablock: bpy.types.ID, output: bpy.types.NodeSocket, socket: bpy.types.NodeSocket):
    datablock.node_tree.links.new(output, socket)


def surface(datablock: bpy.types.ID, kind: str, **settings) -> bpy.types.Node:
    """Add a shader node and link it to the active output."""
    node = add_node(datablock, kind, **settings)
    output = datablock.node_tree.get_output_node("CYCLES")
    link(datablock, node.outputs[0], output.inputs["Surface"])
    return node


def add_group_socket(tree: bpy.types.NodeTree, in_out: str, kind: str, name: str) -> object:
    if hasattr(tree, "interface"):  # from Blender 4.0
        return tree.interface.new_socket(name, in_out=in_out, socket_type=kind)
    return (tree.inputs if in_out == "INPUT" else tree.outputs).new(kind, name)


def emitter(color: tuple[float, float, float], name: str = "Glow") -> bpy.types.Material:
    material = node_material(name)
    node = surface(material, "ShaderNodeEmission")
    node.inputs["Color"].default_value = (*color, 1.0)
    return material


def write_multilayer(scene: bpy.types.Scene, path: str) -> None:
    """Make the scene's renders multilayer EXR files."""
    settings = scene.render.image_settings
    if hasattr(settings, "media_type"):  # from Blender 5.0
        settings.media_type = "MULTI_LAYER_IMAGE"
        settings.use_exr_interleave = True  # one part: oiiotool takes channels of the first alone
    settings.file_format = "OPEN_EXR_MULTILAYER"
    scene.render.filepath = path


def layer_pixels(path: str, pass_name: str, channels: str = "RGBA") -> np.ndarray:
    """(height, width, channels) of a pass in a multilayer file."""
    found = [f"ViewLayer.{pass_name}.{channel}" for channel in channels]
    wanted = (found * 4)[:4]
    alone = f"{path}.{pass_name}.exr"
    names = ["--ch", ",".join(wanted), "--chnames", "R,G,B,A", "-d", "float", "-o", alone]
    subprocess.run(["oiiotool", path, *names], check=True)
    image = bpy.data.images.load(alone)
    image.alpha_mode = "CHANNEL_PACKED"
    pixels = np.empty((image.size[1], image.size[0], 4), np.float32)
    image.pixels.foreach_get(pixels.ravel())
    return pixels[..., : len(channels)]


class RecordingSocket(NamedTuple):
    node: "RecordingNode"
    identifier: str


class RecordingNode:
    def __init__(self, kind: str, options: dict[str, object]):
        self.kind, self.options, self.inputs = kind, options, {}
        self._type = core.module.NODE_TYPES[kind]
        assert options.keys() <= set(self._type["options"])

    def set(self, identifier: str, value: object) -> None:
        assert identifier in self._type["inputs"]
        self.inputs[identifier] = value

    def __getitem__(self, identifier: str) -> RecordingSocket:
        assert identifier in self._type["outputs"]
        return RecordingSocket(self, identifier)


class RecordingGraph:
    """Stands where the core's graph stands, knows what the core knows, and keeps every node."""

    def __init__(self):
        self.nodes: list[RecordingNode] = []

    def add(self, kind: str, inputs: dict[str, object] | None = None, **options) -> RecordingNode:
        self.nodes.append(RecordingNode(kind, options))
        for identifier, value in (inputs or {}).items():
            self.nodes[-1].set(identifier, value)
        return self.nodes[-1]


class RecordingScene:
    """Stands where the core's scene stands, and keeps every argument."""

    def __init__(self, uv_layers: list[str] = (), attributes: list[str] = ()):
        self.meshes: list[SimpleNamespace] = []
        self.curves: list[SimpleNamespace] = []
        self.points: list[SimpleNamespace] = []
        self.instances: list[SimpleNamespace] = []
        self.materials: list[SimpleNamespace] = []
        self.lights: list[SimpleNamespace] = []
        self.textures: list[SimpleNamespace] = []
        self.world = self.world_volume = self.camera = None
        self._uv_layers = list(uv_layers)
        self._attributes = list(attributes)

    def uv_layers_read(self, _material_ids):
        return self._uv_layers

    def attributes_read(self, _material_ids):
        return self._attributes

    def add_mesh(self, name, positions, triangles, **rest):
        self.meshes.append(
            SimpleNamespace(name=name, positions=positions, triangles=triangles, **rest)
        )
        return self._number()

    def add_curves(self, name, positions, radii, first_keys, **rest):
        self.curves.append(
            SimpleNamespace(
                name=name, positions=positions, radii=radii, first_keys=first_keys, **rest
            )
        )
        return self._number()

    def add_points(self, name, positions, radii, **rest):
        self.points.append(SimpleNamespace(name=name, positions=positions, radii=radii, **rest))
        return self._number()

    def _number(self) -> int:
        return len(self.meshes) + len(self.curves) + len(self.points) - 1

    def add_instances(self, geometry, world_from_object, materials, **look):
        self.instances.append(
            SimpleNamespace(
                geometry=geometry,
                world_from_object=np.array(world_from_object),
                materials=materials,
                **look,
            )
        )

    def add_material(
        self, name, surface=None, displacement=None, volume=None, pass_index=0, aovs=()
    ):
        self.materials.append(
            SimpleNamespace(
                name=name,
                surface=surface,
                displacement=displacement,
                volume=volume,
                pass_index=pass_index,
                aovs=aovs,
            )
        )
        return len(self.materials) - 1

    def add_light(self, name, kind, world_from_light, color, **rest):
        self.lights.append(
            SimpleNamespace(
                name=name, kind=kind, world_from_light=world_from_light, color=color, **rest
            )
        )

    def add_texture(self, path, **how):
        self.textures.append(SimpleNamespace(path=path, pixels=None, **how))
        return len(self.textures) - 1

    def add_texture_pixels(self, name, pixels, **how):
        self.textures.append(SimpleNamespace(path=None, name=name, pixels=pixels, **how))
        return len(self.textures) - 1

    def set_world(self, surface, volume=None, aovs=()):
        self.world, self.world_volume, self.world_aovs = surface, volume, aovs

    def set_world_light_group(self, name):
        self.world_light_group = name

    def set_world_visibility(self, hidden_from):
        self.world_hidden_from = hidden_from

    def set_camera(self, world_from_camera, slope_bounds, resolution, **rest):
        self.camera = SimpleNamespace(
            world_from_camera=world_from_camera,
            slope_bounds=slope_bounds,
            resolution=resolution,
            **rest,
        )
