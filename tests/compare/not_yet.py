"""What Eye Render does not show yet: how far each scene may be off, as mean FLIP, and why. Whoever
builds a feature takes its scenes from here, and `run compare` says which can go."""

_NO_WALK = "light that enters comes out where it entered: shown as diffuse reflection"

NOT_YET: dict[str, tuple[float, str]] = {
    "principled/subsurface": (0.08, _NO_WALK),
    "shaders/subsurface": (0.08, _NO_WALK),
    "textures/gabor": (0.65, "the texture is not evaluated yet"),
}
