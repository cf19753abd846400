"""The list of feature scenes: each a function of scenes/*.py that builds one feature in an empty
scene, and what is expected of its picture. Inside Blender."""

import importlib
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass
from fnmatch import fnmatchcase
from pathlib import Path

HERE = Path(__file__).resolve().parent


@dataclass(frozen=True)
class Feature:
    name: str  # FAMILY/FUNCTION
    about: str
    build: Callable[[], None]
    samples: int = 256  # per pixel, enough in Eye Render
    bounces: int = 2
    view: str = "COLOR"  # how the picture is looked at: a key of picture.VIEWS
    differs: str = ""  # why the picture is not Cycles 4.3's; deviations.csv says how far it is off
    before_4: str = ""  # the same where only that of a Blender before 4.0 is not
    refused: str = ""  # of what Eye Render says that does not render the scene
    since: tuple[int, int] = (3, 4)  # the Blender that has the feature
    shows_pass: tuple = ()  # the view layer's switch (or None) and the names of the pass seen

    def facts(self) -> dict:
        """What the programs outside Blender are told."""
        return {key: value for key, value in asdict(self).items() if key != "build"}


_features: list[Feature] = []


def feature(name: str = "", about: str = "", **expected):
    """Declares the scene that the decorated function of a family's file builds; its docstring says
    what it shows."""
    family = Path(sys._getframe(1).f_code.co_filename).stem

    def declare(build: Callable[[], None]) -> Callable[[], None]:
        full_name = f"{family}/{name or build.__name__}"
        _features.append(Feature(full_name, about or build.__doc__, build, **expected))
        return build

    return declare


def all_features() -> list[Feature]:
    """Every scene, family by family in the order of its file."""
    if not _features:
        sys.path[:0] = [str(HERE), str(HERE.parent)]
        for path in sorted((HERE / "scenes").glob("*.py")):
            importlib.import_module(f"scenes.{path.stem}")
    return _features


def matching(glob: str, version: tuple[int, int]) -> list[Feature]:
    """The scenes of that name that a Blender of that version can show."""
    return [
        feature
        for feature in all_features()
        if fnmatchcase(feature.name, glob) and feature.since <= version
    ]
