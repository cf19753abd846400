"""Materials: the closure at the active output, its inputs as numbers, images or attributes."""

from collections.abc import Callable

import bpy

from .. import compat, core
from .image import MISSING_COLOR, ImageTable
from .nodes import constant, find_input, node_label, own_value, source, source_node

# Socket identifiers of each core input, newest first: Blender 4.0 renamed those of Principled.
_PRINCIPLED = {
    "base_color": ("Base Color",),
    "metallic": ("Metallic",),
    "roughness": ("Roughness",),
    "specular": ("Specular IOR Level", "Specular"),
    "ior": ("IOR",),
    "transmission": ("Transmission Weight", "Transmission"),
    "alpha": ("Alpha",),
    "emission_color": ("Emission Color", "Emission"),
    "emission_strength": ("Emission Strength",),
}
_SURFACES = {
    "ShaderNodeBsdfPrincipled": ("PRINCIPLED", _PRINCIPLED),
    "ShaderNodeBsdfDiffuse": ("DIFFUSE", {"base_color": ("Color",)}),
    "ShaderNodeBsdfGlossy": ("GLOSSY", {"base_color": ("Color",), "roughness": ("Roughness",)}),
    "ShaderNodeBsdfAnisotropic": (  # what Blender 4.0 calls Glossy
        "GLOSSY",
        {"base_color": ("Color",), "roughness": ("Roughness",)},
    ),
    "ShaderNodeBsdfGlass": (
        "GLASS",
        {"base_color": ("Color",), "roughness": ("Roughness",), "ior": ("IOR",)},
    ),
    "ShaderNodeEmission": (
        "EMISSION",
        {"emission_color": ("Color",), "emission_strength": ("Strength",)},
    ),
    "ShaderNodeBsdfTransparent": ("TRANSPARENT", {"base_color": ("Color",)}),
}
_COLOR_INPUTS = {"base_color", "emission_color"}

# Inputs that change the picture when they are not zero, and that the core does not have.
_IGNORED_WEIGHTS = (
    "Subsurface",
    "Subsurface Weight",
    "Clearcoat",
    "Coat Weight",
    "Sheen",
    "Sheen Weight",
    "Anisotropic",
    "Anisotropy",
)
# Specular reflectance of Blender 3's Principled does not depend on its IOR: it is that of 1.5.
_IOR_OF_OLD_SPECULAR = 1.5


class MaterialTable:
    """The materials of one core scene, each added once, when something first wears it."""

    def __init__(
        self,
        core_scene,
        images: ImageTable,
        override: bpy.types.Material | None,
        warn: Callable[[str], None],
    ):
        self._core_scene = core_scene
        self._images = images
        self._override = override
        self._warn = warn
        self._ids: dict[str, int] = {}

    def worn_by(self, shown: bpy.types.Object) -> tuple[int, ...]:
        """The materials in the object's slots, linked to object or data; at least one."""
        slots = shown.material_slots
        return tuple(self._id(slot.material) for slot in slots) or (self._id(None),)

    def _id(self, material: bpy.types.Material | None) -> int:
        material = self._override or material
        name = material.name_full if material else ""
        if name not in self._ids:
            surface, inputs = ("DIFFUSE", {})
            if material:
                reader = _MaterialReader(material, self._images)
                surface, inputs = reader.read()
                if reader.left_out:
                    parts = ", ".join(dict.fromkeys(reader.left_out))
                    self._warn(f"Material '{material.name}': not supported and left out: {parts}")
            self._ids[name] = self._core_scene.add_material(name, surface, **inputs)
        return self._ids[name]


