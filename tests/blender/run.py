"""Runs these tests inside Blender, whose exit status is theirs:

blender -b --factory-startup --addons eye_render --python tests/blender/run.py -- [for pytest]

BLENDER_USER_SCRIPTS names a folder with addons/eye_render and, in addons/modules, the eyecore
that was built.
"""

import sys
from pathlib import Path

import pytest

arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
folder = Path(__file__).parent
sys.path.append(str(folder.parent))  # for `tools`
status = pytest.main(
    ["-q", "-p", "no:cacheprovider", f"--rootdir={folder}", *(arguments or [str(folder)])]
)
sys.stdout.flush()
sys.exit(int(status))
