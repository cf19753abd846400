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
]

PUPIL_MODES = [
    ("AUTO", "Automatic", "The pupil follows the luminance of the scene and the age", 0),
    ("MANUAL", "Manual", "The pupil has the diameter given here", 1),
]

PUPIL_FORMULAS = [
    ("WATSON_YELLOTT", "Watson & Yellott", "Unified formula of 2012, with field area and age", 0),
    ("BLACKIE_HOWLAND", "Blackie & Howland", "Formula of 1999, from luminance alone", 1),
    ("PAPER", "Wang & Xiao 2013", "The paper's formula, from Gaussian-weighted luminance", 2),
]

FOCUS_MODES = [
    ("RELAXED", "Relaxed", "The eye rests at its far point", 0),
    ("DISTANCE", "Distance", "The eye looks at the camera's focus distance or object", 1),
    ("CENTER", "Image Centre", "The eye looks at what lies in the middle of the picture", 2),
]

PUPIL_PATTERNS = [
    ("SOBOL", "Sobol", "Low-discrepancy points, evenly spread over the pupil", 0),
    ("CIRCINATE", "Circinate", "The rings of points of Wang & Xiao 2013", 1),
]

QUALITIES = [
    ("DRAFT", "Draft", "16 samples for each pixel", 0),
    ("PREVIEW", "Preview", "64 samples for each pixel", 1),
    ("FINAL", "Final", "256 samples for each pixel", 2),
    ("REFERENCE", "Reference", "4096 samples for each pixel", 3),
    ("CUSTOM", "Custom", "The number of samples is given below", 4),
]
QUALITY_SAMPLES = {"DRAFT": 16, "PREVIEW": 64, "FINAL": 256, "REFERENCE": 4096}

PUPIL_RANGE_MM = (0.1, 12.0)
FOCUS_RANGE_M = (0.01, 1e9)
AGE_RANGE_YEARS = (1.0, 120.0)
SAMPLES_RANGE = (1, 1 << 20)
SEED_RANGE = (0, (1 << 31) - 1)
