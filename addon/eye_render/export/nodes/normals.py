"""Normal maps of the other handedness."""

from .flat import Input, Node


def flip_green(node: Node) -> None:
    """DirectX counts the green of a normal map downwards."""
    flip = Node("VECT_MATH", "Vector Math", {"operation": "MULTIPLY_ADD"})
    flip.inputs = {
        "Vector": node.inputs["Color"],
        "Vector_001": Input("VECTOR", (1.0, -1.0, 1.0)),
        "Vector_002": Input("VECTOR", (0.0, 1.0, 0.0)),
    }
    node.inputs["Color"] = Input("RGBA", source=flip.output("Vector", "VECTOR"))
