"""Properties of an object, of what instances it or of the view layer that Attribute nodes read by
name: custom ones, else Blender's own. And those of the particle that places it, and of the place
itself."""

from collections.abc import Callable, Iterable

import bpy
import numpy as np

from .. import compat
from .nodes import OWNER_PREFIXES, PARTICLE_PREFIX, PLACE_PREFIX
from .particles import particle_value


def is_of_owner(attribute: str) -> bool:
    return attribute.startswith((PARTICLE_PREFIX, PLACE_PREFIX, *OWNER_PREFIXES.values()))


class PropertyReader:
    """Values, as four numbers, of the attributes that `is_of_owner`."""

    def __init__(self, depsgraph: bpy.types.Depsgraph, warn: Callable[[str], None]):
        self._warn = warn
        scene, layer = depsgraph.scene_eval, depsgraph.view_layer_eval
        self._of_layer = [layer, scene, compat.world_of(scene, layer)]
        self._frame = scene.frame_current_final

    def value(
        self, instance: bpy.types.DepsgraphObjectInstance, attribute: str
    ) -> tuple[float, ...]:
        if attribute.startswith(PARTICLE_PREFIX):
            output = attribute.removeprefix(PARTICLE_PREFIX)
            return _rgba(particle_value(instance, output, self._frame)) or _NOTHING
        if attribute.startswith(PLACE_PREFIX):
            return _rgba(_place(instance, attribute.removeprefix(PLACE_PREFIX))) or _NOTHING
        owner, prefix = next(
            item for item in OWNER_PREFIXES.items() if attribute.startswith(item[1])
        )
        name = attribute.removeprefix(prefix)
        if owner == "VIEW_LAYER":
            return _find(self._of_layer, name) or _NOTHING
        owners = [instance.object, instance.object.data]
        if owner == "INSTANCER" and instance.is_instance:
            owners.insert(0, instance.parent)
        found = _find(owners, name)
        if found is None and owner == "INSTANCER" and _has_geometry_nodes(instance):
            self._warn(
                f"Attribute '{name}' of the instances that '{instance.parent.name}' makes is 0: "
                "what geometry nodes give to instances is not read"
            )
        return found or _NOTHING


def _place(instance: bpy.types.DepsgraphObjectInstance, coordinate: str) -> Iterable[float]:
    """Generated or UV of the instancer's surface where it places the instance, as Cycles reads
    them; zeros of what nothing places."""
    if not instance.is_instance:
        return (0.0, 0.0, 0.0)
    if coordinate == "UV":
        return (*instance.uv, 0.0)
    return [0.5 * number - 0.5 for number in instance.orco]


def _has_geometry_nodes(instance: bpy.types.DepsgraphObjectInstance) -> bool:
    return instance.is_instance and any(m.type == "NODES" for m in instance.parent.modifiers)


_NOTHING = (0.0,) * 4


def _find(owners: Iterable[object], name: str) -> tuple[float, ...] | None:
    """What the first owner that has the property says."""
    for owner in owners:
        value = None if owner is None else _rgba(_look_up(owner, name))
        if value is not None:
            return value
    return None


def _look_up(owner: object, name: str) -> object | None:
    value = owner.get(name)
    if value is not None:
        return value
    try:
        return owner.path_resolve(name)
    except ValueError:
        return None


def _rgba(value: object) -> tuple[float, ...] | None:
    """One number fills all colours, what is missing of a vector is 0 and of alpha 1; None for what
    is not numbers."""
    try:
        numbers = np.array(value, np.float32).ravel()
    except (TypeError, ValueError):
        return None
    if not 1 <= len(numbers) <= 4 or not np.isfinite(numbers).all():
        return None
    rgba = np.array((0.0, 0.0, 0.0, 1.0), np.float32)
    rgba[: 3 if len(numbers) == 1 else len(numbers)] = numbers
    return tuple(rgba.tolist())
