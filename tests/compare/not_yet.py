"""What Eye Render does not show yet: how far each scene may be off, as mean FLIP, and why. Whoever
builds a feature takes its scenes from here, and `run compare` says which can go."""

NOT_YET: dict[str, tuple[float, str]] = {
    "shaders/subsurface": (
        0.08,
        "light that enters comes out where it entered: shown as diffuse reflection",
    ),
}
