"""Which of Blender's operators loads a file, by the ending of its name. Runs inside Blender; as a
script it prints one line, `importers: {ending: operator}`, of those that this Blender has."""

import json
import sys
from pathlib import Path

import addon_utils
import bpy

sys.path.insert(0, str(Path(__file__).parent))
from repairs import repair_importers  # noqa: E402

# Newest first: Blender has moved its importers from add-ons into itself one by one.
_OPERATORS = {
    ".blend": ("wm.open_mainfile",),
    ".bvh": ("import_anim.bvh",),
    ".dae": ("wm.collada_import",),
    ".dxf": ("import_scene.dxf",),
    ".fbx": ("wm.fbx_import", "import_scene.fbx"),
    ".glb": ("import_scene.gltf",),
    ".gltf": ("import_scene.gltf",),
    ".obj": ("wm.obj_import", "import_scene.obj"),
    ".ply": ("wm.ply_import", "import_mesh.ply"),
    ".stl": ("import_mesh.stl", "wm.stl_import"),
    ".wrl": ("import_scene.x3d",),
    ".x3d": ("import_scene.x3d",),
}
_OFF_BY_DEFAULT = ("io_import_dxf",)


def _exists(operator: str) -> bool:
    family, name = operator.split(".")
    return name in dir(getattr(bpy.ops, family))


def enable() -> None:
    """Switch on the importers that Blender ships but does not start with."""
    for name in _OFF_BY_DEFAULT:
        if any(module.__name__ == name for module in addon_utils.modules()):
            addon_utils.enable(name)


def available() -> dict[str, str]:
    """The operator for each ending that can be loaded."""
    found = {
        ending: next(filter(_exists, operators), None) for ending, operators in _OPERATORS.items()
    }
    return {ending: operator for ending, operator in found.items() if operator}


def load(path: Path) -> None:
    """Load into an empty scene, or as the scene. Raises RuntimeError if the importer refuses."""
    repair_importers()
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    enable()  # after the home file, which brings its own list of add-ons
    operator = available()[path.suffix.lower()]
    family, name = operator.split(".")
    outcome = getattr(getattr(bpy.ops, family), name)(filepath=str(path))
    if outcome != {"FINISHED"}:
        raise RuntimeError(f"{operator} returned {outcome}")


if __name__ == "__main__":
    enable()
    print("importers:", json.dumps(available()), flush=True)
