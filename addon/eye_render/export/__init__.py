"""The evaluated dependency graph to a scene of the core: one file for each kind of datablock."""

from collections.abc import Callable

import bpy

from .. import core
from .image import ImageTable
from .instances import export_instances
from .light import LightTable
from .material import MaterialTable
from .world import export_world


def export_scene(
    depsgraph: bpy.types.Depsgraph,
    warn: Callable[[str], None],
    check_cancel: Callable[[], None],
):
    """The core's scene of the depsgraph's view layer, without a camera.

    `warn` takes a sentence for the user; `check_cancel` raises to stop the export.
    """
    core_scene = core.require().Scene()
    images = ImageTable(core_scene, depsgraph.scene_eval.frame_current, warn)
    materials = MaterialTable(
        core_scene, images, depsgraph.view_layer_eval.material_override, warn
    )
    lights = LightTable(core_scene, images, warn)
    export_instances(core_scene, depsgraph, materials, lights, warn, check_cancel)
    export_world(core_scene, depsgraph, images, warn)
    return core_scene
