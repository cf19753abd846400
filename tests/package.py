"""Makes the add-on's zip, compiled module included, as Blender's "Install from Disk" takes it."""

import os
import re
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SKY_LICENSE = ROOT / "core/shading/sky/LICENSE.hosek_wilkie"  # of data in the module
BUILD = Path(os.environ.get("EYE_BUILD_DIR", ROOT / "build"))


def make_zip() -> Path:
    addon = ROOT / "addon/eye_render"
    manifest = (addon / "blender_manifest.toml").read_text(encoding="utf-8")
    version = re.search(r'^version = "(.+)"$', manifest, re.MULTILINE).group(1)
    modules = sorted(BUILD.glob("release/bindings/eyecore*.so"))
    sources = sorted(path for path in addon.rglob("*") if path.suffix in {".py", ".toml"})
    package = BUILD / f"eye_render-{version}.zip"
    with zipfile.ZipFile(package, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sources:
            archive.write(path, "eye_render" / path.relative_to(addon))
        for path in [*modules, ROOT / "LICENSE", SKY_LICENSE]:
            archive.write(path, f"eye_render/{path.name}")
    return package


if __name__ == "__main__":
    print(make_zip())
