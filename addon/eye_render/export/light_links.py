"""Light linking: what a lamp or a shining object lights, and what throws its shadows, as numbers
of the core: classes of objects that the same lights light, and sets of objects that block."""

from collections.abc import Callable
from typing import NamedTuple

import bpy

from .. import compat

MAX_CLASSES, MAX_BLOCKER_SETS = 64, 20
_ALL_CLASSES = (1 << MAX_CLASSES) - 1


class Links(NamedTuple):
    """Of a light; keywords of the core."""

    lit_classes: int = _ALL_CLASSES
    blocker_set: int = 0


class Linked(NamedTuple):
    """Of an object; keywords of the core."""

    light_class: int = 0
    blocker_sets: int = 0


class _Rule:
    """What a collection says of objects by their address."""

    def __init__(self, collection: bpy.types.Collection):
        self._said: dict[int, bool] = {}
        children = zip(collection.children, collection.collection_children, strict=True)
        for child, entry in children:
            self._say(child.all_objects, entry)
        for shown, entry in zip(collection.objects, collection.collection_objects, strict=True):
            self._say([shown], entry)
        # What is not in the collection is meant if the collection only excludes.
        self._others = not any(self._said.values())

    def _say(self, objects, entry) -> None:
        is_included = entry.light_linking.link_state == "INCLUDE"
        for shown in objects:
            self._said[shown.as_pointer()] = is_included

    def mentions(self, address: int) -> bool:
        return address in self._said

    def means(self, address: int) -> bool:
        return self._said.get(address, self._others)


class LightLinks:
    def __init__(self, depsgraph: bpy.types.Depsgraph, warn: Callable[[str], None]):
        self._receivers: dict[int, _Rule] = {}  # by the collection's address
        self._blockers: dict[int, _Rule] = {}
        for found in depsgraph.ids:
            if isinstance(found, bpy.types.Object):
                rules = (self._receivers, self._blockers)
                collections = compat.linked_collections(found.original)
                for known, collection in zip(rules, collections, strict=True):
                    if collection is not None and collection.as_pointer() not in known:
                        known[collection.as_pointer()] = _Rule(collection)
        self._classes: dict[tuple[bool, ...], int] = {self._signature(0): 0}
        self._is_full = False
        if self._receivers:
            for found in depsgraph.ids:
                if isinstance(found, bpy.types.Object):
                    self._number(self._signature(found.original.as_pointer()))
        if self._is_full or len(self._blockers) > MAX_BLOCKER_SETS:
            warn(
                f"Light linking: only {MAX_CLASSES} kinds of receivers and {MAX_BLOCKER_SETS} "
                "collections of blockers are told apart"
            )

    def of_light(self, shown: bpy.types.Object) -> Links:
        receivers, blockers = compat.linked_collections(shown.original)
        lit, blocker_set = _ALL_CLASSES, 0
        if receivers is not None:
            number = list(self._receivers).index(receivers.as_pointer())
            lit = sum(1 << klass for said, klass in self._classes.items() if said[number])
        if blockers is not None:
            number = list(self._blockers).index(blockers.as_pointer()) + 1
            blocker_set = number if number <= MAX_BLOCKER_SETS else 0
        return Links(lit, blocker_set)

    def of_object(self, shown: bpy.types.Object, placer: bpy.types.Object) -> Linked:
        """The one that instances it (else itself) counts, if a collection mentions it."""
        if not self._receivers and not self._blockers:
            return Linked()
        rules = (*self._receivers.values(), *self._blockers.values())
        address = placer.original.as_pointer()
        if not any(rule.mentions(address) for rule in rules):
            address = shown.original.as_pointer()
        blockers = list(self._blockers.values())[:MAX_BLOCKER_SETS]
        sets = sum(1 << number for number, rule in enumerate(blockers) if rule.means(address))
        return Linked(self._classes.get(self._signature(address), 0), sets)

    def _signature(self, address: int) -> tuple[bool, ...]:
        """By which collections of receivers the object is meant."""
        return tuple(rule.means(address) for rule in self._receivers.values())

    def _number(self, signature: tuple[bool, ...]) -> None:
        if len(self._classes) < MAX_CLASSES:
            self._classes.setdefault(signature, len(self._classes))
        elif signature not in self._classes:
            self._is_full = True
