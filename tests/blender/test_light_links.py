"""Light linking, told to the core as classes of receivers and sets of blockers."""

from types import SimpleNamespace

import bpy
import pytest
from eye_render import compat
from eye_render.export.light_links import LightLinks
from scenes import add_object
from tools.meshes import cube_mesh


def entry(is_included: bool) -> SimpleNamespace:
    state = "INCLUDE" if is_included else "EXCLUDE"
    return SimpleNamespace(light_linking=SimpleNamespace(link_state=state))


def collection(objects: dict[bpy.types.Object, bool], children: dict = None) -> SimpleNamespace:
    """Stands for a collection of Blender 4; those before have no states in theirs."""
    children = children or {}
    made = SimpleNamespace(
        objects=list(objects),
        collection_objects=[entry(state) for state in objects.values()],
        children=[SimpleNamespace(all_objects=inner) for inner in children],
        collection_children=[entry(state) for state in children.values()],
    )
    made.as_pointer = lambda: id(made)
    return made


@pytest.fixture
def linked(scene, depsgraph_of, monkeypatch):
    """Makes a lamp and objects of those names, and links the lamp to what `choose` makes of
    these; gives the links and all objects by name."""

    def run(choose, names=("a", "b", "c")):
        objects = {name: add_object(cube_mesh(), name) for name in names}
        objects["lamp"] = add_object(bpy.data.lights.new("Lamp", "POINT"), "lamp")
        receivers, blockers = choose(objects)
        monkeypatch.setattr(
            compat,
            "linked_collections",
            lambda shown: (receivers, blockers) if shown.name == "lamp" else (None, None),
        )
        warnings = []
        links = LightLinks(depsgraph_of(), warnings.append)
        assert warnings == []
        return links, objects

    return run


def lit(links: LightLinks, objects: dict, name: str) -> bool:
    classes = links.of_light(objects["lamp"]).lit_classes
    return bool(classes >> links.of_object(objects[name], objects[name]).light_class & 1)


def blocks(links: LightLinks, objects: dict, name: str) -> bool:
    number = links.of_light(objects["lamp"]).blocker_set
    return bool(links.of_object(objects[name], objects[name]).blocker_sets >> (number - 1) & 1)


def test_without_links_everything_is_lit_and_blocks(linked):
    links, objects = linked(lambda objects: (None, None))
    assert links.of_light(objects["lamp"]) == (2**64 - 1, 0)
    assert links.of_object(objects["a"], objects["a"]) == (0, 0)


def test_what_is_included_is_lit_alone(linked):
    links, objects = linked(lambda objects: (collection({objects["a"]: True}), None))
    assert [lit(links, objects, name) for name in "abc"] == [True, False, False]


def test_what_is_excluded_alone_is_not_lit(linked):
    links, objects = linked(lambda objects: (collection({objects["a"]: False}), None))
    assert [lit(links, objects, name) for name in "abc"] == [False, True, True]


def test_a_collection_within_speaks_for_its_objects(linked):
    links, objects = linked(
        lambda objects: (collection({objects["a"]: True}, {(objects["b"],): True}), None)
    )
    assert [lit(links, objects, name) for name in "abc"] == [True, True, False]


def test_blockers_are_a_set_of_their_own(linked):
    links, objects = linked(lambda objects: (None, collection({objects["b"]: True})))
    assert links.of_light(objects["lamp"]) == (2**64 - 1, 1)
    assert [blocks(links, objects, name) for name in "abc"] == [False, True, False]


def test_what_instances_an_object_speaks_for_it(linked):
    links, objects = linked(lambda objects: (collection({objects["a"]: True}), None))
    of_instance = links.of_object(objects["c"], objects["a"])
    assert of_instance == links.of_object(objects["a"], objects["a"])


def test_blender_has_links_from_4_on(scene):
    lamp = add_object(bpy.data.lights.new("Lamp", "POINT"))
    assert compat.linked_collections(lamp) == (None, None)
    if bpy.app.version >= (4, 0, 0):
        lamp.light_linking.receiver_collection = bpy.data.collections.new("Receivers")
        receivers, blockers = compat.linked_collections(lamp)
        assert (receivers.name, blockers) == ("Receivers", None)
