"""What differs between Blender 3.4 and 5.2, and nothing else looks at versions."""

import math
import re

import bpy
import numpy as np

from . import cycles_settings


def uses_nodes(datablock: bpy.types.ID) -> bool:
    """True if the node tree counts; from Blender 5.0 that of materials and worlds always does."""
    if bpy.app.version >= (5, 0, 0) and not isinstance(datablock, bpy.types.Light):
        return datablock.node_tree is not None
    return datablock.use_nodes and datablock.node_tree is not None


def inline_shader_nodes(datablock: bpy.types.ID) -> object:
    """An object whose `node_tree` has node groups flattened, where Blender can do so.

    The caller keeps the object for as long as it reads the tree: it owns the tree.
    """
    if not hasattr(datablock, "inline_shader_nodes"):
        return datablock
    inlined = datablock.inline_shader_nodes()
    # Blender 5.2 leaves out outputs that are for one engine alone, with all that feeds them.
    has_output = inlined.node_tree.get_output_node("CYCLES") is not None
    return inlined if has_output else datablock


def node_name(node: bpy.types.Node) -> str:
    """The name that the user gave; Blender numbers the nodes of trees that it flattens."""
    if hasattr(bpy.types.Material, "inline_shader_nodes"):
        return re.sub(r"^\d+_", "", node.name)
    return node.name


def aov_name(node: bpy.types.ShaderNodeOutputAOV) -> str:
    """Which value of the view layer's list the node gives."""
    return node.aov_name if hasattr(node, "aov_name") else node.name  # before Blender 4.0


def displacement_method(material: bpy.types.Material) -> str:
    """BUMP, DISPLACEMENT or BOTH."""
    if hasattr(material, "displacement_method"):  # from Blender 4.1
        return material.displacement_method
    return getattr(cycles_settings.of(material), "displacement_method", "BUMP")


def world_of(scene: bpy.types.Scene, view_layer: bpy.types.ViewLayer) -> bpy.types.World | None:
    return getattr(view_layer, "world_override", None) or scene.world


def light_factor(light: bpy.types.Light) -> tuple[np.ndarray, bool]:
    """What this Blender multiplies a light's colour by, and whether area leaves power alone."""
    factor = np.full(3, 2.0 ** getattr(light, "exposure", 0.0))
    if getattr(light, "use_temperature", False):
        factor *= np.array(light.temperature_color)
    if light.type == "AREA" and bpy.app.version < (4, 0, 0):
        factor *= math.pi / 4  # what such a Cycles makes of a watt
    return factor, getattr(light, "normalize", True)


def linked_collections(
    shown: bpy.types.Object,
) -> tuple[bpy.types.Collection | None, bpy.types.Collection | None]:
    """What the object alone lights, and what alone throws its shadows; from Blender 4.0."""
    linking = getattr(shown, "light_linking", None)
    return (linking.receiver_collection, linking.blocker_collection) if linking else (None, None)


# Before 4.4, nodes of a lamp find the world's coordinates where they ask for the object's.
LIGHTS_HAVE_OWN_SPACE = bpy.app.version >= (4, 4, 0)

# Before 4.0, Cycles dims a spot by the cosine of the angle from its axis.
SPOTS_HAVE_COSINE_FALLOFF = bpy.app.version < (4, 0, 0)


def has_soft_falloff(light: bpy.types.Light) -> bool:
    """Whether a point or spot light is a disk turned to the lit point, as it always is where
    Blender has no choice, rather than a sphere."""
    return getattr(light, "use_soft_falloff", True)


def shadow_switch(light: bpy.types.Light) -> tuple[bpy.types.bpy_struct, str]:
    """What says whether the lamp throws shadows: holder and name of the property."""
    cycles = cycles_settings.of(light)  # there before Blender 4.0
    return (cycles, "cast_shadow") if hasattr(cycles, "cast_shadow") else (light, "use_shadow")


def draw_light_extras(layout: bpy.types.UILayout, light: bpy.types.Light) -> None:
    """Rows for what `light_factor` reads."""
    if hasattr(light, "exposure"):
        layout.prop(light, "exposure")
        layout.prop(light, "normalize")
    if hasattr(light, "use_temperature"):
        layout.prop(light, "use_temperature")
        if light.use_temperature:
            layout.prop(light, "temperature")


def shutter_position_switch(scene: bpy.types.Scene) -> tuple[bpy.types.bpy_struct, str] | None:
    """What says where the frame lies in the time that the shutter is open, START, CENTER or END:
    holder and name of the property."""
    for owner in (scene.render, cycles_settings.of(scene)):  # Blender's own since 4.2
        if hasattr(owner, "motion_blur_position"):
            return owner, "motion_blur_position"
    return None


def shutter_position(scene: bpy.types.Scene) -> str:
    switch = shutter_position_switch(scene)
    return getattr(*switch) if switch else "CENTER"


def has_transparent_shadow(material: bpy.types.Material) -> bool:
    """Whether the shadow of what is see-through is, too."""
    for owner in (material, cycles_settings.of(material)):  # Blender's own since 4.2
        if hasattr(owner, "use_transparent_shadow"):
            return owner.use_transparent_shadow
    return True


