"""What Eye Render does not show yet, and why; how far it is off stands in deviations.csv. Whoever
builds a feature takes its scenes from both, and `run compare` says which can go."""

_NO_WALK = "light that enters comes out where it entered: shown as diffuse reflection"

NOT_YET: dict[str, str] = {
    "principled/subsurface": _NO_WALK,
    "shaders/subsurface": _NO_WALK,
}
