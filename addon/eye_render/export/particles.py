"""What the Particle Info node tells of an instance that a particle system places."""

import bpy

from .object_random import fraction_of, hash_number

_HASHED_WORDS = 2  # by Cycles for Random: the particle's number, and a zero


def particle_value(
    instance: bpy.types.DepsgraphObjectInstance, output: str, frame: float
) -> float | tuple[float, ...]:
    """By the name of the node's output; of what no particle places as of a particle 0 that never
    was."""
    particle = _particle_of(instance)
    number = instance.persistent_id[0] if particle else 0
    if output == "Random":
        return fraction_of(hash_number(number, _HASHED_WORDS))
    if output == "Index":
        return float(number)
    if particle is None:
        return 0.0
    if output == "Age":
        return frame - particle.birth_time
    return getattr(particle, output.lower().replace(" ", "_"))


def _particle_of(instance: bpy.types.DepsgraphObjectInstance) -> bpy.types.Particle | None:
    """None also for a child of a particle, as in Cycles."""
    system = instance.particle_system
    number = instance.persistent_id[0]
    if system is None or not 0 <= number < len(system.particles):
        return None
    return system.particles[number]
