"""Nodes of older and newer Blenders, as those of Blender 4.3.

The expected sockets and nodes are what Blender 4.3.2 made of the same nodes in a file that
Blender 3.4.1 had saved.
"""

from types import SimpleNamespace

import bpy
import pytest
from eye_render.export.nodes.flat import Input, Node
from eye_render.export.nodes.occlusion import look_as_far_as_the_world
from eye_render.export.nodes.versions import modernize

SOURCE = Node("TEX_NOISE", "Noise Texture").output("Color", "RGBA")


def number(value: float = 0.0, source=None) -> Input:
    return Input("VALUE", value, source)


def color(value=(0.0, 0.0, 0.0), source=None) -> Input:
    return Input("RGBA", value, source)


def principled(**changes: Input) -> Node:
    """That of Blender 3.4 with its defaults."""
    inputs = {
        "Base Color": color((0.5, 0.4, 0.3)),
        "Subsurface": number(0.0),
        "Subsurface Color": color((0.9, 0.1, 0.1)),
        "Metallic": number(0.0),
        "Specular": number(0.5),
        "Specular Tint": number(0.0),
        "Sheen": number(0.0),
        "Sheen Tint": number(0.5),
        "Clearcoat": number(0.0),
        "Clearcoat Roughness": number(0.03),
        "IOR": number(1.45),
        "Transmission": number(0.0),
        "Emission": color(),
        "Emission Strength": number(1.0),
    }
    node = Node("BSDF_PRINCIPLED", "Principled", {"subsurface_method": "RANDOM_WALK"})
    node.inputs = inputs | changes
    modernize(node)
    return node


def value_of(item: Input):
    """An input's value, with the Mix and Math nodes before it worked out."""
    if item.source is None:
        return item.value
    node = item.source.node
    if node.kind == "MIX":
        first, second = (value_of(node.inputs[name]) for name in ("A_Color", "B_Color"))
        factor = value_of(node.inputs["Factor_Float"])
        return tuple(a + (b - a) * factor for a, b in zip(first, second, strict=True))
    first, second = (value_of(node.inputs[name]) for name in ("Value", "Value_001"))
    result = {
        "ADD": lambda: first + second,
        "SUBTRACT": lambda: first - second,
        "MULTIPLY": lambda: first * second,
        "POWER": lambda: first**second,
        "MINIMUM": lambda: min(first, second),
        "MAXIMUM": lambda: max(first, second),
        "GREATER_THAN": lambda: float(first > second),
    }[node.options["operation"]]()
    return min(max(result, 0.0), 1.0) if node.options["use_clamp"] else result


def approx(value):
    return pytest.approx(value, abs=1e-5)


def test_principled_sockets_have_their_new_names():
    inputs = principled().inputs
    assert inputs["Specular IOR Level"].value == 0.5
    assert inputs["Transmission Weight"].value == 0.0
    assert inputs["Coat Roughness"].value == 0.03
    assert inputs["Emission Color"].value == (0.0, 0.0, 0.0)
    assert inputs["IOR"].value == 1.45
    assert inputs["Specular Tint"] == color((1.0, 1.0, 1.0))
    assert not {"Specular", "Subsurface Color", "Clearcoat", "Emission"} & inputs.keys()


def test_a_fixed_coat_is_a_quarter_as_strong():
    inputs = principled(Clearcoat=number(0.8)).inputs
    assert inputs["Coat Weight"].value == approx(0.2)
    assert "Coat IOR" not in inputs


def test_a_linked_coat_has_a_lower_index():
    inputs = principled(Clearcoat=number(0.8, SOURCE)).inputs
    assert inputs["Coat Weight"].source == SOURCE
    assert inputs["Coat IOR"].value == 1.2


def test_a_fixed_sheen_is_a_fifth_as_strong_and_white():
    inputs = principled(Sheen=number(0.6)).inputs
    assert inputs["Sheen Weight"].value == approx(0.12)
    assert inputs["Sheen Tint"] == color((1.0, 1.0, 1.0))


def test_a_linked_sheen_is_dimmed_by_its_tint():
    inputs = principled(Sheen=number(0.6, SOURCE)).inputs
    assert inputs["Sheen Weight"].source == SOURCE
    assert inputs["Sheen Tint"] == color((0.2, 0.2, 0.2))


def test_without_subsurface_the_base_colour_stays():
    inputs = principled().inputs
    assert inputs["Base Color"] == color((0.5, 0.4, 0.3))
    assert inputs["Subsurface Weight"].value == 0.0
    assert "Subsurface Scale" not in inputs


