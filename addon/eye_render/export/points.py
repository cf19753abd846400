"""Point clouds: balls with a radius each."""

import bpy
import numpy as np

from .. import compat
from .attributes import attribute_values
from .pose import Pose, motion_arguments


class PointsSource:
    def __init__(self, cloud: bpy.types.PointCloud, _scene: bpy.types.Scene):
        self.name = cloud.name
        self.key = (cloud.as_pointer(), "")
        self.part = ""
        self._cloud = cloud

    def worn(self, slots: tuple[int, ...]) -> tuple[int, ...]:
        return slots[:1]

    def pose(self) -> Pose:
        return Pose(compat.point_positions(self._cloud))

    def add(
        self, core_scene, material_ids: list[int], reads_uvs: bool, motion: list[Pose]
    ) -> int | None:
        cloud = self._cloud
        count = len(cloud.points)
        if count == 0:
            return None
        domains = {"POINT": np.arange(count)}
        return core_scene.add_points(
            self.name,
            compat.point_positions(cloud),
            compat.point_radii(cloud),
            attributes={
                name: values
                for name in core_scene.attributes_read(material_ids)
                if (values := attribute_values(cloud.attributes.get(name), domains)) is not None
            },
            **motion_arguments(motion),
        )
