"""Materials: the tree at the active output as a graph of the core, each once."""

from collections.abc import Callable, Mapping
from typing import NamedTuple

import bpy

from .. import compat, core
from .image import ImageTable
from .nodes import DIFFUSE, aov_sockets, export_sockets
from .object_properties import is_of_owner

# Nodes by which one object looks other than the next with the same material.
_OBJECT_READERS = {"OBJECT_INFO"}
# What Cryptomatte calls the material of what has none, as in Cycles.
_NAME_OF_NONE = "default_surface"


class _Look(NamedTuple):
    surface: object | None  # sockets of one graph of the core; None is black or, around a volume,
    displacement: object | None  # clear
    volume: object | None
    kinds: frozenset[str]
    left_out: list[str]
    aovs: Mapping[str, object] = {}  # sockets of the same graph


class MaterialTable:
    """The materials of one core scene, each added once, when something first wears it."""

    def __init__(
        self,
        core_scene,
        images: ImageTable,
        override: bpy.types.Material | None,
        warn: Callable[[str], None],
        aovs: Mapping[str, str] | None = None,
        occlusion_distance: float = 0.0,  # the world's
    ):
        self._core_scene = core_scene
        self._images = images
        self._override = override
        self._warn = warn
        self._aovs = aovs or {}  # what materials are asked to write out: VALUE or COLOR by name
        self._occlusion_distance = occlusion_distance
        self.names: set[str] = set()  # of the materials added
        self._ids: dict[str, int] = {}
        self._object_readers: set[int] = set()

    def worn_by(self, shown: bpy.types.Object) -> tuple[int, ...]:
        """The materials in the object's slots, linked to object or data; at least one."""
        slots = shown.material_slots
        return tuple(self._id(slot.material) for slot in slots) or (self._id(None),)

    def read_object(self, worn: tuple[int, ...]) -> bool:
        """Whether one of the materials asks which object wears it."""
        return not self._object_readers.isdisjoint(worn)

    def properties_read(self, worn: tuple[int, ...]) -> list[str]:
        """The properties that one of the materials asks for by an attribute's name."""
        return list(filter(is_of_owner, self._core_scene.attributes_read(worn)))

    def _id(self, material: bpy.types.Material | None) -> int:
        material = self._override or material
        name = material.name_full if material else ""
        if name not in self._ids:
            self._ids[name] = self._add(material) if material else self._add_grey()
        return self._ids[name]

    def _add(self, material: bpy.types.Material) -> int:
        look = _read(material, self._images, self._aovs, self._occlusion_distance)
        index = material.pass_index
        name = material.name  # in Cryptomatte without the library, as in Cycles
        self.names.add(name)
        left_out = look.left_out
        try:
            number = self._core_scene.add_material(
                name,
                look.surface,
                look.displacement,
                look.volume,
                pass_index=index,
                aovs=look.aovs,
            )
        except ValueError as error:  # what the core sees only when all nodes are together
            left_out = [*left_out, str(error)]
            number = self._core_scene.add_material(
                name, _plain(material).surface, pass_index=index
            )
        if left_out:
            self._warn(f"Material '{material.name}': not supported: {', '.join(left_out)}")
        if not look.kinds.isdisjoint(_OBJECT_READERS):
            self._object_readers.add(number)
        return number

    def _add_grey(self) -> int:
        self.names.add(_NAME_OF_NONE)
        diffuse = core.require().NodeGraph().add("BSDF_DIFFUSE")
        return self._core_scene.add_material(_NAME_OF_NONE, diffuse["BSDF"])


def _read(
    material: bpy.types.Material,
    images: ImageTable,
    aovs: Mapping[str, str],
    occlusion_distance: float,
) -> _Look:
    if not compat.uses_nodes(material):
        return _plain(material)
    inlined = compat.inline_shader_nodes(material)
    output = inlined.node_tree.get_output_node("CYCLES")
    if output is None:
        return _Look(None, None, None, frozenset(), [])
    sockets = (output.inputs[name] for name in ("Surface", "Displacement", "Volume"))
    written = aov_sockets(inlined.node_tree, aovs)
    tree = export_sockets(sockets, images, DIFFUSE, written, occlusion_distance)
    surface, displacement, volume = tree.sockets
    if surface is not None and not compat.has_transparent_shadow(material):
        surface = _opaque_to_shadow_rays(tree.graph, surface)
    left_out = list(tree.left_out)
    if displacement is not None and compat.displacement_method(material) != "BUMP":
        left_out.append("displacement of the surface itself (it is shown as bump)")
    return _Look(surface, displacement, volume, tree.kinds, left_out, tree.values)


def _opaque_to_shadow_rays(graph, surface: object) -> object:
    black = graph.add("BSDF_DIFFUSE", {"Color": (0.0, 0.0, 0.0)})
    is_shadow = graph.add("LIGHT_PATH")["Is Shadow Ray"]
    mix = graph.add(
        "MIX_SHADER", {"Fac": is_shadow, "Shader": surface, "Shader_001": black["BSDF"]}
    )
    return mix["Shader"]


def _plain(material: bpy.types.Material) -> _Look:
    """What Cycles makes of a material without nodes."""
    color = tuple(material.diffuse_color)[:3]
    diffuse = core.require().NodeGraph().add("BSDF_DIFFUSE", {"Color": color})
    return _Look(diffuse["BSDF"], None, None, frozenset(), [])