def test_subsurface_becomes_the_scale_and_mixes_the_colours():
    inputs = principled(Subsurface=number(0.25)).inputs
    assert value_of(inputs["Base Color"]) == approx((0.6, 0.325, 0.25))
    assert inputs["Subsurface Weight"].value == 1.0
    assert inputs["Subsurface Scale"].value == 0.25


def test_a_linked_subsurface_is_the_scale():
    inputs = principled(Subsurface=number(0.0, SOURCE)).inputs
    assert inputs["Subsurface Scale"].source == SOURCE
    assert inputs["Subsurface Weight"] == number(1.0)


def test_specular_tint_is_a_colour_between_white_and_the_base():
    changes = {"Specular Tint": number(0.25), "Metallic": number(0.25)}
    tint = value_of(principled(**changes).inputs["Specular Tint"])
    assert tint == approx((0.90625, 0.8875, 0.86875))


def test_specular_tint_is_of_the_colour_that_subsurface_mixed():
    changes = {
        "Specular Tint": number(0.5),
        "Metallic": number(0.5),
        "Subsurface": number(0.25),
    }
    tint = value_of(principled(**changes).inputs["Specular Tint"])
    assert tint == approx((0.9, 0.83125, 0.8125))


@pytest.mark.parametrize(
    ("old", "new"),
    [("RANDOM_WALK", "RANDOM_WALK_SKIN"), ("RANDOM_WALK_FIXED_RADIUS", "RANDOM_WALK_LEGACY")],
)
def test_random_walks_have_their_new_names(old, new):
    node = Node("BSDF_PRINCIPLED", "", {"subsurface_method": old})
    node.inputs = principled().inputs | {
        "Subsurface": number(),
        "Subsurface Color": color(),
    }
    modernize(node)
    scattering = Node("SUBSURFACE_SCATTERING", "", {"falloff": old})
    modernize(scattering)
    assert (node.options["subsurface_method"], scattering.options["falloff"]) == (new, new)


def test_the_principled_of_blender_4_stays_as_it_is():
    node = Node("BSDF_PRINCIPLED", "", {"subsurface_method": "RANDOM_WALK_SKIN"})
    node.inputs = {"Specular IOR Level": number(0.5), "Specular Tint": color((1, 0, 0))}
    before = dict(node.inputs)
    modernize(node)
    assert (node.inputs, node.options["subsurface_method"]) == (before, "RANDOM_WALK_SKIN")


def test_a_random_walk_is_that_of_this_blender():
    node = Node("SUBSURFACE_SCATTERING", "", {"falloff": "RANDOM_WALK"})
    node.inputs = {"Roughness": number(1.0)}
    modernize(node)
    expected = "RANDOM_WALK_LEGACY" if bpy.app.version < (5, 2, 0) else "RANDOM_WALK"
    assert node.options["falloff"] == expected


@pytest.mark.parametrize("kind", ["BSDF_GLOSSY", "BSDF_GLASS", "BSDF_REFRACTION"])
def test_sharp_is_without_roughness(kind):
    node = Node(kind, "", {"distribution": "SHARP"}, {"Roughness": number(0.5, SOURCE)})
    modernize(node)
    assert node.options["distribution"] == "GGX"
    assert node.inputs["Roughness"] == number(0.0)


def test_velvet_is_a_sheen():
    node = Node("BSDF_VELVET", "", {}, {"Sigma": number(0.5)})
    modernize(node)
    assert (node.kind, node.options) == ("BSDF_SHEEN", {"distribution": "ASHIKHMIN"})
    assert node.inputs == {"Roughness": number(0.5)}


def test_anisotropic_is_glossy():
    node = Node("BSDF_ANISOTROPIC", "", {"distribution": "GGX"}, {"Anisotropy": number(0.5)})
    modernize(node)
    assert (node.kind, node.inputs["Anisotropy"].value) == ("BSDF_GLOSSY", 0.5)


def musgrave(kind: str, detail: Input) -> SimpleNamespace:
    """Kind and worked-out inputs of the noise, and what its output is multiplied by and added."""
    node = Node("TEX_MUSGRAVE", "Musgrave", {"musgrave_type": kind, "musgrave_dimensions": "2D"})
    node.inputs = {
        "Detail": detail,
        "Dimension": number(1.5),
        "Lacunarity": number(3.0),
        "Scale": number(5.0),
    }
    modernize(node)
    factor, addend, noise = 1.0, 0.0, node
    if node.kind == "MATH" and node.options["operation"] == "ADD":
        addend, noise = value_of(node.inputs["Value_001"]), node.inputs["Value"].source.node
    if noise.kind == "MATH":
        factor, noise = value_of(noise.inputs["Value_001"]), noise.inputs["Value"].source.node
    inputs = {name: value_of(item) for name, item in noise.inputs.items()}
    return SimpleNamespace(
        kind=noise.kind, options=noise.options, factor=factor, addend=addend, inputs=inputs
    )


