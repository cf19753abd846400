"""Procedural textures, on a wall that shines with them."""

import math
from itertools import product

import bpy
from features import feature
from stage import tiles, wall
from tree import Tree, out

# Where the wall is in the textures' space: no lattice plane of any noise.
PLACE = (0.31, 0.17, 0.437)


def coordinate(tree: Tree):
    """A point for each point of the wall: (0, 0) to (1, 1) off the lattice."""
    return tree.vector_math("ADD", out(tree.node("TexCoord"), "UV"), PLACE)


def texture(kind: str, inputs: dict | None = None, output: str = "Color", **properties):
    """Paints with one output of a texture node."""

    def paint(tree: Tree):
        node = tree.node(kind, {}, **properties)
        if any(socket.identifier == "Vector" for socket in node.inputs):
            tree.set(node, "Vector", coordinate(tree))
        for identifier, value in (inputs or {}).items():
            tree.set(node, identifier, value)
        return out(node, output)

    return paint


@feature()
def checker():
    """Checker"""
    colors = {"Color1": (0.8, 0.2, 0.1), "Color2": (0.1, 0.3, 0.6)}
    wall(texture("TexChecker", {"Scale": 6.0, **colors}))


@feature()
def noise():
    """Noise, its value"""
    wall(texture("TexNoise", {"Scale": 5.0, "Detail": 2.0}, "Fac"))


@feature()
def noise_color():
    """Noise, its colour, with eight octaves"""
    wall(texture("TexNoise", {"Scale": 4.0, "Detail": 8.0, "Roughness": 0.6}))


@feature()
def noise_distorted():
    """Distorted noise"""
    wall(texture("TexNoise", {"Scale": 3.0, "Detail": 2.5, "Distortion": 1.5}, "Fac"))


@feature()
def noise_dimensions():
    """Noise in one to four dimensions"""
    inputs = {"1D": {"W": 0.3}, "2D": {}, "3D": {}, "4D": {"W": 1.7}}
    paints = []
    for dimensions, more in inputs.items():

        def paint(tree: Tree, dimensions=dimensions, more=more):
            node = tree.node("TexNoise", {"Scale": 5.0}, noise_dimensions=dimensions)
            x = tree.node("SeparateXYZ", {"Vector": coordinate(tree)})
            tree.set(node, "Vector", coordinate(tree))
            for name, value in more.items():
                tree.set(node, name, tree.math("ADD", value, out(x, "X")))
            return out(node, "Color")

        paints.append(paint)
    tiles(paints)


def musgrave(kind: str, dimensions: str = "3D", offset: float = 0.3, gain: float = 1.4):
    """Paints with what was the Musgrave texture, and is in Noise since Blender 4.1."""
    detail, dimension, lacunarity, scale = 4.0, 0.8, 2.2, 4.0

    def paint(tree: Tree):
        inputs = {"Vector": coordinate(tree), "Scale": scale, "Lacunarity": lacunarity}
        inputs |= {"Offset": offset, "Gain": gain}
        if bpy.app.version < (4, 1, 0):
            inputs |= {"Detail": detail, "Dimension": dimension}
            names = {"musgrave_type": kind, "musgrave_dimensions": dimensions}
            node = tree.node("TexMusgrave", inputs, **names)
        else:
            inputs |= {"Detail": detail - 1.0, "Roughness": lacunarity**-dimension}
            names = {"noise_type": kind, "noise_dimensions": dimensions, "normalize": False}
            node = tree.node("TexNoise", inputs, **names)
        return tree.math("MULTIPLY_ADD", out(node, "Fac"), 0.35, 0.3)

    return paint


@feature()
def musgrave_fbm():
    """Noise that is not normalized: the former Musgrave's fBM"""
    wall(musgrave("FBM"))


@feature()
def musgrave_multifractal():
    """Multifractal noise"""
    wall(musgrave("MULTIFRACTAL"))


