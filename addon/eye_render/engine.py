"""The render engine as Blender calls it; no error gets past it, nor a black picture."""

import traceback

import bpy

from . import batch, core, final, passes
from .batch import OptionError
from .core import BadValueError, EyeRenderError
from .options import OF_THE_RENDER, OPTIONS

_VIEWPORT_SENTENCE = "Eye Render draws no picture in the viewport: press F12 to render"


def _sentence(error: Exception) -> str:
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename or 'A file'}: {error.strerror}"  # without its number
    return str(error) or type(error).__name__


class EyeRenderEngine(bpy.types.RenderEngine):
    bl_idname = "EYE_RENDER"
    bl_label = "Eye Render"
    bl_use_preview = False
    bl_use_eevee_viewport = True  # Material Preview
    bl_use_shading_nodes_custom = False  # the node editor offers the nodes of Cycles and EEVEE

    def update_render_passes(self, scene, renderlayer):
        if core.module is not None:
            passes.register(self, scene, renderlayer)

    def render(self, depsgraph):
        try:
            final.render(self, depsgraph)
        except OptionError as error:
            self._end(error)
        except BadValueError as error:
            of_the_eye = (option for option in OPTIONS if option not in OF_THE_RENDER)
            asked = batch.overrides.spoken(of_the_eye)
            if asked:
                self._end(OptionError(f"{asked}; {error}"))
            else:
                self._fail(str(error))
        except Exception as error:
            if not isinstance(error, EyeRenderError):
                traceback.print_exc()
            self._fail(_sentence(error))

    def _end(self, error: OptionError) -> None:
        """A command line that cannot be followed ends Blender, unless somebody sits before it."""
        if bpy.app.background:
            batch.end_blender(error)
        self._fail(str(error))

    def _fail(self, sentence: str) -> None:
        """End the render so that Blender writes no file and exits with status 1."""
        self.error_set(sentence)
        self.report({"ERROR"}, sentence)

    def view_update(self, context, depsgraph):
        self.update_stats("", _VIEWPORT_SENTENCE)

    def view_draw(self, context, depsgraph):
        self.update_stats("", _VIEWPORT_SENTENCE)


def register():
    bpy.utils.register_class(EyeRenderEngine)


def unregister():
    bpy.utils.unregister_class(EyeRenderEngine)
