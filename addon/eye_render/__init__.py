"""Eye Render: a render engine that shows a scene as one particular person sees it."""

bl_info = {
    "name": "Eye Render",
    "author": "The Eye Render developers",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Render Properties > Render Engine > Eye Render",
    "description": "Renders the scene through an eye with a prescription, a pupil and an age",
    "category": "Render",
}

from . import (  # noqa: E402  (bl_info comes first by convention)
    batch,
    engine,
    found,
    operators,
    properties,
    ui,
)


def register():
    properties.register()
    batch.register()
    found.register()
    engine.register()
    operators.register()
    ui.register()


def unregister():
    ui.unregister()
    operators.unregister()
    engine.unregister()
    found.unregister()
    properties.unregister()
