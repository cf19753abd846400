"""Writes tables of what Blender's own texture nodes answer: tests/data/nodes/*.csv.

Geometry Nodes evaluate the same texture nodes as materials do, in Blender's C++ code. Here they
read their inputs from attributes of a cloud of points and store their outputs as attributes.

    blender -b --factory-startup --python tests/tools/texture_references.py -- FOLDER

with Blender 4.3. A table has a column for each option, input and output, by Blender's names. Each
number is a float, written so that it reads back as the same; an empty cell is an output that the
node does not have with these options.
"""

import csv
import itertools
import sys
from collections.abc import Iterator
from pathlib import Path

import bpy
import numpy as np

WIDTH = {"VALUE": 1, "VECTOR": 3, "RGBA": 4}
ATTRIBUTE_TYPE = {"VALUE": "FLOAT", "VECTOR": "FLOAT_VECTOR", "RGBA": "FLOAT_COLOR"}
ATTRIBUTE_FIELD = {"VALUE": "value", "VECTOR": "vector", "RGBA": "color"}
DIMENSIONS = ["1D", "2D", "3D", "4D"]

# What an input is drawn from: ordinary values, Blender's limits and what is beyond them. The first
# is the usual one.
INPUTS = {
    "Scale": [1.0, 5.0, 0.37, -2.5, 0.0],
    "Detail": [0.0, 1.0, 2.0, 2.5, 3.75, 8.2, 15.0],
    "Roughness": [0.5, 0.0, 0.3, 0.77, 1.0],
    "Lacunarity": [2.0, 1.0, 2.31, 0.5, 3.7],
    "Offset": [0.0, 0.3, 1.0, -0.4],
    "Gain": [1.0, 0.6, 2.2],
    "Distortion": [0.0, 0.4, 1.0, -2.2],
    "Smoothness": [1.0, 0.5, 0.13, 0.0, 2.0],
    "Exponent": [0.5, 1.0, 2.0, 3.3, 17.0],
    "Randomness": [1.0, 0.6, 0.2, 0.0, 1.8],
    "Detail Scale": [1.0, 2.7, 0.4],
    "Detail Roughness": [0.5, 0.0, 0.8, 1.0],
    "Phase Offset": [0.0, 1.1, -5.0],
    "Mortar Size": [0.02, 0.0, 0.06, 0.125],
    "Mortar Smooth": [0.1, 0.0, 0.7, 1.0],
    "Bias": [0.0, -0.4, 0.6, -1.0],
    "Brick Width": [0.5, 0.21, 1.3],
    "Row Height": [0.25, 0.4, 0.11],
    "Frequency": [2.0, 0.5, 3.7, 0.0],
    "Anisotropy": [1.0, 0.0, 0.4, 1.6, -0.3],
    "Orientation 2D": [0.8, 0.0, -2.3, 11.0],
    "Orientation 3D": [1.0, 0.7, -0.4, 0.2],
}
# Beyond the limits where Cycles and Geometry Nodes keep them alike.
INPUTS_OF_NOISE = {"Detail": [17.5, -1.0], "Roughness": [1.3, -0.2]}

