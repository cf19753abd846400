"""Renders views of the demo scene through Eye Render, as EXR and PNG. Runs inside Blender:

blender -b --factory-startup --addons eye_render hall.blend --python render_views.py -- \
    FOLDER SAMPLES SPHERE_D...
"""

import sys
from pathlib import Path

import bpy

PUPIL_MM = 4.0


def main(folder: str, samples: str, *spheres_d: str) -> None:
    scene = bpy.context.scene
    scene.render.engine = "EYE_RENDER"
    scene.eye_render.quality = "CUSTOM"
    scene.eye_render.samples = int(samples)
    observer = scene.camera.data.eye_render
    observer.pupil_mode, observer.pupil_mm = "MANUAL", PUPIL_MM
    observer.focus_mode = "RELAXED"
    for sphere_d in spheres_d:
        observer.right.text = f"{sphere_d}DS"
        print(f"View {sphere_d}", flush=True)
        picture = Path(folder) / f"demo_{sphere_d}DS.exr"
        # Written by the render, so that it carries the observer in its metadata.
        image = scene.render.image_settings
        image.file_format, image.color_mode, image.color_depth = "OPEN_EXR", "RGB", "32"
        scene.render.filepath = str(picture)
        bpy.ops.render.render(write_still=True)
        image.file_format, image.color_depth = "PNG", "8"
        result = bpy.data.images["Render Result"]
        result.save_render(str(picture.with_suffix(".png")), scene=scene)


main(*sys.argv[sys.argv.index("--") + 1 :])
