"""Makes the picture a pass, through the compositor. Inside Blender."""

import bpy


def show_pass(scene: bpy.types.Scene, switch: str | None, *names: str) -> None:
    """`switch` is the view layer's property, `names` the pass's from new Blenders to old. The
    scene's engine is chosen already. Raises LookupError if it has no such pass."""
    layer = scene.view_layers[0]
    if switch:
        setattr(layer if hasattr(layer, switch) else layer.cycles, switch, True)
    tree, picture = _tree_and_picture(scene)
    layers = tree.nodes.new("CompositorNodeRLayers")
    layer.update_render_passes()
    for name in names:
        output = layers.outputs.get(name)
        if output is not None and output.enabled:
            tree.links.new(output, picture)
            return
    raise LookupError(f"no pass {names[0]}")


def _tree_and_picture(scene: bpy.types.Scene):
    if hasattr(scene, "compositing_node_group"):  # from Blender 5.0
        tree = bpy.data.node_groups.new("Compositing", "CompositorNodeTree")
        scene.compositing_node_group = tree
        tree.interface.new_socket("Image", in_out="OUTPUT", socket_type="NodeSocketColor")
        return tree, tree.nodes.new("NodeGroupOutput").inputs[0]
    scene.use_nodes = True
    scene.node_tree.nodes.clear()
    node = scene.node_tree.nodes.new("CompositorNodeComposite")
    node.use_alpha = False
    return scene.node_tree, node.inputs[0]
