"""What Eye Render does not show yet: how far each scene may be off, as mean FLIP, and why. Whoever
builds a feature takes its scenes from here, and `run compare` says which can go."""

NOT_YET: dict[str, tuple[float, str]] = {
    "geometry/hair_thick": (0.45, "hair is not traced yet"),
    "geometry/hair_ribbons": (0.45, "hair is not traced yet"),
    "geometry/hair_children": (0.65, "hair is not traced yet"),
    "geometry/hair_curves": (0.18, "hair is not traced yet"),
    "geometry/point_cloud": (0.31, "point clouds are not exported yet"),
    "motion/of_object": (0.14, "motion blur is not there yet"),
    "motion/of_turning": (0.07, "motion blur is not there yet"),
    "motion/of_camera": (0.12, "motion blur is not there yet"),
    "motion/of_deformation": (0.04, "motion blur is not there yet"),
    "shaders/subsurface": (0.08, "the random walk is a little darker than Cycles'"),
    "volumes/absorption": (0.42, "volumes are not traced yet"),
    "volumes/scatter": (0.16, "volumes are not traced yet"),
    "volumes/emission": (0.52, "volumes are not traced yet"),
    "volumes/absorbing_glass": (0.47, "volumes are not traced yet"),
    "worlds/fog": (0.77, "volumes of the world are not traced yet"),
    "worlds/absorbing_fog": (0.96, "volumes of the world are not traced yet"),
}
