"""Materials of one closure with constant inputs, for tests that ask for no more."""

import eyecore


def add_plain(scene: eyecore.Scene, name: str, kind: str, inputs: dict | None = None, **options):
    """The number of a material that is one node, its inputs by Blender's identifiers."""
    node = eyecore.NodeGraph().add(kind, inputs or {}, **options)
    (output,) = eyecore.NODE_TYPES[kind]["outputs"]
    return scene.add_material(name, node[output])


def add_light(scene: eyecore.Scene, name: str, radiance: float = 1.0, color=1.0) -> int:
    """A surface that shines evenly."""
    return add_plain(scene, name, "EMISSION", {"Color": color, "Strength": radiance})


def add_picture(scene: eyecore.Scene, name: str, texture: int) -> int:
    """A surface that shines as the texture says, laid out by the mesh's first UV layer."""
    graph = eyecore.NodeGraph()
    picture = graph.add("TEX_IMAGE", texture=texture)
    return scene.add_material(name, graph.add("EMISSION", {"Color": picture["Color"]})["Emission"])
