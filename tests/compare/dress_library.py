"""Saves a .blend for each material of a library: the lit ball of the feature scenes in it. Inside
Blender:

blender -b --factory-startup --python dress_library.py -- LIBRARY.blend FOLDER
"""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
from rendering import choose_exr  # noqa: E402
from stage import ball  # noqa: E402


def main(library: str, folder: Path) -> None:
    with bpy.data.libraries.load(library) as (held, _):
        names = list(held.materials)
    for name in names:
        bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
        with bpy.data.libraries.load(library) as (_, wanted):
            wanted.materials = [name]
        ball(wanted.materials[0])
        scene = bpy.context.scene
        scene.render.resolution_x = scene.render.resolution_y = 128
        choose_exr(scene)
        safe = "".join(c if c.isalnum() else "_" for c in name)
        bpy.ops.wm.save_as_mainfile(filepath=str(folder / f"{safe}.blend"), check_existing=False)


main(sys.argv[-2], Path(sys.argv[-1]))
