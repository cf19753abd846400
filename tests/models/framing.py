"""Gives a scene a camera that sees its geometry, and light where it has none. Runs inside
Blender."""

from itertools import product

import bpy
import numpy as np
from mathutils import Vector

PROBES = 16  # rays cast along a side of the picture, to know what Blender itself sees
VIEWING_DISTANCE_M = 2.0
VIEW_DIRECTION = Vector((-0.5, 1.0, -0.4)).normalized()
FRAME_MARGIN = 1.1
CLIP_RATIO = 1e-3
SUN_W_M2 = 3.0
SKY = (0.2, 0.2, 0.2)


def geometry() -> tuple[int, np.ndarray]:
    """The number of triangles, and the corners of the boxes around what has any (n, 3)."""
    triangles, corners = 0, []
    for instance in bpy.context.evaluated_depsgraph_get().object_instances:
        shown = instance.object
        if not instance.show_self or shown.type != "MESH" or shown.hide_render:
            continue
        shown.data.calc_loop_triangles()
        if shown.data.loop_triangles:
            triangles += len(shown.data.loop_triangles)
            corners += [instance.matrix_world @ Vector(corner) for corner in shown.bound_box]
    corners = np.array(corners, np.float64).reshape(-1, 3)
    return triangles, corners[np.isfinite(corners).all(axis=1)]


def add_light(scene: bpy.types.Scene) -> None:
    if not any(shown.type == "LIGHT" and not shown.hide_render for shown in scene.objects):
        sun = bpy.data.lights.new("Added sun", "SUN")
        sun.energy = SUN_W_M2
        shown = bpy.data.objects.new("Added sun", sun)
        shown.rotation_euler = (0.6, 0.3, 0.4)
        scene.collection.objects.link(shown)
    if scene.world is None:
        scene.world = bpy.data.worlds.new("Added sky")
        scene.world.color = SKY


def choose_camera(scene: bpy.types.Scene, corners: np.ndarray) -> tuple[float, float]:
    """A camera of the file that sees something, else one that frames everything. Returns the part
    of the picture that geometry covers, and its mean distance in Blender's units."""
    cameras = [shown for shown in scene.objects if shown.type == "CAMERA"]
    cameras.sort(key=lambda camera: camera != scene.camera)
    for camera in cameras:
        seen, distance = _look(scene, camera)
        if camera.data.type == "PERSP" and seen > 0:
            scene.camera = camera
            return seen, distance
    scene.camera = _frame_everything(scene, corners)
    return _look(scene, scene.camera)


def _frame_everything(scene: bpy.types.Scene, corners: np.ndarray) -> bpy.types.Object:
    camera = bpy.data.objects.new("Added camera", bpy.data.cameras.new("Added camera"))
    scene.collection.objects.link(camera)
    camera.rotation_euler = VIEW_DIRECTION.to_track_quat("-Z", "Y").to_euler()
    if len(corners):
        centre = (corners.min(axis=0) + corners.max(axis=0)) / 2
        radius = max(np.linalg.norm(corners - centre, axis=1).max(), 1e-3)
        distance = radius * FRAME_MARGIN / np.sin(camera.data.angle / 2)
        camera.location = Vector(centre) - VIEW_DIRECTION * distance
        camera.data.clip_start = distance * CLIP_RATIO
        camera.data.clip_end = 2 * distance
    return camera


def _look(scene: bpy.types.Scene, camera: bpy.types.Object) -> tuple[float, float]:
    """What Blender's own rays hit: the covered part of the picture, and the mean distance."""
    bpy.context.view_layer.update()
    depsgraph = bpy.context.evaluated_depsgraph_get()
    world_from_camera = camera.matrix_world.normalized()
    frame = camera.data.view_frame(scene=scene)
    low = Vector(np.min(frame, axis=0))
    high = Vector(np.max(frame, axis=0))
    origin = world_from_camera.translation
    distances = []
    for i, j in product(range(PROBES), repeat=2):
        x, y = (i + 0.5) / PROBES, (j + 0.5) / PROBES
        target = Vector((low.x + x * (high.x - low.x), low.y + y * (high.y - low.y), low.z))
        direction = (world_from_camera.to_3x3() @ target).normalized()
        start = origin + direction * camera.data.clip_start
        hit, place, _, face, shown, _ = scene.ray_cast(
            depsgraph, start, direction, distance=camera.data.clip_end
        )
        if hit and not shown.hide_render and _is_opaque(shown, depsgraph, face):
            distances.append((place - origin).length)
    seen = len(distances) / PROBES**2
    return seen, float(np.mean(distances)) if distances else VIEWING_DISTANCE_M


def _is_opaque(shown: bpy.types.Object, depsgraph: bpy.types.Depsgraph, face: int) -> bool:
    """False for a face through which the picture may show what is behind."""
    slots = [slot.material for slot in shown.material_slots]
    if not slots:
        return True
    faces = getattr(shown.evaluated_get(depsgraph).data, "polygons", None)  # curves have none
    index = faces[face].material_index if faces else 0
    material = slots[min(index, len(slots) - 1)]
    if material is None or not material.use_nodes:
        return True
    for node in material.node_tree.nodes:
        alpha = node.inputs.get("Alpha")
        if alpha and (alpha.is_linked or alpha.default_value < 1):
            return False
    return True
