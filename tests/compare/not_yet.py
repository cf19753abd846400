"""What Eye Render does not show yet, and why; how far it is off stands in deviations.csv. Whoever
builds a feature takes its scenes from both, and `run compare` says which can go."""

NOT_YET: dict[str, str] = {}
