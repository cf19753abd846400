"""Nodes of other Blenders as those of Blender 4.3, which the core speaks.

What is done to a node is what Blender 4.3 does when it opens a file of Blender 3.4, and for nodes
of Blender 5 the reverse; only random walks go by the names of Blender 5.2. A difference is a row
of data; only where a meaning changed does it have a function.
"""

from collections.abc import Callable, Mapping
from typing import NamedTuple

from ... import compat
from .derived import read_derived_attributes
from .flat import Input, Node
from .hair import LOBES, chiang_fibre, mix_lobes, round_fibre
from .musgrave import musgrave_to_noise
from .named import OWNER_PREFIXES, name_owner, name_particle, name_place
from .normals import flip_green
from .principled import (
    RENAMED_INPUTS,
    color_specular_tint,
    weaken_coat,
    weaken_sheen,
    widen_subsurface,
)


class Row(NamedTuple):
    """One difference: which nodes have it, and what is done to them."""

    kind: str
    with_input: str = ""
    without_input: str = ""
    with_option: tuple[str, object] | None = None  # name, value

    new_kind: str = ""
    inputs: Mapping[str, str] = {}  # old identifier: new identifier
    options: Mapping[str, str] = {}  # old name: new name
    set_options: Mapping[str, object] = {}
    set_inputs: Mapping[str, float] = {}
    set_outputs: Mapping[str, float] = {}  # they always have these values
    convert: Callable[[Node], None] | None = None
    note: str = ""  # what of it is not shown

    def matches(self, node: Node) -> bool:
        return (
            node.kind == self.kind
            and (not self.with_input or self.with_input in node.inputs)
            and (not self.without_input or self.without_input not in node.inputs)
            and (self.with_option is None or self.with_option in node.options.items())
        )

    def apply(self, node: Node) -> None:
        node.kind = self.new_kind or node.kind
        if self.convert:
            self.convert(node)
        node.inputs = {self.inputs.get(name, name): item for name, item in node.inputs.items()}
        node.options = {self.options.get(name, name): item for name, item in node.options.items()}
        node.options |= self.set_options
        node.inputs |= {name: Input("VALUE", value) for name, value in self.set_inputs.items()}
        node.constant_outputs |= self.set_outputs
        if self.note:
            node.notes.append(self.note)


def _sharp(kind: str) -> Row:
    return Row(
        kind,
        with_option=("distribution", "SHARP"),
        set_options={"distribution": "GGX"},
        set_inputs={"Roughness": 0.0},
    )


_OLD_WALKS = {
    "RANDOM_WALK": "RANDOM_WALK_SKIN",
    "RANDOM_WALK_FIXED_RADIUS": "RANDOM_WALK_LEGACY",
}

_WALKERS = {"BSDF_PRINCIPLED": "subsurface_method", "SUBSURFACE_SCATTERING": "falloff"}


def _walk(kind: str, option: str, old: str, new: str, **form: str) -> Row:
    return Row(kind, with_option=(option, old), set_options={option: new}, **form)


# In this order; what a row makes, a later one may meet.
ROWS = (
    # Blender 3
    Row("BSDF_ANISOTROPIC", new_kind="BSDF_GLOSSY"),
    Row(
        "BSDF_VELVET",
        new_kind="BSDF_SHEEN",
        inputs={"Sigma": "Roughness"},
        set_options={"distribution": "ASHIKHMIN"},
    ),
    _sharp("BSDF_GLOSSY"),
    _sharp("BSDF_GLASS"),
    _sharp("BSDF_REFRACTION"),
    Row("TEX_MUSGRAVE", convert=musgrave_to_noise),
    *(
        _walk("BSDF_PRINCIPLED", "subsurface_method", old, new, with_input="Subsurface")
        for old, new in _OLD_WALKS.items()
    ),
    *(
        _walk("SUBSURFACE_SCATTERING", "falloff", old, new, without_input="Roughness")
        for old, new in _OLD_WALKS.items()
    ),
    *(
        _walk(kind, option, "RANDOM_WALK", "RANDOM_WALK_LEGACY")
        for kind, option in _WALKERS.items()
        if compat.RANDOM_WALK_IS_LEGACY
    ),
    *(
        Row(kind, set_options={"always_walks": True})
        for kind in _WALKERS
        if not compat.RANDOM_WALK_IS_LEGACY
    ),
    Row("BSDF_PRINCIPLED", with_input="Subsurface", convert=widen_subsurface),
    Row("BSDF_PRINCIPLED", with_input="Sheen", convert=weaken_sheen),
    Row("BSDF_PRINCIPLED", with_input="Clearcoat", convert=weaken_coat),
    Row("BSDF_PRINCIPLED", with_input="Specular", convert=color_specular_tint),
    Row("BSDF_PRINCIPLED", with_input="Specular", inputs=RENAMED_INPUTS),
    # What the core has in another form, or something close to
    Row("NEW_GEOMETRY", convert=read_derived_attributes),
    *(
        Row("ATTRIBUTE", with_option=("attribute_type", owner), convert=name_owner)
        for owner in OWNER_PREFIXES
    ),
    Row("PARTICLE_INFO", convert=name_particle),
    Row("TEX_COORD", with_option=("from_instancer", True), convert=name_place),
    Row("UVMAP", with_option=("from_instancer", True), convert=name_place),
    Row("BSDF_HAIR", convert=mix_lobes, note=LOBES),
    Row("BSDF_HAIR_PRINCIPLED", with_option=("model", "CHIANG"), convert=chiang_fibre),
    Row(
        "BSDF_HAIR_PRINCIPLED",
        with_option=("model", "HUANG"),
        convert=round_fibre,
        note="the elliptical fibre (Chiang's round one stands in) of",
    ),
    # Blender 5
    Row("TEX_SKY", options={"aerosol_density": "dust_density"}),
    Row(
        "TEX_SKY",
        with_option=("sky_type", "MULTIPLE_SCATTERING"),
        set_options={"sky_type": "SINGLE_SCATTERING"},
        note="light scattered more than once in",
    ),
    Row("LIGHT_PATH", set_outputs={"Portal Depth": 0.0}),
    Row("NORMAL_MAP", with_option=("convention", "DIRECTX"), convert=flip_green),
)


def modernize(node: Node) -> None:
    for row in ROWS:
        if row.matches(node):
            row.apply(node)
