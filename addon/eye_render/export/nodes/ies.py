"""Photometric files of the IES Texture node, as the text in them."""

from pathlib import Path

import bpy

from .flat import Input, Node

# What such a node gives, times its strength, if there is no profile.
_WITHOUT_PROFILE = 100.0


def read_profile(node: Node) -> None:
    """Option `ies`, the text, in place of where it is."""
    text: bpy.types.Text | None = node.options.pop("ies")
    path: Path = node.options.pop("filepath")
    mode = node.options.pop("mode")
    node.changed -= {"filepath", "mode"}
    profile = _contents(path) if mode == "EXTERNAL" else text and text.as_string()
    if profile is None:
        node.notes.append("the missing profile of")
        node.kind, node.options = "MATH", {"operation": "MULTIPLY"}
        node.inputs = {
            "Value": node.inputs["Strength"],
            "Value_001": Input("VALUE", _WITHOUT_PROFILE),
        }
        node.renamed_outputs = {"Fac": "Value"}
    else:
        node.options["ies"] = profile


def _contents(path: Path) -> str | None:
    try:
        return path.read_text(encoding="latin-1")
    except OSError:
        return None