@feature()
def musgrave_ridged():
    """Ridged multifractal noise"""
    wall(musgrave("RIDGED_MULTIFRACTAL", offset=0.9, gain=2.0))


@feature()
def musgrave_hybrid():
    """Hybrid multifractal noise"""
    wall(musgrave("HYBRID_MULTIFRACTAL"))


@feature()
def musgrave_terrain():
    """Hetero terrain, in two dimensions"""
    wall(musgrave("HETERO_TERRAIN", "2D"))


def voronoi(output: str = "Distance", inputs: dict | None = None, **properties):
    return texture("TexVoronoi", {"Scale": 5.0, **(inputs or {})}, output, **properties)


@feature()
def voronoi_f1():
    """Distance to the nearest point"""
    wall(voronoi())


@feature()
def voronoi_color():
    """Colour of the cell"""
    wall(voronoi("Color"))


@feature()
def voronoi_position():
    """Position of the nearest point"""

    def paint(tree: Tree):
        return tree.scaled(voronoi("Position")(tree), 0.4, 0.0)

    wall(paint)


@feature()
def voronoi_f2():
    """The second nearest point, less random"""
    wall(voronoi("Distance", {"Randomness": 0.6}, feature="F2"))


@feature()
def voronoi_smooth():
    """Smoothed distance"""
    wall(voronoi("Distance", {"Smoothness": 0.7}, feature="SMOOTH_F1"))


@feature()
def voronoi_smooth_color():
    """Smoothed colour"""
    wall(voronoi("Color", {"Smoothness": 0.4}, feature="SMOOTH_F1"))


@feature()
def voronoi_edge():
    """Distance to the edge"""
    wall(voronoi("Distance", feature="DISTANCE_TO_EDGE"))


@feature()
def voronoi_sphere():
    """Radius of the sphere within the cell"""
    wall(voronoi("Radius", {"Scale": 3.0}, feature="N_SPHERE_RADIUS"))


@feature()
def voronoi_metrics():
    """Manhattan, Chebychev and Minkowski distances"""
    metrics = ("EUCLIDEAN", "MANHATTAN", "CHEBYCHEV", "MINKOWSKI")
    tiles([voronoi("Distance", {"Exponent": 0.7} if d == "MINKOWSKI" else {}, distance=d)
           for d in metrics])  # fmt: skip


@feature()
def voronoi_dimensions():
    """Voronoi cells in one, two and four dimensions"""
    tiles(
        [
            voronoi("Color", {"W": 0.37} if "1D" in d or "4D" in d else {}, voronoi_dimensions=d)
            for d in ("2D", "4D")
        ]
        + [voronoi("W", {"W": 0.37}, voronoi_dimensions="4D"), voronoi(voronoi_dimensions="2D")]
    )


@feature(since=(4, 0))
def voronoi_fractal():
    """Voronoi with octaves"""
    inputs = {"Detail": 3.0, "Roughness": 0.6, "Lacunarity": 2.0, "Scale": 3.0}
    wall(texture("TexVoronoi", inputs, "Distance", normalize=True))


@feature()
def wave_bands():
    """Bands along X, Y, Z and the diagonal, sine"""
    inputs = {"Scale": 2.0}
    tiles([texture("TexWave", inputs, "Fac", wave_type="BANDS", bands_direction=d)
           for d in ("X", "Y", "Z", "DIAGONAL")])  # fmt: skip


@feature()
def wave_rings():
    """Rings about X, Y, Z and spherical ones; saw, triangle"""
    inputs = {"Scale": 2.0, "Phase Offset": 1.0}
    kinds = zip(("X", "Y", "Z", "SPHERICAL"), ("SAW", "TRI", "SIN", "SAW"), strict=True)
    tiles([texture("TexWave", inputs, "Fac", wave_type="RINGS", rings_direction=d, wave_profile=p)
           for d, p in kinds])  # fmt: skip


