"""Image and environment textures: the picture as the number of a texture of the core."""

import bpy

from ..image import MISSING_COLOR, ImageTable
from .coordinates import coordinate_of
from .flat import Input, Node, math_node, math_result


def number_texture(node: Node, images: ImageTable) -> None:
    """Options `texture` or `tiles` in place of the image and of how it is read.

    A texture without a picture becomes a plain colour.
    """
    image: bpy.types.Image | None = node.options.pop("image")
    user: bpy.types.ImageUser = node.options.pop("image_user")
    extension = node.options.pop("extension", "REPEAT")
    interpolation = node.options.pop("interpolation")
    if extension == "MIRROR" and node.options["projection"] == "FLAT":
        extension = "EXTEND"
        _fold_coordinates(node)
    if image is None:
        node.notes.append("the missing image of")
    elif image.source == "TILED":
        node.options["tiles"] = images.tiles(image, extension, interpolation)
    else:
        node.options["texture"] = images.texture(image, user, extension, interpolation)
    if not node.options.get("tiles") and node.options.get("texture") is None:
        node.kind, node.options, node.inputs = "RGB", {"value": list(MISSING_COLOR)}, {}
        node.constant_outputs = {"Alpha": 1.0}
        return
    if image.alpha_mode == "NONE":
        node.constant_outputs = {"Alpha": 1.0}


def _fold_coordinates(node: Node) -> None:
    """Every second repetition runs backwards, within the picture itself."""
    separate = Node("SEPXYZ", "Separate XYZ", inputs={"Vector": coordinate_of(node)})
    combine = Node("COMBXYZ", "Combine XYZ")
    for axis in ("X", "Y"):
        place = Input("VALUE", source=separate.output(axis, "VALUE"))
        combine.inputs[axis] = math_result(math_node("PINGPONG", place, 1.0))
    node.inputs["Vector"] = Input("VECTOR", source=combine.output("Vector", "VECTOR"))
