"""The Random of the Object Info node: the number that Cycles gives each object."""

import bpy

_MASK = 0xFFFFFFFF
_LARGEST_BELOW_ONE = 1.0 - 2.0**-24


def random_of(instance: bpy.types.DepsgraphObjectInstance) -> float:
    """From 0 to below 1: of an instance Blender's own number, of an object a hash of its name."""
    number = instance.random_id if instance.is_instance else _hash_name(instance.object.name)
    return fraction_of(number)


def fraction_of(number: int) -> float:
    """The 32 bits as a number from 0 to below 1."""
    return min((number & _MASK) / _MASK, _LARGEST_BELOW_ONE)


def _hash_name(name: str) -> int:
    number = 0
    for byte in name.encode():
        number = (number * 37 + byte) & _MASK
    return hash_number(number, words=2)


def hash_number(key: int, words: int) -> int:
    """The final mixing of Bob Jenkins' lookup3 (2006) for words that are zero but the first."""
    c = b = 0xDEADBEEF + (words << 2) + 13
    a = b + key
    state = [a, b, c]
    # Each step changes the first word by the second, which it also turns by some bits.
    for target, other, bits in (
        (2, 1, 14),
        (0, 2, 11),
        (1, 0, 25),
        (2, 1, 16),
        (0, 2, 4),
        (1, 0, 14),
        (2, 1, 24),
    ):
        turned = state[other] & _MASK
        turned = (turned << bits | turned >> (32 - bits)) & _MASK
        state[target] = ((state[target] ^ state[other]) - turned) & _MASK
    return state[2]