OPTIONS = {
    "TEX_NOISE": [
        {"noise_dimensions": dimensions, "noise_type": kind, "normalize": normalize}
        for dimensions in DIMENSIONS
        for kind, normalize in [
            ("FBM", True),
            ("FBM", False),
            ("MULTIFRACTAL", True),
            ("HYBRID_MULTIFRACTAL", True),
            ("RIDGED_MULTIFRACTAL", True),
            ("HETERO_TERRAIN", True),
        ]
    ],
    "TEX_VORONOI": [
        {
            "voronoi_dimensions": dimensions,
            "feature": feature,
            "distance": metric,
            "normalize": normalize,
        }
        for dimensions, feature, metric, normalize in itertools.product(
            DIMENSIONS,
            ["F1", "F2", "SMOOTH_F1", "DISTANCE_TO_EDGE", "N_SPHERE_RADIUS"],
            ["EUCLIDEAN", "MANHATTAN", "CHEBYCHEV", "MINKOWSKI"],
            [False, True],
        )
        if (metric == "EUCLIDEAN" or (dimensions != "1D" and feature in ("F1", "F2", "SMOOTH_F1")))
        and not (normalize and feature == "N_SPHERE_RADIUS")
    ],
    "TEX_WAVE": [
        {
            "wave_type": wave_type,
            "bands_direction": direction if wave_type == "BANDS" else "X",
            "rings_direction": direction if wave_type == "RINGS" else "X",
            "wave_profile": profile,
        }
        for wave_type, last in [("BANDS", "DIAGONAL"), ("RINGS", "SPHERICAL")]
        for direction in ["X", "Y", "Z", last]
        for profile in ["SIN", "SAW", "TRI"]
    ],
    "TEX_MAGIC": [{"turbulence_depth": depth} for depth in range(11)],
    "TEX_BRICK": [
        {
            "offset": offset,
            "offset_frequency": offset_frequency,
            "squash": squash,
            "squash_frequency": squash_frequency,
        }
        for offset, offset_frequency, squash, squash_frequency in [
            (0.5, 2, 1.0, 2),
            (0.0, 1, 1.0, 1),
            (0.3, 3, 1.7, 2),
            (1.0, 1, 0.6, 4),
            (0.75, 99, 2.5, 1),
        ]
    ],
    "TEX_CHECKER": [{}],
    "TEX_GRADIENT": [
        {"gradient_type": kind}
        for kind in [
            "LINEAR",
            "QUADRATIC",
            "EASING",
            "DIAGONAL",
            "SPHERICAL",
            "QUADRATIC_SPHERE",
            "RADIAL",
        ]
    ],
    "TEX_WHITE_NOISE": [{"noise_dimensions": dimensions} for dimensions in DIMENSIONS],
    "TEX_GABOR": [{"gabor_type": kind} for kind in ["2D", "3D"]],
}
ROWS = {
    "TEX_NOISE": 32,
    "TEX_VORONOI": 16,
    "TEX_WAVE": 20,
    "TEX_MAGIC": 24,
    "TEX_BRICK": 80,
    "TEX_CHECKER": 200,
    "TEX_GRADIENT": 30,
    "TEX_WHITE_NOISE": 50,
    "TEX_GABOR": 150,
}


def coordinates(rng: np.random.Generator, shape: tuple[int, ...]) -> np.ndarray:
    """A few cells from the origin; some whole numbers."""
    values = rng.uniform(-1.2, 1.2, shape)
    kind = rng.uniform(size=shape)
    values = np.where(kind < 0.5, 4.0 * values, values)
    values = np.where(kind < 0.1, np.round(4.0 * values), values)
    return np.where(kind > 0.94, 20.0 * values, values)


