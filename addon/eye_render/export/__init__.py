"""The evaluated dependency graph to a scene of the core: one file for each kind of datablock."""

from collections.abc import Callable

import bpy

from .. import compat, core, passes
from ..cryptomatte import MatteNames
from ..working_space import working_space
from .image import ImageTable
from .instances import export_instances
from .light import LightTable
from .material import MaterialTable
from .motion import Motion
from .world import export_world

_OCCLUSION_DISTANCE_WITHOUT_WORLD = 10.0  # Blender units, as in Cycles


def export_scene(
    depsgraph: bpy.types.Depsgraph,
    warn: Callable[[str], None],
    check_cancel: Callable[[], None],
    motion: Motion | None = None,
) -> tuple[object, MatteNames]:
    """The core's scene of the depsgraph's view layer, without a camera, and the names in it.

    `warn` takes a sentence for the user; `check_cancel` raises to stop the export; `motion` is
    what was found while the shutter is open, if anybody looked.
    """
    core_scene = core.require().Scene(working_space=working_space(warn))
    images = ImageTable(core_scene, depsgraph.scene_eval.frame_current, warn)
    view_layer = depsgraph.view_layer_eval
    world = compat.world_of(depsgraph.scene_eval, view_layer)
    materials = MaterialTable(
        core_scene,
        images,
        view_layer.material_override,
        warn,
        passes.aovs(view_layer),
        occlusion_distance=(
            world.light_settings.distance if world else _OCCLUSION_DISTANCE_WITHOUT_WORLD
        ),
    )
    lights = LightTable(core_scene, images, warn)
    names = MatteNames(set(), materials.names, set())
    export_instances(core_scene, depsgraph, materials, lights, names, warn, check_cancel, motion)
    export_world(core_scene, depsgraph, images, warn)
    return core_scene, names
