"""The Principled BSDF of Blender 3 as that of Blender 4, as Blender itself converts its files."""

from .flat import Input, Node

_WHITE = (1.0, 1.0, 1.0)
# Coats were a quarter as strong; where the strength is a texture, a lower index stands in.
_COAT_STRENGTH, _COAT_IOR = 0.25, 1.2
_SHEEN_STRENGTH = 0.2

RENAMED_INPUTS = {
    "Subsurface": "Subsurface Weight",
    "Specular": "Specular IOR Level",
    "Transmission": "Transmission Weight",
    "Clearcoat": "Coat Weight",
    "Clearcoat Roughness": "Coat Roughness",
    "Clearcoat Normal": "Coat Normal",
    "Sheen": "Sheen Weight",
    "Emission": "Emission Color",
}


def widen_subsurface(node: Node) -> None:
    """Subsurface was the share of scattered light and the radius's scale in one."""
    subsurface, color = node.inputs["Subsurface"], node.inputs.pop("Subsurface Color")
    if _is_constant(subsurface, 0.0):
        return
    node.inputs["Base Color"] = _mix(node.inputs["Base Color"], color, subsurface)
    node.inputs["Subsurface Scale"] = subsurface
    node.inputs["Subsurface"] = Input("VALUE", 1.0)


def color_specular_tint(node: Node) -> None:
    """The tint was how much of the base colour, which metals had anyway, coloured the glints."""
    tint = node.inputs["Specular Tint"]
    white = Input("RGBA", _WHITE)
    if tint.source is None and tint.value <= 0.0:
        node.inputs["Specular Tint"] = white
        return
    tinted = _mix(node.inputs["Base Color"], white, node.inputs["Metallic"])
    node.inputs["Specular Tint"] = _mix(white, tinted, tint)


def weaken_sheen(node: Node) -> None:
    sheen = node.inputs["Sheen"]
    if sheen.source is None:
        sheen.value *= _SHEEN_STRENGTH
        node.inputs["Sheen Tint"] = Input("RGBA", _WHITE)
    else:
        node.inputs["Sheen Tint"] = Input("RGBA", (_SHEEN_STRENGTH,) * 3)


def weaken_coat(node: Node) -> None:
    coat = node.inputs["Clearcoat"]
    if coat.source is None:
        coat.value *= _COAT_STRENGTH
    else:
        node.inputs["Coat IOR"] = Input("VALUE", _COAT_IOR)


def _is_constant(socket: Input, value: float) -> bool:
    return socket.source is None and socket.value == value


def _mix(first: Input, second: Input, factor: Input) -> Input:
    node = Node("MIX", "Mix", {"data_type": "RGBA", "blend_type": "MIX", "clamp_factor": True})
    node.inputs = {"Factor_Float": factor, "A_Color": first, "B_Color": second}
    return Input("RGBA", source=node.output("Result_Color", "RGBA"))
