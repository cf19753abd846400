"""Property groups: the observer of a camera, the rendering of a scene, the view layer's passes."""

import bpy
from bpy.app.handlers import persistent
from bpy.props import PointerProperty

from . import observer, rendering


@persistent
def _show_settings_to_the_render(scene, *_):
    """Blender 5 goes on rendering with the settings of its first render unless it is told that
    they may be others."""
    scene.update_tag()


_classes = (*observer.classes, *rendering.classes)


def register():
    for cls in _classes:
        bpy.utils.register_class(cls)
    bpy.types.Camera.eye_render = PointerProperty(type=observer.EyeRenderObserver)
    bpy.types.Scene.eye_render = PointerProperty(type=rendering.EyeRenderScene)
    bpy.types.ViewLayer.eye_render = PointerProperty(type=rendering.EyeRenderPasses)
    bpy.app.handlers.render_init.append(_show_settings_to_the_render)


def unregister():
    bpy.app.handlers.render_init.remove(_show_settings_to_the_render)
    del bpy.types.ViewLayer.eye_render
    del bpy.types.Scene.eye_render
    del bpy.types.Camera.eye_render
    for cls in reversed(_classes):
        bpy.utils.unregister_class(cls)
