"""The cases of hit_references.py: which nodes, with which options, on which inputs."""

GENERATED = ["TEX_COORD", "Generated"]
OBJECT = ["TEX_COORD", "Object"]
POSITION = ["NEW_GEOMETRY", "Position"]


def cases() -> list[dict]:
    """`options` are the core's, `set` what Blender's node is told in their place."""
    rows = [
        ("TEX_COORD", {}, {}, ["Generated", "Normal", "UV", "Object", "Camera", "Window"]),
        ("TEX_COORD", {}, {}, ["Reflection"]),
        (
            "NEW_GEOMETRY",
            {},
            {},
            ["Position", "Normal", "Tangent", "True Normal", "Incoming", "Parametric"],
        ),
        ("NEW_GEOMETRY", {}, {}, ["Backfacing"]),
        ("UVMAP", {"uv_map": "second"}, {}, ["UV"]),
        ("UVMAP", {"uv_map": "absent"}, {}, ["UV"]),
        ("ATTRIBUTE", {"attribute_name": "paint"}, {}, ["Color", "Vector", "Fac", "Alpha"]),
        ("ATTRIBUTE", {"attribute_name": "weight"}, {}, ["Color", "Vector", "Fac", "Alpha"]),
        ("ATTRIBUTE", {"attribute_name": "absent"}, {}, ["Color", "Vector", "Fac", "Alpha"]),
        ("VERTEX_COLOR", {"layer_name": "paint"}, {}, ["Color", "Alpha"]),
        ("VERTEX_COLOR", {"layer_name": "absent"}, {}, ["Color", "Alpha"]),
        ("OBJECT_INFO", {}, {}, ["Location", "Color", "Alpha", "Object Index", "Material Index"]),
        ("CAMERA", {}, {}, ["View Vector", "View Z Depth", "View Distance"]),
        ("LIGHT_PATH", {}, {}, ["Is Camera Ray", "Is Shadow Ray", "Ray Depth"]),
        ("FRESNEL", {}, {"IOR": 1.45}, ["Fac"]),
        ("FRESNEL", {}, {"IOR": 0.7}, ["Fac"]),
        ("LAYER_WEIGHT", {}, {"Blend": 0.3}, ["Fresnel", "Facing"]),
        ("LAYER_WEIGHT", {}, {"Blend": 0.8}, ["Fresnel", "Facing"]),
        ("WIREFRAME", {}, {"Size": 0.12}, ["Fac"]),
        ("TEX_IMAGE", {"texture": 0}, {}, ["Color", "Alpha"]),
        ("TEX_IMAGE", {"texture": 0}, {"Vector": GENERATED}, ["Color"]),
        (
            "TEX_IMAGE",
            {"texture": 0, "projection": "SPHERE"},
            {"Vector": GENERATED},
            ["Color"],
        ),
        ("TEX_IMAGE", {"texture": 0, "projection": "TUBE"}, {"Vector": GENERATED}, ["Color"]),
        ("TEX_IMAGE", {"texture": 0, "projection": "BOX"}, {"Vector": GENERATED}, ["Color"]),
        (
            "TEX_IMAGE",
            {"texture": 0, "projection": "BOX", "projection_blend": 0.4},
            {"Vector": GENERATED},
            ["Color"],
        ),
        (
            "TEX_IMAGE",
            {"texture": 0, "projection": "BOX", "projection_blend": 1.0},
            {"Vector": GENERATED},
            ["Color"],
        ),
        ("TEX_IMAGE", {"tiles": [1001, 1, 1002, 2, 1011, 3]}, {"Vector": OBJECT}, ["Color"]),
        (
            "TEX_IMAGE",
            {"tiles": [1001, 1, 1002, 2, 1011, 3]},
            {"Vector": POSITION},
            ["Color", "Alpha"],
        ),
        ("TEX_ENVIRONMENT", {"texture": 0}, {}, ["Color"]),
        ("TEX_ENVIRONMENT", {"texture": 0}, {"Vector": OBJECT}, ["Color"]),
        (
            "TEX_ENVIRONMENT",
            {"texture": 0, "projection": "MIRROR_BALL"},
            {"Vector": OBJECT},
            ["Color"],
        ),
    ]
    for direction, axis in (("RADIAL", "X"), ("RADIAL", "Y"), ("RADIAL", "Z"), ("UV_MAP", "Z")):
        options = {"direction_type": direction, "axis": axis}
        rows.append(("TANGENT", options, {}, ["Tangent"]))
    color = [0.7, 0.35, 0.9]
    for space in ("TANGENT", "OBJECT", "WORLD", "BLENDER_OBJECT", "BLENDER_WORLD"):
        for strength in (0.0, 0.6, 1.0, 1.7):
            inputs = {"Strength": strength, "Color": color}
            rows.append(("NORMAL_MAP", {"space": space}, inputs, ["Normal"]))
    return [dict(zip(("node", "options", "inputs", "outputs"), row, strict=True)) for row in rows]


def height_cases() -> list[dict]:
    """Normals that a height bends: the mean of the object's or the world's coordinates."""
    return [
        {"node": "BUMP", "options": {"invert": invert}, "inputs": inputs, "outputs": ["Normal"]}
        for invert in (False, True)
        for inputs in (
            {"Strength": 1.0, "Distance": 0.5},
            {"Strength": 0.4, "Distance": 0.5},
            {"Strength": 1.0, "Distance": -0.3},
        )
    ]


def displacement_cases() -> list[dict]:
    """What the surface's normal is with the displacement shown as bump."""
    return [
        {"node": "DISPLACEMENT", "options": {"space": space}, "inputs": {"Scale": 0.3}}
        for space in ("OBJECT", "WORLD")
    ] + [
        {"node": "VECTOR_DISPLACEMENT", "options": {"space": space}, "inputs": {"Scale": 0.3}}
        for space in ("TANGENT", "OBJECT", "WORLD")
    ]