@feature()
def wave_distorted():
    """Distorted bands"""
    inputs = {"Scale": 2.0, "Distortion": 6.0, "Detail": 2.0, "Detail Scale": 1.5}
    wall(texture("TexWave", inputs))


@feature()
def magic():
    """Magic of depth 2 and 6"""
    inputs = {"Scale": 3.0, "Distortion": 1.5}
    tiles([texture("TexMagic", inputs, turbulence_depth=depth) for depth in (0, 2, 6, 10)])


@feature()
def brick():
    """Bricks, offset and squashed"""
    inputs = {"Scale": 3.0, "Mortar Size": 0.05, "Mortar Smooth": 0.3, "Bias": -0.2}
    inputs |= {"Color1": (0.8, 0.3, 0.2), "Color2": (0.4, 0.1, 0.1), "Mortar": (0.6, 0.6, 0.5)}
    wall(texture("TexBrick", inputs, offset=0.4, squash=1.5, squash_frequency=3))


@feature()
def brick_squashed_to_nothing():
    """Bricks, every third row squashed to no width"""
    inputs = {"Scale": 2.0, "Mortar Size": 0.05, "Mortar Smooth": 0.3}
    inputs |= {"Color1": (0.8, 0.3, 0.2), "Color2": (0.4, 0.1, 0.1), "Mortar": (0.6, 0.6, 0.5)}
    wall(texture("TexBrick", inputs, squash=0.0, squash_frequency=3))


@feature()
def gradient():
    """All seven gradients"""

    def paint(kind: str):
        def centred(tree: Tree):
            point = tree.node("TexCoord")
            vector = tree.vector_math("ADD", out(point, "UV"), (-0.3, -0.3, 0.0))
            return out(tree.node("TexGradient", {"Vector": vector}, gradient_type=kind), "Fac")

        return centred

    kinds = ("LINEAR", "QUADRATIC", "EASING", "DIAGONAL", "SPHERICAL", "QUADRATIC_SPHERE",
             "RADIAL")  # fmt: skip
    tiles([paint(kind) for kind in kinds])


@feature()
def white_noise():
    """White noise on a grid of cells, in one to four dimensions"""

    def paint(dimensions: str, output: str):
        def cells(tree: Tree):
            cell = tree.vector_math("FLOOR", tree.scaled(coordinate(tree), 8.0, 0.0))
            node = tree.node("TexWhiteNoise", noise_dimensions=dimensions)
            if dimensions != "1D":
                tree.set(node, "Vector", cell)
            if dimensions in ("1D", "4D"):
                tree.set(node, "W", out(tree.node("SeparateXYZ", {"Vector": cell}), "X"))
            return out(node, output)

        return cells

    tiles([paint(d, o) for d, o in product(("1D", "2D", "3D", "4D"), ("Value", "Color"))], 2)


@feature(since=(4, 3))
def gabor():
    """Gabor noise, its value and its phase"""
    inputs = {"Scale": 4.0, "Frequency": 2.0, "Anisotropy": 0.8}
    inputs |= {"Orientation 2D": math.pi / 5}
    tiles([texture("TexGabor", inputs, output) for output in ("Value", "Phase")], 2)


@feature(since=(4, 3))
def gabor_isotropic():
    """Gabor noise of waves in all directions, its value and its intensity"""
    inputs = {"Scale": 5.0, "Frequency": 1.2, "Anisotropy": 0.0}
    tiles([texture("TexGabor", inputs, output) for output in ("Value", "Intensity")], 2)


@feature(since=(4, 3))
def gabor_in_space():
    """Gabor noise in three dimensions: value, phase and intensity, of one direction and of many"""
    inputs = {"Scale": 4.0, "Frequency": 2.0, "Orientation 3D": (0.3, 1.0, 0.5)}
    tiles(
        [
            texture("TexGabor", inputs | {"Anisotropy": anisotropy}, output, gabor_type="3D")
            for anisotropy in (1.0, 0.3)
            for output in ("Value", "Phase", "Intensity")
        ],
        3,
    )
