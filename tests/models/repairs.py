"""What the importers of Debian's Blender 3.4 miss in the Python 3.11 and NumPy 1.24 that it runs
on: without it no glTF, X3D, VRML or BVH file loads there. Other Blenders are not changed by it."""

import builtins

import numpy as np


def repair_importers() -> None:
    if "bool" not in vars(np):  # between NumPy 1.24 and 2.0
        np.bool = bool
    if builtins.open is not _open_with_old_modes:
        builtins.open = _open_with_old_modes


_open = builtins.open


def _open_with_old_modes(file, mode="r", *rest, **options):
    """Python 3.11 took away the mode "U", which had meant nothing since Python 3.0."""
    return _open(file, mode.replace("U", ""), *rest, **options)
