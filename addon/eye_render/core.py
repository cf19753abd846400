"""The only import of the native module `eyecore`, and a sentence for the user when it fails."""

import importlib
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType


class EyeRenderError(RuntimeError):
    """Its text is a sentence for the user; no traceback is shown for it."""


class BadValueError(EyeRenderError):
    """Something that was asked for is out of range, or does not go with something else."""


def _load() -> ModuleType:
    """The module next to this package, else the one on Python's path.

    It is entered in `sys.modules` under its plain name, so that a script's `import eyecore` gets
    this same module: a second copy could not register its types again.
    """
    if "eyecore" in sys.modules:
        return sys.modules["eyecore"]
    beside_package = f"{__package__}.eyecore"
    try:
        module = importlib.import_module(beside_package)
    except ModuleNotFoundError as error:
        if error.name != beside_package:
            raise
        return importlib.import_module("eyecore")
    sys.modules["eyecore"] = module
    return module


def _built_for() -> list[str]:
    """Python versions that the native modules lying about were built for, such as "3.9"."""
    folders = [Path(__file__).parent, *map(Path, sys.path)]
    names = [file.name for folder in folders for file in folder.glob("eyecore*.so")]
    tags = [re.search(r"cpython-(\d)(\d+)", name) for name in names]
    return sorted({f"{tag[1]}.{tag[2]}" for tag in tags if tag})


def _explain(error: ImportError) -> str:
    this_python = f"{sys.version_info.major}.{sys.version_info.minor}"
    if not isinstance(error, ModuleNotFoundError):
        return f"The native module eyecore does not load: {error}"
    other_pythons = [version for version in _built_for() if version != this_python]
    if other_pythons:
        return (
            f"The native module eyecore was built for Python {', '.join(other_pythons)}, "
            f"but this Blender runs Python {this_python}"
        )
    return f"The native module eyecore is missing; build it for Python {this_python}"


module: ModuleType | None = None
problem = ""  # why `module` is None
try:
    module = _load()
except ImportError as import_error:
    problem = _explain(import_error)
    print(f"Eye Render: {problem}", file=sys.stderr, flush=True)


def require() -> ModuleType:
    """The native module, or EyeRenderError with the reason why there is none."""
    if module is None:
        raise EyeRenderError(problem)
    return module


@contextmanager
def speaking(about: str = "") -> Iterator[ModuleType]:
    """The native module; what it refuses becomes an EyeRenderError with the same sentence, after
    the name of what it is `about`: a part of the scene. What is about none may be an option's."""
    try:
        yield require()
    except EyeRenderError:
        raise
    except (ValueError, RuntimeError) as error:
        if about:
            raise EyeRenderError(f"{about}: {error}") from error
        is_bad_value = isinstance(error, ValueError)
        raise (BadValueError if is_bad_value else EyeRenderError)(str(error)) from error
