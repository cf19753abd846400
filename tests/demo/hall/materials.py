"""The hall's materials, each said once as a Look and built in one of two ways: `principled`, or
`basic` with one Diffuse, Glossy, Glass or Emission node each, for comparisons with a Cycles whose
Principled BSDF differs."""

from dataclasses import dataclass

import bpy

from . import textures


@dataclass
class Look:
    color: tuple[float, float, float] = (0.8, 0.8, 0.8)
    image: str = ""  # a function of textures.py; replaces the colour
    tile_m: float = 1.0  # what one repeat of the image covers
    normal_map: str = ""
    roughness: float = 0.6
    metallic: float = 0.0
    transmission: float = 0.0
    ior: float = 1.45
    emission: float = 0.0  # strength; the colour is `color`


LOOKS = {
    "floor": Look(image="floor", tile_m=2.0, roughness=0.2),
    "stone": Look(image="stone", tile_m=3.0, normal_map="stone_normal", roughness=0.75),
    "plaster": Look(image="plaster", tile_m=4.0, roughness=0.8),
    "marble": Look(color=(0.71, 0.66, 0.58), roughness=0.5),
    "cloth": Look(image="cloth", tile_m=2.0, roughness=0.9),
    "cloth blue": Look(color=(0.05, 0.10, 0.30), roughness=0.9),
    "wood": Look(color=(0.13, 0.06, 0.03), roughness=0.25),
    "grid": Look(image="grid", roughness=0.25),
    "paper": Look(color=(0.86, 0.86, 0.83), roughness=0.9),
    "ink": Look(color=(0.012, 0.012, 0.012), roughness=0.9),
    "iron": Look(color=(0.05, 0.05, 0.055), roughness=0.45),
    "bronze": Look(color=(0.72, 0.43, 0.20), roughness=0.22, metallic=1.0),
    "gold": Look(color=(0.95, 0.68, 0.28), roughness=0.12, metallic=1.0),
    "mirror": Look(color=(0.93, 0.93, 0.93), roughness=0.02, metallic=1.0),
    "glass": Look(color=(0.96, 0.99, 0.98), roughness=0.0, transmission=1.0, ior=1.5),
    "leaf": Look(color=(0.06, 0.17, 0.03), roughness=0.5),
    "lantern": Look(color=(1.0, 0.62, 0.28), emission=14.0),
    "ember": Look(color=(1.0, 0.30, 0.08), emission=5.0),
    "neon": Look(color=(0.15, 0.55, 1.0), emission=6.0),
}


def tile_m(material: bpy.types.Material) -> float:
    return LOOKS[material.name].tile_m


class Materials:
    """Makes each material and each image when it is first asked for."""

    def __init__(self, variant: str):
        self._build = {"principled": self._principled, "basic": self._basic}[variant]
        self._images = {}

    def __getitem__(self, name: str) -> bpy.types.Material:
        return bpy.data.materials.get(name) or self._make(name)

    def _make(self, name):
        material = bpy.data.materials.new(name)
        if material.node_tree is None:  # before Blender 5
            material.use_nodes = True
        tree = material.node_tree
        tree.nodes.clear()
        shader = self._build(tree, LOOKS[name])
        output = tree.nodes.new("ShaderNodeOutputMaterial")
        tree.links.new(shader.outputs[0], output.inputs["Surface"])
        return material

    def _texture(self, tree, image_name, socket):
        if image_name not in self._images:
            self._images[image_name] = getattr(textures, image_name)()
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = self._images[image_name]
        tree.links.new(node.outputs["Color"], socket)

    def _color(self, tree, look, socket):
        if look.image:
            self._texture(tree, look.image, socket)
        else:
            socket.default_value = (*look.color, 1)

    def _principled(self, tree, look):
        node = tree.nodes.new("ShaderNodeBsdfPrincipled")
        inputs = node.inputs
        self._color(tree, look, inputs["Base Color"])
        inputs["Roughness"].default_value = look.roughness
        inputs["Metallic"].default_value = look.metallic
        inputs["IOR"].default_value = look.ior
        _either(inputs, "Transmission Weight", "Transmission").default_value = look.transmission
        _either(inputs, "Emission Color", "Emission").default_value = (*look.color, 1)
        inputs["Emission Strength"].default_value = look.emission
        if look.normal_map:
            normal = tree.nodes.new("ShaderNodeNormalMap")
            self._texture(tree, look.normal_map, normal.inputs["Color"])
            tree.links.new(normal.outputs["Normal"], inputs["Normal"])
        return node

    def _basic(self, tree, look):
        if look.emission:
            node = tree.nodes.new("ShaderNodeEmission")
            node.inputs["Strength"].default_value = look.emission
        elif look.transmission:
            node = tree.nodes.new("ShaderNodeBsdfGlass")
            node.distribution = "GGX"
            node.inputs["IOR"].default_value = look.ior
            node.inputs["Roughness"].default_value = look.roughness
        elif look.metallic:
            node = _new_glossy(tree)
            node.distribution = "GGX"
            node.inputs["Roughness"].default_value = look.roughness
        else:
            node = tree.nodes.new("ShaderNodeBsdfDiffuse")
        self._color(tree, look, node.inputs["Color"])
        return node


def _either(inputs, new: str, old: str):
    """A Principled input by its name since Blender 4, or before."""
    return inputs[new] if new in inputs else inputs[old]


def _new_glossy(tree):
    try:
        return tree.nodes.new("ShaderNodeBsdfGlossy")
    except RuntimeError:
        return tree.nodes.new("ShaderNodeBsdfAnisotropic")  # Glossy since Blender 4
