"""What Eye Render does not show yet: how far each scene may be off, as mean FLIP, and why. Whoever
builds a feature takes its scenes from here, and `run compare` says which can go."""

NOT_YET: dict[str, tuple[float, str]] = {
    "shaders/subsurface": (0.08, "the random walk is a little darker than Cycles'"),
    "volumes/absorption": (0.42, "volumes are not traced yet"),
    "volumes/scatter": (0.16, "volumes are not traced yet"),
    "volumes/emission": (0.52, "volumes are not traced yet"),
    "volumes/absorbing_glass": (0.47, "volumes are not traced yet"),
    "worlds/fog": (0.77, "volumes of the world are not traced yet"),
    "worlds/absorbing_fog": (0.96, "volumes of the world are not traced yet"),
}
