"""A path tracer that sees a scene through a model of one person's eye.

Lengths of the eye are in millimetres or metres as the names say, powers in dioptres, angles in
degrees unless a name ends in _rad. The camera frame is Blender's: the eye looks along -Z, +X
right, +Y up as the patient sees. A slope is (dx, dy) per unit of forward travel. Everything that
is refused raises ValueError with name, value, unit and what is allowed.
"""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
PASSES: list[tuple[str, int, str]]  # name, channels, channel names
# One more pass: by what each channel of light was divided, and in A the other means. Pictures
# I of sample ranges, with weights W, make the whole picture: sum(W * I) / sum(W).
SAMPLE_WEIGHT: tuple[str, int, str]
# The same of pictures that are named with a number from 00: two things each, the number of each
# thing's name (`matte_id`) and how much of the pixel it covers.
CRYPTOMATTE: list[tuple[str, int, str]]
# The same of pictures that are named after a light group ("Combined_" and its name), or after what
# materials write out: a number, a colour.
NAMED_PASSES: list[tuple[str, int, str]]
EYE_MODELS: list[str]
RAY_FATES: list[str]  # what becomes of a ray: Eye.rays numbers them
REFRACTION_ZEROS: list[str]
AMPLITUDE_FORMULAS: list[str]
PUPIL_FORMULAS: list[str]
PUPIL_PATTERNS: list[str]
# Sockets and options of each kind of shader node: "inputs", "outputs", "options".
NODE_TYPES: dict[str, dict[str, list[str]]]
PIXEL_FILTERS: list[str]
STILES_CRAWFORD_MODES: list[str]

def matte_id(name: str) -> float: ...
def murmur3_32(text: str) -> int: ...

class Prescription:
    def __init__(
        self,
        sphere_d: float = 0.0,
        cylinder_d: float = 0.0,
        axis_deg: float = 180.0,
        add_d: float = 0.0,
        *,
        base_in_pd: float = 0.0,
        base_up_pd: float = 0.0,
        eye: str = "",
    ) -> None: ...
    @staticmethod
    def parse(text: str) -> Prescription: ...
    @property
    def sphere_d(self) -> float: ...
    @property
    def cylinder_d(self) -> float: ...
    @property
    def axis_deg(self) -> float: ...
    @property
    def add_d(self) -> float: ...
    @property
    def base_in_pd(self) -> float: ...
    @property
    def base_up_pd(self) -> float: ...
    @property
    def eye(self) -> str: ...
    def text(self) -> str: ...
    def transposed(self) -> Prescription: ...
    def crossed(self, other: Prescription) -> Prescription: ...
    def meridional_power(self, meridian_deg: float) -> tuple[float, float]: ...
    def power_vector(self) -> tuple[float, float, float]: ...
    def power_matrix(self) -> tuple[tuple[float, float], tuple[float, float]]: ...

class Wavefront:
    def __init__(
        self,
        coefficients_um: Sequence[float],
        pupil_mm: float,
        wavelength_nm: float = 555.0,
    ) -> None: ...
    @staticmethod
    def population(pupil_mm: float, eye: str = "OD") -> Wavefront: ...
    @staticmethod
    def corrected_by(rx: Prescription, pupil_mm: float) -> Wavefront: ...
    @property
    def coefficients_um(self) -> list[float]: ...
    @property
    def pupil_mm(self) -> float: ...
    @property
    def wavelength_nm(self) -> float: ...
    @property
    def rms_um(self) -> float: ...
    def rescaled(self, pupil_mm: float) -> Wavefront: ...
    def rx(self) -> Prescription: ...

class BlurEllipse:
    @property
    def major_arcmin(self) -> float: ...
    @property
    def minor_arcmin(self) -> float: ...
    @property
    def angle_deg(self) -> float | None: ...
    @property
    def rms_radius_arcmin(self) -> float: ...