MUSGRAVES = ["MULTIFRACTAL", "RIDGED_MULTIFRACTAL", "HYBRID_MULTIFRACTAL", "FBM", "HETERO_TERRAIN"]
FADED = {"MULTIFRACTAL", "HYBRID_MULTIFRACTAL", "FBM"}


@pytest.mark.parametrize("kind", MUSGRAVES)
def test_musgrave_is_a_noise_that_counts_octaves_and_weights_otherwise(kind):
    noise = musgrave(kind, number(2.0))
    assert noise.kind == "TEX_NOISE"
    assert noise.options["noise_type"] == kind
    assert noise.options["noise_dimensions"] == "2D"
    assert noise.options["normalize"] is False
    assert "musgrave_type" not in noise.options
    assert noise.inputs["Detail"] == 1.0
    assert noise.inputs["Roughness"] == approx(0.19245)
    assert noise.inputs["Lacunarity"] == 3.0
    assert (noise.factor, noise.addend) == (1.0, 0.0)


@pytest.mark.parametrize("kind", MUSGRAVES)
def test_musgrave_with_half_an_octave_is_half_as_high(kind):
    noise = musgrave(kind, number(0.5))
    assert noise.factor == (0.5 if kind in FADED else 1.0)
    assert noise.addend == (0.5 if kind == "MULTIFRACTAL" else 0.0)
    assert max(noise.inputs["Detail"], 0.0) == (0.0 if kind in FADED else 0.5)


def test_musgrave_has_fifteen_octaves_at_most():
    assert musgrave("FBM", number(20.0)).inputs["Detail"] == 14.0


def test_others_read_a_faded_musgrave_from_what_fades_it():
    node = Node("TEX_MUSGRAVE", "", {"musgrave_type": "FBM", "musgrave_dimensions": "3D"})
    node.inputs = {"Detail": number(0.5), "Dimension": number(2), "Lacunarity": number(2)}
    modernize(node)
    assert (node.kind, node.renamed_outputs) == ("MATH", {"Fac": "Value"})


def test_a_directx_normal_map_has_its_green_turned_over():
    node = Node("NORMAL_MAP", "", {"convention": "DIRECTX"}, {"Color": color((0.5, 0.2, 1.0))})
    modernize(node)
    flip = node.inputs["Color"].source.node
    assert flip.options["operation"] == "MULTIPLY_ADD"
    given, factor, addend = (
        flip.inputs[name].value for name in ("Vector", "Vector_001", "Vector_002")
    )
    flipped = [g * f + a for g, f, a in zip(given, factor, addend, strict=True)]
    assert flipped == approx([0.5, 0.8, 1.0])


def test_a_sky_of_blender_5_says_dust_and_names_what_it_loses():
    node = Node("TEX_SKY", "", {"sky_type": "MULTIPLE_SCATTERING", "aerosol_density": 2.0})
    modernize(node)
    assert node.options == {"sky_type": "SINGLE_SCATTERING", "dust_density": 2.0}
    assert len(node.notes) == 1


@pytest.mark.parametrize(("owner", "prefix"), [("OBJECT", "object"), ("INSTANCER", "instancer")])
def test_an_attribute_of_an_owner_is_read_under_a_name_of_its_own(owner, prefix):
    node = Node("ATTRIBUTE", "Tone", {"attribute_type": owner, "attribute_name": "tone"})
    modernize(node)
    assert node.options == {"attribute_name": f".eye_render.{prefix}.tone"}
    layer = Node("ATTRIBUTE", "Tone", {"attribute_type": "GEOMETRY", "attribute_name": "tone"})
    modernize(layer)
    assert layer.options["attribute_name"] == "tone"


@pytest.mark.parametrize(
    ("distance", "source", "looked"), [(0.0, None, 7.0), (1.0, None, 1.0), (0.0, SOURCE, 0.0)]
)
def test_occlusion_of_no_distance_looks_as_far_as_the_world_says(distance, source, looked):
    node = Node("AMBIENT_OCCLUSION", "Ambient Occlusion")
    node.inputs["Distance"] = number(distance, source)
    look_as_far_as_the_world(node, 7.0)
    assert node.inputs["Distance"].value == looked


@pytest.mark.parametrize(("model", "notes"), [("CHIANG", 0), ("HUANG", 1)])
def test_of_hair_only_the_elliptical_fibre_is_named(model, notes):
    node = Node("BSDF_HAIR_PRINCIPLED", "Hair", {"model": model}, changed={"model"})
    node.inputs["Roughness"] = number(0.3)
    modernize(node)
    assert len(node.notes) == notes
    assert not node.changed
