"""What may be chosen, once for the panels and the command line: names, numbers and limits.

Lists are in Blender's form of enum items: identifier, name, tooltip, number saved in files.
"""

EYES = [
    ("RIGHT", "Right", "Look through the right eye (OD)", 0),
    ("LEFT", "Left", "Look through the left eye (OS)", 1),
]

EYE_MODELS = [
    ("PINHOLE", "Pinhole", "A pupil without width, so that nothing is blurred", 0),
    ("PAPER", "Wang & Xiao 2013", "The thin-lens eye of the paper, astigmatism by angle", 1),
    ("PARAXIAL", "Paraxial", "The dioptric power matrix, exact to first order", 2),
    ("WAVEFRONT", "Wavefront", "Paraxial, with the higher-order aberrations of an eye", 3),
    ("NAVARRO", "Navarro", "Real surfaces: Navarro, Santamaria & Bescos 1985, any angle", 4),
    ("ARIZONA", "Arizona", "Real surfaces: the Arizona eye of Schwiegerling 2004", 5),
    ("LE_GRAND", "Le Grand", "Real surfaces, all spherical: Le Grand's full theoretical eye", 6),
]
SCHEMATIC_MODELS = {"NAVARRO", "ARIZONA", "LE_GRAND"}

REFRACTION_ZEROS = [
    ("PARAXIAL", "Paraxial", "Rays next to the axis come to a focus on the retina", 0),
    (
        "MINIMUM_RMS_SPOT",
        "Smallest Spot",
        "The blur of a point through the whole pupil is least",
        1,
    ),
]

CORRECTIONS = [
    ("NONE", "None", "The naked eye", 0),
    ("GLASSES", "Glasses", "Glasses at the vertex distance", 1),
    ("CONTACTS", "Contacts", "Contact lenses, on the cornea", 2),
]

WORN_PARTS = [
    ("FAR", "Far", "The part of the glasses for looking far away", 0),
    ("NEAR", "Near", "The part of the glasses with the reading addition", 1),
]

WAVEFRONT_SOURCES = [
    ("POPULATION", "Mean Eye", "The mean of 200 healthy eyes (Thibos et al. 2002)", 0),
    ("MEASURED", "Measured", "What was measured in these eyes, from files", 1),
]

PUPIL_MODES = [
    ("AUTO", "Automatic", "The pupil follows the luminance of the scene and the age", 0),
    ("MANUAL", "Manual", "The pupil has the diameter given here", 1),
]

PUPIL_FORMULAS = [
    ("WATSON_YELLOTT", "Watson & Yellott 2012", "Unified, from luminance, field and age", 0),
    ("BLACKIE_HOWLAND", "Blackie & Howland 1999", "From luminance alone", 1),
    ("PAPER", "Wang & Xiao 2013", "The paper's equation 19, as printed", 2),
    ("HOLLADAY", "Holladay 1926", "From luminance alone", 3),
    ("CRAWFORD", "Crawford 1936", "From luminance alone", 4),
    ("MOON_SPENCER", "Moon & Spencer 1944", "From luminance alone", 5),
    ("DE_GROOT_GEBHARD", "De Groot & Gebhard 1952", "From luminance alone", 6),
    ("STANLEY_DAVIES", "Stanley & Davies 1995", "From luminance and field", 7),
    ("BARTEN", "Barten 1999", "From luminance and field", 8),
    ("WINN", "Winn et al. 1994", "From luminance and age", 9),
]

# Those that ask for the adapting field's extent, and for how many eyes see it.
FORMULAS_OF_FIELD = {"WATSON_YELLOTT", "STANLEY_DAVIES", "BARTEN"}
FORMULAS_OF_EYES = {"WATSON_YELLOTT"}

PUPIL_FIELDS = [
    ("CAMERA", "Picture", "The picture's own field, so a wider lens narrows the pupil", 0),
    ("FIXED", "Fixed", "A disc of the given diameter, whatever the lens", 1),
]

FOCUS_MODES = [
    ("RELAXED", "Relaxed", "The eye rests at its far point", 0),
    ("DISTANCE", "Distance", "The eye looks at the camera's focus distance or object", 1),
    ("CENTER", "Image Centre", "The eye looks at what lies in the middle of the picture", 2),
]

STILES_CRAWFORD_MODES = [
    ("OFF", "Off", "Light counts the same wherever it enters the pupil", 0),
    ("BRIGHTNESS", "Brightness", "Shapes blur alone: the picture stays as bright", 1),
    ("ENERGY", "Energy", "The picture darkens by the light that cones do not answer to", 2),
]

AMPLITUDE_FORMULAS = [
    ("HOFSTETTER_MEAN", "Hofstetter, Mean", "Hofstetter 1950, what people of an age have", 0),
    ("HOFSTETTER_MINIMUM", "Hofstetter, Least", "Hofstetter 1950, what all of an age have", 1),
    ("HOFSTETTER_MAXIMUM", "Hofstetter, Most", "Hofstetter 1950, what few of an age have", 2),
    ("ANDERSON", "Anderson et al. 2008", "Measured without asking; less, and none from 49", 3),
]

PUPIL_PATTERNS = [
    ("SOBOL", "Sobol", "Low-discrepancy points, evenly spread over the pupil", 0),
    ("CIRCINATE", "Circinate", "The rings of points of Wang & Xiao 2013", 1),
    ("UNIFORM_RANDOM", "Uniform Random", "Independent points: plain Monte Carlo", 2),
    ("GRID", "Grid", "Rows and columns of points, the same in every pixel", 3),
]

# The errors are of the demo hall, as `run tradeoff` measures them. A test holds them.
QUALITIES = [
    ("DRAFT", "Draft", "16 samples for each pixel: RMSE 0.08, FLIP 0.13 in the demo scene", 0),
    ("PREVIEW", "Preview", "64 samples for each pixel: RMSE 0.04, FLIP 0.08 in the demo scene", 1),
    ("FINAL", "Final", "256 samples for each pixel: RMSE 0.022, FLIP 0.048 in the demo scene", 2),
    ("REFERENCE", "Reference",
     "4096 samples for each pixel: RMSE 0.005, FLIP 0.014 in the demo scene", 3),
    ("CUSTOM", "Custom", "The number of samples is given below", 4),
]  # fmt: skip
QUALITY_SAMPLES = {"DRAFT": 16, "PREVIEW": 64, "FINAL": 256, "REFERENCE": 4096}

# As the core checks them.
PUPIL_RANGE_MM = (0.0, 9.0)
FIELD_RANGE_DEG = (0.1, 180.0)
FOCUS_RANGE_M = (0.01, 1e12)
VERTEX_RANGE_MM = (0.0, 20.0)
AGE_RANGE_YEARS = (0.0, 120.0)
SAMPLES_RANGE = (1, 1 << 24)
SEED_RANGE = (0, (1 << 31) - 1)
