"""The sky of Hosek and Wilkie, which the core does not have."""

from dataclasses import replace

from .flat import Input, Node

# Means of the upper hemisphere in Cycles, for turbidities from 2.2 to 8 and a sun 5 to 80 degrees
# high: Preetham's sky is 4 to 10 times as bright, at every colour alike.
_PREETHAM_SHARE = 1.0 / 6.0


def hosek_as_preetham(node: Node) -> None:
    """Preetham's sky, dimmed; the node itself becomes what dims it."""
    sky = replace(node, options=node.options | {"sky_type": "PREETHAM"})
    node.kind = "MIX"
    node.options = {"data_type": "RGBA", "blend_type": "MULTIPLY"}
    node.changed = set()
    node.inputs = {
        "Factor_Float": Input("VALUE", 1.0),
        "A_Color": Input("RGBA", source=sky.output("Color", "RGBA")),
        "B_Color": Input("RGBA", (_PREETHAM_SHARE,) * 3),
    }
    node.renamed_outputs = {"Color": "Result_Color"}
