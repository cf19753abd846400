"""Curves objects: strands with a radius at each of their points."""

import bpy
import numpy as np

from .. import compat, cycles_settings
from .attributes import attribute_values
from .pose import Pose, motion_arguments


def core_shape(scene: bpy.types.Scene) -> str:
    """The core's name of how Cycles would show strands; flat ribbons are Blender's default."""
    settings = cycles_settings.curves(scene)
    shapes = {"THICK": "ROUND", "THICK_LINEAR": "ROUND_LINEAR"}
    return shapes.get(settings.shape if settings else "", "RIBBON")


class CurvesSource:
    def __init__(self, curves: bpy.types.Curves, scene: bpy.types.Scene):
        self.name = curves.name
        self.key = (curves.as_pointer(), "")
        self.part = ""
        self._curves = curves
        self._shape = core_shape(scene)

    def worn(self, slots: tuple[int, ...]) -> tuple[int, ...]:
        return slots[:1]

    def _key_counts(self) -> np.ndarray:
        """Of each strand; one of a lone point is left out."""
        count = np.empty(len(self._curves.curves), np.int32)
        self._curves.curves.foreach_get("points_length", count)
        return count

    def pose(self) -> Pose:
        count = self._key_counts()
        return Pose(compat.point_positions(self._curves)[np.repeat(count >= 2, count)])

    def add(
        self, core_scene, material_ids: list[int], reads_uvs: bool, motion: list[Pose]
    ) -> int | None:
        curves, count = self._curves, self._key_counts()
        strands = np.flatnonzero(count >= 2)
        if len(strands) == 0:
            return None
        keys = np.repeat(count >= 2, count)
        domains = {
            "POINT": np.flatnonzero(keys),
            "CURVE": np.repeat(np.arange(len(count)), count)[keys],
        }
        uv_map = _uv_of_strands(curves)
        is_uv_read = uv_map is not None and (reads_uvs or core_scene.uv_layers_read(material_ids))
        return core_scene.add_curves(
            self.name,
            compat.point_positions(curves)[keys],
            compat.point_radii(curves)[keys],
            np.cumsum(count[strands]) - count[strands],
            shape=self._shape,
            uvs={"": uv_map[strands]} if is_uv_read else {},
            attributes={
                name: values
                for name in core_scene.attributes_read(material_ids)
                if (values := attribute_values(curves.attributes.get(name), domains)) is not None
            },
            **motion_arguments(motion),
        )


def _uv_of_strands(curves: bpy.types.Curves) -> np.ndarray | None:
    """Where on the surface that they grow on the strands' roots are."""
    attribute = curves.attributes.get("surface_uv_coordinate")
    if attribute is None or (attribute.domain, attribute.data_type) != ("CURVE", "FLOAT2"):
        return None
    uvs = np.empty((len(attribute.data), 2), np.float32)
    attribute.data.foreach_get("vector", uvs.ravel())
    return uvs