class _MaterialReader:
    """Reads one material; `left_out` names what the core cannot show."""

    def __init__(self, material: bpy.types.Material, images: ImageTable):
        self._material = material
        self._images = images
        self.left_out: list[str] = []

    def read(self) -> tuple[str, dict[str, object]]:
        """The core's surface and its inputs."""
        material = self._material
        if not compat.uses_nodes(material):
            return "PRINCIPLED", {
                "base_color": tuple(material.diffuse_color)[:3],
                "metallic": material.metallic,
                "specular": material.specular_intensity,
                "roughness": material.roughness,
            }
        inlined = compat.inline_shader_nodes(material)
        output = inlined.node_tree.get_output_node("CYCLES")
        node = source_node(output.inputs["Surface"]) if output else None
        if node is None:
            return "DIFFUSE", {"base_color": (0.0, 0.0, 0.0)}
        for unsupported in ("Volume", "Displacement"):
            linked = source_node(output.inputs[unsupported])
            if linked:
                self._leave_out(linked, unsupported)
        if node.bl_idname in _SURFACES:
            return self._read_surface(node)
        self._leave_out(node, "Surface")
        return "DIFFUSE", {"base_color": self._fallback_color(node)}

    def _leave_out(self, node: bpy.types.Node, socket_name: str) -> None:
        self.left_out.append(f"{node_label(node)} ({socket_name})")

    def _read_surface(self, node: bpy.types.Node) -> tuple[str, dict[str, object]]:
        surface, identifiers_of = _SURFACES[node.bl_idname]
        inputs = {}
        for name, identifiers in identifiers_of.items():
            socket = find_input(node, identifiers)
            if socket is not None:
                inputs[name] = self._read_input(socket, name in _COLOR_INPUTS)
        if hasattr(node, "distribution"):
            inputs["multiple_scattering"] = node.distribution == "MULTI_GGX"
            if node.distribution == "SHARP":
                inputs["roughness"] = 0.0
        if find_input(node, ("Specular",)) and inputs["transmission"] == 0.0:
            inputs["ior"] = _IOR_OF_OLD_SPECULAR
        for identifier in _IGNORED_WEIGHTS:
            socket = find_input(node, (identifier,))
            if socket and constant(socket) != 0.0:
                self.left_out.append(f"{node_label(node)} {identifier}")
        inputs.update(self._read_normal(node))
        return surface, inputs

    def _read_input(self, socket: bpy.types.NodeSocket, is_color: bool) -> object:
        """A number, a colour, an image or an attribute; else what is set on the socket itself."""
        value = constant(socket)
        if value is not None:
            return _as_color(value) if is_color else _as_number(value)
        output = source(socket)
        node = output.node
        channel = "ALPHA" if output.identifier == "Alpha" else "COLOR" if is_color else "LUMINANCE"
        if node.bl_idname == "ShaderNodeTexImage":
            return self._read_image(node, channel, is_color)
        if node.bl_idname == "ShaderNodeVertexColor":
            return core.require().AttributeInput(node.layer_name, channel=channel)
        self._leave_out(node, socket.name)
        return own_value(socket)

    def _read_image(self, node: bpy.types.Node, channel: str, is_color: bool) -> object:
        texture = None
        if node.image is None:
            self.left_out.append(f"{node_label(node)} without an image")
        else:
            texture = self._images.texture(node.image, node.extension, node.interpolation)
        if texture is None:
            return MISSING_COLOR if is_color else _as_number(MISSING_COLOR)
        if node.projection != "FLAT":
            self.left_out.append(f"{node.projection.title()} projection of {node_label(node)}")
        uv_layer = self._uv_layer(node.inputs["Vector"])
        return core.require().ImageInput(texture, uv_layer=uv_layer, channel=channel)

    def _uv_layer(self, vector: bpy.types.NodeSocket) -> str:
        """The UV map that a texture's Vector input names; "" is the mesh's active one."""
        output = source(vector)
        if output is None:
            return ""
        node = output.node
        if node.bl_idname == "ShaderNodeUVMap":
            return node.uv_map
        if node.bl_idname != "ShaderNodeTexCoord" or output.identifier != "UV":
            self._leave_out(node, vector.name)
        return ""

    def _read_normal(self, node: bpy.types.Node) -> dict[str, object]:
        socket = find_input(node, ("Normal",))
        normal = source_node(socket) if socket else None
        if normal is None:
            return {}
        image = strength = None
        if normal.bl_idname == "ShaderNodeNormalMap" and normal.space == "TANGENT":
            image = source_node(normal.inputs["Color"])
            strength = constant(normal.inputs["Strength"])
        is_image = image is not None and image.bl_idname == "ShaderNodeTexImage" and image.image
        if not is_image or strength is None:
            self._leave_out(normal, socket.name)
            return {}
        texture = self._images.texture(image.image, image.extension, image.interpolation)
        if texture is None:
            return {}
        uv_layer = normal.uv_map or self._uv_layer(image.inputs["Vector"])
        return {
            "normal_map": core.require().ImageInput(texture, uv_layer=uv_layer),
            "normal_strength": strength,
        }

    def _fallback_color(self, node: bpy.types.Node) -> object:
        """The base colour of an unsupported shader: its own, or that of a shader it mixes."""
        color = find_input(node, ("Base Color", "Color"))
        if color is not None:
            return self._read_input(color, is_color=True)
        for socket in node.inputs:
            mixed = source_node(socket) if socket.type == "SHADER" else None
            if mixed is not None:
                return self._fallback_color(mixed)
        return tuple(self._material.diffuse_color)[:3]


def _as_color(value: float | tuple[float, float, float]) -> tuple[float, float, float]:
    return value if isinstance(value, tuple) else (value, value, value)


def _as_number(value: float | tuple[float, float, float]) -> float:
    """A colour into a number, as Blender converts: its luminance."""
    if not isinstance(value, tuple):
        return value
    red, green, blue = value
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