def terminator_offsets(shown: bpy.types.Object) -> tuple[float, float]:
    """How far light turns the corner of few smooth faces: of the shading, and of the geometry."""
    for owner in (shown, cycles_settings.of(shown)):  # Blender's own since 4.4
        if hasattr(owner, "shadow_terminator_geometry_offset"):
            shading = getattr(owner, "shadow_terminator_offset", None)  # Cycles' name of it
            if shading is None:
                shading = owner.shadow_terminator_shading_offset
            return shading, owner.shadow_terminator_geometry_offset
    return 0.0, 0.1


def vertex_positions(mesh: bpy.types.Mesh) -> np.ndarray:
    positions = np.empty((len(mesh.vertices), 3), np.float32)
    attribute = mesh.attributes.get("position")  # from Blender 3.5, at memcpy speed
    if attribute is not None:
        attribute.data.foreach_get("vector", positions.ravel())
    else:
        mesh.vertices.foreach_get("co", positions.ravel())
    return positions


def point_positions(data: bpy.types.Curves | bpy.types.PointCloud) -> np.ndarray:
    positions = np.empty((len(data.points), 3), np.float32)
    data.attributes["position"].data.foreach_get("vector", positions.ravel())
    return positions


# What Cycles takes for the radius of curves and points that have none.
_RADIUS_OF_NONE = {"CURVES": 0.005, "POINTCLOUD": 0.01}


def point_radii(data: bpy.types.Curves | bpy.types.PointCloud) -> np.ndarray:
    attribute = data.attributes.get("radius")
    if attribute is None:
        kind = "CURVES" if isinstance(data, bpy.types.Curves) else "POINTCLOUD"
        return np.full(len(data.points), _RADIUS_OF_NONE[kind], np.float32)
    radii = np.empty(len(data.points), np.float32)
    attribute.data.foreach_get("value", radii)
    return np.maximum(radii, 0.0)


def corner_vertices(mesh: bpy.types.Mesh) -> np.ndarray:
    vertices = np.empty(len(mesh.loops), np.int32)
    attribute = mesh.attributes.get(".corner_vert")
    if attribute is not None:
        attribute.data.foreach_get("value", vertices)
    else:
        mesh.loops.foreach_get("vertex_index", vertices)
    return vertices


def corner_uvs(layer: bpy.types.MeshUVLoopLayer) -> np.ndarray:
    """(corners, 2)"""
    if hasattr(layer, "uv"):
        uvs = np.empty((len(layer.uv), 2), np.float32)
        layer.uv.foreach_get("vector", uvs.ravel())
    else:
        uvs = np.empty((len(layer.data), 2), np.float32)
        layer.data.foreach_get("uv", uvs.ravel())
    return uvs


def normals_domain(mesh: bpy.types.Mesh) -> str:
    """Where normals differ: FACE for a flat mesh, POINT for one all smooth, else CORNER."""
    if hasattr(mesh, "normals_domain"):
        return mesh.normals_domain
    smooth = np.empty(len(mesh.polygons), bool)
    mesh.polygons.foreach_get("use_smooth", smooth)
    if mesh.use_auto_smooth and (smooth.any() or mesh.has_custom_normals):
        return "CORNER"
    if smooth.all():
        return "POINT"
    return "CORNER" if smooth.any() else "FACE"


def corner_normals(mesh: bpy.types.Mesh) -> np.ndarray:
    """Split normals (corners, 3)."""
    normals = np.empty((len(mesh.loops), 3), np.float32)
    if hasattr(mesh, "corner_normals"):
        mesh.corner_normals.foreach_get("vector", normals.ravel())
    else:
        mesh.calc_normals_split()
        mesh.loops.foreach_get("normal", normals.ravel())
        mesh.free_normals_split()
    return normals


# Whether a random walk below a surface is what later versions call legacy. Those also let light
# walk where it shows least: within a pixel, and after diffuse bounces.
RANDOM_WALK_IS_LEGACY = (
    "RANDOM_WALK_LEGACY"
    not in bpy.types.ShaderNodeBsdfPrincipled.bl_rna.properties["subsurface_method"].enum_items
)

# Whether Cycles has a pass of the lamps' shadows; later versions have the switch for EEVEE alone.
HAS_SHADOW_PASS = bpy.app.version < (4, 0, 0)

# Names of passes before Blender 5.0.
_SHORT_PASS_NAMES = {
    "Diffuse Direct": "DiffDir",
    "Diffuse Indirect": "DiffInd",
    "Diffuse Color": "DiffCol",
    "Glossy Direct": "GlossDir",
    "Glossy Indirect": "GlossInd",
    "Glossy Color": "GlossCol",
    "Transmission Direct": "TransDir",
    "Transmission Indirect": "TransInd",
    "Transmission Color": "TransCol",
    "Volume Direct": "VolumeDir",
    "Volume Indirect": "VolumeInd",
    "Emission": "Emit",
    "Environment": "Env",
    "Ambient Occlusion": "AO",
    "Object Index": "IndexOB",
    "Material Index": "IndexMA",
}


def pass_name(name: str) -> str:
    """What this Blender calls the pass, so that nodes of the compositor find it."""
    return _SHORT_PASS_NAMES.get(name, name) if bpy.app.version < (5, 0, 0) else name
