"""Hair of particle systems: strands that Blender works out key by key."""

import bpy
import numpy as np

from .curves import core_shape
from .mesh import texture_space
from .pose import Pose, motion_arguments


class HairSource:
    def __init__(
        self, bearer: bpy.types.Object, modifier: bpy.types.Modifier, scene: bpy.types.Scene
    ):
        self._bearer = bearer
        self._modifier = modifier
        self._system = modifier.particle_system
        self._settings = self._system.settings
        self._shape = core_shape(scene)
        self.name = f"{bearer.name}, {self._system.name}"
        self.part = self._system.name
        self.key = (bearer.as_pointer(), self.part)

    @staticmethod
    def is_hair(system: bpy.types.ParticleSystem) -> bool:
        return system.settings.type == "HAIR" and system.settings.render_type == "PATH"

    def worn(self, slots: tuple[int, ...]) -> tuple[int, ...]:
        return (slots[min(self._settings.material, len(slots)) - 1],)

    def pose(self) -> Pose:
        return Pose(self._grown()[1].reshape(-1, 3))

    def _grown(self) -> tuple[list[int], np.ndarray, np.ndarray]:
        """Blender's numbers of the strands that have a length, their keys, and how far it is from
        key to key."""
        strands = self._strands()
        keys = self._keys(strands)
        lengths = np.linalg.norm(np.diff(keys, axis=1), axis=2)
        is_long = lengths.sum(axis=1) > 0.0  # NaN is not
        return np.array(strands)[is_long].tolist(), keys[is_long], lengths[is_long]

    def add(
        self, core_scene, material_ids: list[int], reads_uvs: bool, motion: list[Pose]
    ) -> int | None:
        strands, keys, lengths = self._grown()
        uvs_read = core_scene.uv_layers_read(material_ids) + ([""] if reads_uvs else [])
        count, steps, _ = keys.shape
        if count == 0:
            return None
        return core_scene.add_curves(
            self.name,
            keys.reshape(-1, 3),
            self._radii(lengths).ravel(),
            np.arange(count) * steps,
            shape=self._shape,
            uvs=self._uvs(strands, uvs_read),
            attributes=self._colors(strands, steps, core_scene.attributes_read(material_ids)),
            active_uv=self._active_uv(),
            texture_space=texture_space(self._bearer.data),
            **motion_arguments(motion),
        )

    def _strands(self) -> range:
        """Blender's numbers of the strands: children, where there are any, stand for all."""
        parents, children = len(self._system.particles), len(self._system.child_particles)
        has_children = self._settings.child_type != "NONE" and children > 0
        return range(parents if has_children else 0, parents + children)

    def _keys(self, strands: range) -> np.ndarray:
        """(strands, keys, 3) in the bearer's space."""
        settings = self._settings
        steps = 2**settings.render_step + 1
        if settings.kink == "SPIRAL":
            steps += settings.kink_extra_steps
        co_hair, bearer = self._system.co_hair, self._bearer
        numbers = (
            coordinate
            for strand in strands
            for step in range(steps)
            for coordinate in co_hair(object=bearer, particle_no=strand, step=step)
        )
        shape = (len(strands), steps, 3)
        world = np.fromiter(numbers, np.float64, len(strands) * steps * 3).reshape(shape)
        to_object = np.array(bearer.matrix_world.inverted_safe(), np.float64)
        return (world @ to_object[:3, :3].T + to_object[:3, 3]).astype(np.float32)

    def _radii(self, lengths: np.ndarray) -> np.ndarray:
        """(strands, keys): from root to tip by length; a high shape stays wide for long."""
        settings = self._settings
        along = np.cumsum(lengths, axis=1)
        along = np.pad(along / along[:, -1:], ((0, 0), (1, 0)))
        shape = settings.shape
        power = 1.0 + shape if shape < 0.0 else 1.0 / (1.0 - shape) if shape < 1.0 else np.inf
        rest = np.where(along < 1.0, np.maximum(1.0 - along, 0.0) ** power, 0.0)
        root, tip = settings.root_radius, settings.tip_radius
        radii = (tip + rest * (root - tip)) * settings.radius_scale * 0.5
        if settings.use_close_tip:
            radii[:, -1] = 0.0
        return np.maximum(radii, 0.0).astype(np.float32)

    def _at_roots(self, strands: list[int], read) -> np.ndarray:
        """What read(particle, strand) finds on the surface under each strand."""
        particles = self._system.particles
        parent = particles[0]
        return np.array(
            [read(particles[i] if i < len(particles) else parent, i) for i in strands], np.float32
        )

    def _active_uv(self) -> str:
        layers = self._bearer.data.uv_layers
        return next((layer.name for layer in layers if layer.active_render), "")

    def _uvs(self, strands: list[int], names_read: list[str]) -> dict[str, np.ndarray]:
        wanted = {name or self._active_uv() for name in names_read}
        system, modifier = self._system, self._modifier
        return {
            layer.name: self._at_roots(
                strands,
                lambda particle, strand, number=number: system.uv_on_emitter(
                    modifier=modifier, particle=particle, particle_no=strand, uv_no=number
                ),
            )
            for number, layer in enumerate(self._bearer.data.uv_layers)
            if layer.name in wanted
        }

    def _colors(
        self, strands: list[int], steps: int, names_read: list[str]
    ) -> dict[str, np.ndarray]:
        """The colour attributes that Blender knows at roots, linear, one value a key."""
        mesh = self._bearer.data
        known = [
            layer
            for layer in mesh.color_attributes
            if (layer.domain, layer.data_type) == ("CORNER", "BYTE_COLOR")
        ]
        rendered = mesh.color_attributes.render_color_index
        system, modifier = self._system, self._modifier
        colors = {}
        for number, layer in enumerate(known):
            names = {layer.name}
            if rendered >= 0 and layer == mesh.color_attributes[rendered]:
                names.add("")
            for name in names.intersection(names_read):
                rgb = self._at_roots(
                    strands,
                    lambda particle, strand, number=number: system.mcol_on_emitter(
                        modifier=modifier, particle=particle, particle_no=strand, vcol_no=number
                    ),
                )
                rgba = np.ones((len(strands), 4), np.float32)
                rgba[:, :3] = _linear(rgb)
                colors[name] = np.repeat(rgba, steps, axis=0)
        return colors


def _linear(srgb: np.ndarray) -> np.ndarray:
    """IEC 61966-2-1."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