class TextureNode:
    """One texture node in a Geometry Nodes tree on a mesh of points."""

    def __init__(self, node_type: str, options: dict) -> None:
        self.tree = bpy.data.node_groups.new("reference", "GeometryNodeTree")
        for in_out in ("INPUT", "OUTPUT"):
            self.tree.interface.new_socket(
                "Geometry", in_out=in_out, socket_type="NodeSocketGeometry"
            )
        words = "".join(word.capitalize() for word in node_type.removeprefix("TEX_").split("_"))
        self.node = self.tree.nodes.new("ShaderNodeTex" + words)
        assert self.node.type == node_type
        for name, value in options.items():
            setattr(self.node, name, value)
        self.inputs = {s.identifier: s.type for s in self.node.inputs}
        self.outputs = {s.identifier: s.type for s in self.node.outputs if s.enabled}
        self._link()

    def _link(self) -> None:
        nodes, links = self.tree.nodes, self.tree.links
        for socket in self.node.inputs:
            reader = nodes.new("GeometryNodeInputNamedAttribute")
            reader.data_type = ATTRIBUTE_TYPE[socket.type]
            reader.inputs["Name"].default_value = "in " + socket.identifier
            output = next(s for s in reader.outputs if s.enabled and s.name == "Attribute")
            links.new(output, socket)
        geometry = nodes.new("NodeGroupInput").outputs["Geometry"]
        for socket in self.node.outputs:
            if not socket.enabled:
                continue
            store = nodes.new("GeometryNodeStoreNamedAttribute")
            store.data_type = ATTRIBUTE_TYPE[socket.type]
            store.inputs["Name"].default_value = "out " + socket.identifier
            links.new(geometry, store.inputs["Geometry"])
            value = next(s for s in store.inputs if s.enabled and s.name == "Value")
            links.new(socket, value)
            geometry = store.outputs["Geometry"]
        links.new(geometry, nodes.new("NodeGroupOutput").inputs["Geometry"])

    def evaluate(self, values: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Float32 arrays of (points, width), by socket identifier."""
        points = len(next(iter(values.values())))
        mesh = bpy.data.meshes.new("points")
        mesh.from_pydata([(0.0, 0.0, 0.0)] * points, [], [])
        for name, array in values.items():
            kind = self.inputs[name]
            attribute = mesh.attributes.new("in " + name, ATTRIBUTE_TYPE[kind], "POINT")
            attribute.data.foreach_set(ATTRIBUTE_FIELD[kind], array.ravel())
        shown = bpy.data.objects.new("points", mesh)
        bpy.context.collection.objects.link(shown)
        shown.modifiers.new("nodes", "NODES").node_group = self.tree
        result = shown.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        answers = {}
        for name, kind in self.outputs.items():
            array = np.empty(points * WIDTH[kind], np.float32)
            result.attributes["out " + name].data.foreach_get(ATTRIBUTE_FIELD[kind], array)
            answers[name] = array.reshape(points, -1)[:, :3]
        bpy.data.objects.remove(shown)
        bpy.data.meshes.remove(mesh)
        return answers


def drawn_inputs(
    rng: np.random.Generator, node_type: str, sockets: dict[str, str], rows: int
) -> dict[str, np.ndarray]:
    values = {}
    for name, kind in sockets.items():
        shape = (rows, WIDTH[kind])
        if kind == "RGBA":
            array = rng.uniform(0.0, 1.0, shape)
        elif name in ("Vector", "W"):
            array = coordinates(rng, shape)
        else:
            choice = INPUTS[name]
            if node_type == "TEX_NOISE":
                choice = choice + INPUTS_OF_NOISE.get(name, [])
            array = np.where(rng.uniform(size=shape) < 0.5, choice[0], rng.choice(choice, shape))
        values[name] = array
    if "Detail" in values:
        keep_digits(values)
    if node_type == "TEX_NOISE":
        repeat_far_away(values)
    if node_type == "TEX_MAGIC":
        # Cycles repeats the coordinates of Magic every 2 pi, Geometry Nodes do not.
        values["Vector"] = np.clip(values["Vector"], -6.0, 6.0)
    return {name: array.astype(np.float32) for name, array in values.items()}


def keep_digits(values: dict[str, np.ndarray]) -> None:
    """High octaves of coordinates that rounding has moved are noise: let them weigh little."""
    is_deep = values["Detail"] > 4.0
    for name in ("Roughness", "Detail Roughness"):
        if name in values:
            values[name] = np.where(is_deep, np.minimum(values[name], 0.5), values[name])
    if "Lacunarity" in values:
        values["Lacunarity"] = np.where(is_deep, 2.0, values["Lacunarity"])


def repeat_far_away(values: dict[str, np.ndarray]) -> None:
    """The last rows of Noise lie where it repeats."""
    far = [[99_999.5, 0.3, -0.4], [123_456.75, -250_000.25, 0.8], [-1_200_000.5, 0.6, 3e6]]
    values["Vector"][-len(far) :] = far
    values["W"][-len(far) :, 0] = [199_999.75, -140_000.5, 1e7]
    for name in ("Detail", "Distortion"):
        values[name][-len(far) :] = 0.0
    values["Scale"][-len(far) :] = 1.0


def cell(numbers: np.ndarray) -> str:
    return " ".join(f"{number:.9g}" for number in numbers[:3])


def table(node_type: str) -> Iterator[list[str]]:
    rng = np.random.default_rng(4302)
    sample = TextureNode(node_type, OPTIONS[node_type][0]).node
    outputs = [s.identifier for s in sample.outputs]
    inputs = [s.identifier for s in sample.inputs]
    yield [
        *(f"option {name}" for name in OPTIONS[node_type][0]),
        *(f"in {name}" for name in inputs),
        *(f"out {name}" for name in outputs),
    ]
    for options in OPTIONS[node_type]:
        node = TextureNode(node_type, options)
        values = drawn_inputs(rng, node_type, node.inputs, ROWS[node_type])
        answers = node.evaluate(values)
        if node_type == "TEX_GRADIENT":
            # Cycles keeps it in range, Geometry Nodes do not.
            answers = {name: np.clip(array, 0.0, 1.0) for name, array in answers.items()}
        for row in range(ROWS[node_type]):
            yield [
                *(str(int(v)) if isinstance(v, bool) else str(v) for v in options.values()),
                *(cell(values[name][row]) for name in inputs),
                *(cell(answers[name][row]) if name in answers else "" for name in outputs),
            ]


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for node_type in OPTIONS:
        with open(folder / f"{node_type.lower()}.csv", "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(table(node_type))


if __name__ == "__main__":
    main(Path(sys.argv[sys.argv.index("--") + 1]))