class Eye:
    def __init__(
        self,
        *,
        model: str = "paraxial",
        rx: Prescription | str = "plano",
        rx_plane: str = "spectacle",
        vertex_mm: float = 12.0,
        pupil_mm: float = 4.0,
        accommodation_d: float = 0.0,
        correction: str = "none",
        worn: Prescription | str | None = None,
        near_part: bool = False,
        wavefront: Wavefront | None = None,
        refraction_zero: str = "paraxial",
        exact_trace: bool = False,
    ) -> None: ...
    def rays(
        self, chief_slope: ArrayLike, pupil_point_m: ArrayLike, wavelength_nm: float = 555.0
    ) -> tuple[
        NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.uint8]
    ]: ...  # origin_m, slope, weight, index of RAY_FATES
    def blur_ellipse(self, distance_m: float = ...) -> BlurEllipse: ...
    def line_spread_arcmin(self, line_deg: float, distance_m: float = ...) -> float: ...
    def spot(
        self,
        distance_m: float = ...,
        field_deg: Sequence[float] = (0.0, 0.0),
        wavelength_nm: float = 555.0,
        samples: int = 4096,
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
    def ray_counts(
        self,
        field_deg: Sequence[float] = (0.0, 0.0),
        wavelength_nm: float = 555.0,
        samples: int = 65536,
    ) -> dict[str, int]: ...
    def spot_ellipse(
        self,
        distance_m: float = ...,
        field_deg: Sequence[float] = (0.0, 0.0),
        wavelength_nm: float = 555.0,
        samples: int = 65536,
    ) -> BlurEllipse: ...
    def psf(
        self,
        distance_m: float = ...,
        size_arcmin: float = 60.0,
        resolution: int = 128,
        wavelength_nm: float = 555.0,
        field_deg: Sequence[float] = (0.0, 0.0),
        samples: int = 262144,
    ) -> NDArray[np.float64]: ...
    def mtf(
        self,
        frequencies_cpd: ArrayLike,
        distance_m: float = ...,
        meridian_deg: float = 0.0,
        diffraction: bool = False,
        wavelength_nm: float = 555.0,
        field_deg: Sequence[float] = (0.0, 0.0),
        samples: int = 65536,
    ) -> NDArray[np.float64]: ...
    def through_focus(
        self,
        vergences_d: ArrayLike,
        wavelength_nm: float = 555.0,
        field_deg: Sequence[float] = (0.0, 0.0),
        samples: int = 65536,
    ) -> NDArray[np.float64]: ...
    def is_diffraction_limited(
        self, distance_m: float = ..., wavelength_nm: float = 555.0
    ) -> bool: ...
    @property
    def best_focus_d(self) -> float | None: ...
    @property
    def pupil_mm(self) -> float: ...
    @property
    def far_point_m(self) -> float: ...
    @property
    def max_accommodation_d(self) -> float: ...
    @property
    def retinal_conjugate_d(self) -> tuple[tuple[float, float], tuple[float, float]]: ...

def pupil_diameter_mm(
    formula: str,
    luminance_cd_m2: float,
    area_deg2: float = 3600.0,
    age_years: float = 30.0,
    eyes: int = 2,
) -> float: ...
def accommodation_amplitude_d(age_years: float, formula: str = "HOFSTETTER_MEAN") -> float: ...

class EyeDescription:
    def __init__(
        self,
        *,
        model: str = "paraxial",
        rx: Prescription | str = "plano",
        rx_plane: str = "spectacle",
        vertex_mm: float = 12.0,
        pupil_mm: float = 4.0,
        accommodation_d: float = 0.0,
        correction: str = "none",
        worn: Prescription | str | None = None,
        near_part: bool = False,
        wavefront: Wavefront | None = None,
        refraction_zero: str = "paraxial",
        exact_trace: bool = False,
    ) -> None: ...
    model: str
    rx: Prescription | str
    rx_plane: str
    vertex_mm: float
    pupil_mm: float
    accommodation_d: float
    correction: str
    worn: Prescription | str | None
    near_part: bool
    wavefront: Wavefront | None
    refraction_zero: str
    exact_trace: bool

class ClearRange:
    @property
    def meridian_deg(self) -> float | None: ...
    @property
    def far_d(self) -> float: ...
    @property
    def near_d(self) -> float: ...

def clear_ranges(relaxed: Eye, accommodated: Eye) -> list[ClearRange]: ...
def diffraction_mtf(
    frequencies_cpd: ArrayLike, pupil_mm: float, wavelength_nm: float = 555.0
) -> NDArray[np.float64]: ...
def airy_radius_arcmin(pupil_mm: float, wavelength_nm: float = 555.0) -> float: ...
def quarter_wave_d(pupil_mm: float, wavelength_nm: float = 555.0) -> float: ...
def observer_eye(observer: Observer, pupil_mm: float, accommodation_d: float = 0.0) -> Eye: ...

class NodeSocket: ...

class Node:
    def set(self, input: str, value: float | Sequence[float] | NodeSocket) -> None: ...
    def __getitem__(self, output: str) -> NodeSocket: ...

class NodeGraph:
    def __init__(self) -> None: ...
    def add(
        self,
        kind: str,
        inputs: Mapping[str, float | Sequence[float] | NodeSocket] = ...,
        **options: str | float | Sequence[float],
    ) -> Node: ...

class Scene:
    def __init__(self, working_space: str = "Linear Rec.709") -> None: ...
    def add_texture(
        self,
        path: str,
        *,
        colorspace: str = "sRGB",
        extension: str = "REPEAT",
        interpolation: str = "Linear",
        alpha: str = "STRAIGHT",
    ) -> int: ...
    def add_texture_pixels(
        self,
        name: str,
        pixels: NDArray[np.uint8] | NDArray[np.float32],
        *,
        colorspace: str = "sRGB",
        extension: str = "REPEAT",
        interpolation: str = "Linear",
        alpha: str = "STRAIGHT",
    ) -> int: ...
    def add_material(
        self,
        name: str,
        surface: NodeSocket | None = None,
        displacement: NodeSocket | None = None,
        volume: NodeSocket | None = None,
        pass_index: int = 0,
        aovs: Mapping[str, NodeSocket] = ...,
    ) -> int: ...
    def add_mesh(
        self,
        name: str,
        positions: ArrayLike,
        triangles: ArrayLike,
        *,
        normals: ArrayLike | None = None,
        uvs: Mapping[str, ArrayLike] = ...,
        attributes: Mapping[str, ArrayLike] = ...,
        material_slots: ArrayLike | None = None,
        active_uv: str = "",
        texture_space: tuple[Sequence[float], Sequence[float]] | None = None,
        motion_positions: Sequence[ArrayLike] = ...,
        motion_normals: Sequence[ArrayLike] = ...,
    ) -> int: ...
    def add_curves(
        self,
        name: str,
        positions: ArrayLike,
        radii: ArrayLike,
        first_keys: ArrayLike,
        *,
        shape: str = "ROUND",
        uvs: Mapping[str, ArrayLike] = ...,
        attributes: Mapping[str, ArrayLike] = ...,
        active_uv: str = "",
        texture_space: tuple[Sequence[float], Sequence[float]] | None = None,
        motion_positions: Sequence[ArrayLike] = ...,
    ) -> int: ...
    def add_points(
        self,
        name: str,
        positions: ArrayLike,
        radii: ArrayLike,
        *,
        attributes: Mapping[str, ArrayLike] = ...,
        texture_space: tuple[Sequence[float], Sequence[float]] | None = None,
        motion_positions: Sequence[ArrayLike] = ...,
    ) -> int: ...
    def add_instances(
        self,
        geometry: int,
        world_from_object: ArrayLike,
        materials: Sequence[int] = ...,
        *,
        colors: ArrayLike | None = None,
        pass_index: float = 0.0,
        randoms: ArrayLike | None = None,
        hidden_from: Sequence[str] = ...,
        is_holdout: bool = False,
        attributes: Mapping[str, ArrayLike] = ...,
        is_shadow_catcher: bool = False,
        name: str = "",
        asset: str = "",
        light_group: str = "",
        lit_classes: int = ...,
        blocker_set: int = 0,
        light_class: int = 0,
        blocker_sets: int = 0,
        motion: ArrayLike | None = None,
        terminator_cosine: float = 0.0,
    ) -> None: ...
    def add_light(
        self,
        name: str,
        kind: str,
        world_from_light: ArrayLike,
        color: Sequence[float],
        *,
        surface: NodeSocket | None = None,
        hidden_from: Sequence[str] = ("CAMERA",),
        light_group: str = "",
        lit_classes: int = ...,
        blocker_set: int = 0,
        motion: Sequence[Mapping[str, object]] = ...,
        radius: float = 0.0,
        soft_falloff: bool = True,
        angle_rad: float = 0.0,
        spot_angle_rad: float = ...,
        spot_blend: float = 0.15,
        spot_cosine_falloff: bool = False,
        shape: str = "RECTANGLE",
        size_x: float = 1.0,
        size_y: float = 1.0,
        spread_rad: float = ...,
        casts_shadow: bool = True,
        has_own_space: bool = True,
    ) -> None: ...
    def set_world(
        self,
        surface: NodeSocket | Sequence[float],
        volume: NodeSocket | None = None,
        aovs: Mapping[str, NodeSocket] = ...,
    ) -> None: ...
    def set_world_light_group(self, name: str) -> None: ...
    def set_world_visibility(self, hidden_from: Sequence[str]) -> None: ...
    def set_camera(
        self,
        world_from_camera: ArrayLike,
        slope_bounds: tuple[float, float, float, float],
        resolution: tuple[int, int],
        border: tuple[int, int, int, int] | None = None,
        clip: tuple[float, float] = ...,
        metres_per_unit: float = 1.0,
        motion: Sequence[tuple[ArrayLike, Sequence[float]]] = ...,
    ) -> None: ...
    def uv_layers_read(self, materials: Sequence[int]) -> list[str]: ...
    def attributes_read(self, materials: Sequence[int]) -> list[str]: ...

class Observer:
    def __init__(
        self,
        *,
        model: str = "paraxial",
        rx: Prescription | str = "plano",
        rx_plane: str = "spectacle",
        vertex_mm: float = 12.0,
        age_years: float = 30.0,
        pupil: float | str = "auto",
        pupil_formula: str = "WATSON_YELLOTT",
        cd_m2_per_unit: float = 179.0,
        luminance_sigma: float = 0.5,
        field_area_deg2: float | None = None,
        eyes: int = 2,
        focus: float | str = "relaxed",
        correction: str = "none",
        worn: Prescription | str | None = None,
        near_part: bool = False,
        wavefront: Wavefront | None = None,
        refraction_zero: str = "paraxial",
        exact_trace: bool = False,
        amplitude_formula: str = "HOFSTETTER_MEAN",
    ) -> None: ...
    model: str
    rx: Prescription | str
    rx_plane: str
    vertex_mm: float
    age_years: float
    pupil: float | str
    pupil_formula: str
    cd_m2_per_unit: float
    luminance_sigma: float
    field_area_deg2: float | None
    eyes: int
    focus: float | str
    correction: str
    worn: Prescription | str | None
    near_part: bool
    wavefront: Wavefront | None
    refraction_zero: str
    exact_trace: bool
    amplitude_formula: str

class LightPathLimits:
    def __init__(
        self,
        *,
        diffuse_bounces: int = 1024,
        glossy_bounces: int = 1024,
        transmission_bounces: int = 1024,
        volume_bounces: int = 1024,
        transparent_bounces: int = 256,
        reflective_caustics: bool = True,
        refractive_caustics: bool = True,
        filter_glossy: float = 0.0,
        clamp_direct: float = 0.0,
        clamp_indirect: float = 0.0,
    ) -> None: ...
    diffuse_bounces: int
    glossy_bounces: int
    transmission_bounces: int
    volume_bounces: int
    transparent_bounces: int
    reflective_caustics: bool
    refractive_caustics: bool
    filter_glossy: float
    clamp_direct: float
    clamp_indirect: float

class Settings:
    def __init__(
        self,
        *,
        samples: int = 64,
        max_bounces: int = 8,
        seed: int = 0,
        sample_range: tuple[int, int] | None = None,
        pattern: str = "SOBOL",
        passes: Sequence[str] = ...,
        threads: int = 0,
        film_transparent: bool = False,
        film_glass_roughness: float | None = None,
        exposure: float = 1.0,
        pixel_filter: str = "BLACKMAN_HARRIS",
        filter_width_px: float = 1.5,
        limits: LightPathLimits = ...,
        chromatic: bool = False,
        stiles_crawford: str | bool = "OFF",
        mist_start: float = 5.0,
        mist_depth: float = 25.0,
        mist_falloff: str = "QUADRATIC",
        occlusion_distance: float = 10.0,
        pass_alpha_threshold: float = 0.5,
        aovs: Mapping[str, str] = ...,
        motion_blur: bool = True,
        shutter_curve: Sequence[float] = ...,
    ) -> None: ...
    samples: int
    max_bounces: int
    seed: int
    sample_range: tuple[int, int] | None
    pattern: str
    passes: Sequence[str]
    threads: int
    film_transparent: bool
    film_glass_roughness: float | None
    exposure: float
    pixel_filter: str
    filter_width_px: float
    limits: LightPathLimits
    chromatic: bool
    stiles_crawford: str | bool
    mist_start: float
    mist_depth: float
    mist_falloff: str
    occlusion_distance: float
    pass_alpha_threshold: float
    aovs: Mapping[str, str]
    motion_blur: bool
    shutter_curve: Sequence[float]

class Session:
    def __init__(self, scene: Scene, observer: Observer, settings: Settings) -> None: ...
    def start(self) -> None: ...
    def cancel(self) -> None: ...
    def wait(self, timeout_s: float) -> bool: ...
    def snapshot(self) -> dict[str, NDArray[np.float32]]: ...
    @property
    def samples_done(self) -> int: ...
    @property
    def samples_total(self) -> int: ...
    @property
    def progress(self) -> float: ...
    @property
    def ray_fates(self) -> dict[str, int]: ...
    @property
    def error(self) -> str | None: ...
    @property
    def plan_text(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def facts(self) -> dict[str, str | float]: ...
    @property
    def metadata(self) -> dict[str, str]: ...
    @property
    def pupil_mm(self) -> float: ...
    @property
    def luminance_cd_m2(self) -> float: ...
    @property
    def pupil_report(self) -> str: ...
    @property
    def accommodation_d(self) -> float: ...

def render(
    scene: Scene, observer: Observer, settings: Settings
) -> dict[str, NDArray[np.float32]]: ...
