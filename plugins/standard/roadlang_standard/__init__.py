"""The standard kinds: they come in as a stranger's do, and each is imported when it is used."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from roadlang.api import hookimpl

_KINDS = {
    "adjust brightness": "adjust_brightness:Brightness",
    "adjust contrast": "adjust_contrast:Contrast",
    "adjust sharpness": "adjust_sharpness:Sharpness",
    "adjust blur": "adjust_blur:Blur",
    "adjust noise": "adjust_noise:Noise",
    "adjust shadows": "adjust_shadows:Shadows",
    "extract auto": "extract_auto:Auto",
    "extract contour": "extract_contour:Contour",
    "extract pixels": "extract_pixels:Pixel",
    "extract aerial": "extract_aerial:Aerial",
    "extract onnx": "extract_onnx:Onnx",
    "draw waypoints": "draw_waypoints:Waypoints",
    "draw segments": "draw_segments:Segments",
    "perturb sine": "perturb_sine:Sine",
    "perturb harmonics": "perturb_harmonics:Harmonics",
    "perturb random_walk": "perturb_random_walk:RandomWalk",
    "perturb bump": "perturb_bump:Bump",
    "perturb shift": "perturb_shift:Shift",
    "perturb scale": "perturb_scale:Scale",
    "drive pure_pursuit": "drive_pure_pursuit:PurePursuit",
    "drive stanley": "drive_stanley:Stanley",
    "drive lane_follow": "drive_lane_follow:LaneFollow",
    "drive car_follow": "drive_car_follow:CarFollow",
    "drive brake": "drive_brake:Brake",
    "drive crossing": "drive_crossing:Crossing",
    "signal deviation": "signal_deviation:Deviation",
    "signal distance": "signal_distance:Distance",
    "signal curvature": "signal_curvature:Curvature",
    "signal heading": "signal_heading:Heading",
    "signal width": "signal_width:Width",
    "signal clearance": "signal_clearance:Clearance",
    "signal margin": "signal_margin:Margin",
    "number start": "number_start:Start",
    "number confidence": "number_confidence:Confidence",
    "number length": "number_length:Length",
    "number sup_distance": "number_sup_distance:SupDistance",
    "number frechet": "number_frechet:Frechet",
    "number lp_distance": "number_lp_distance:LpDistance",
    "distribution uniform": "distribution_uniform:Uniform",
    "distribution normal": "distribution_normal:Normal",
    "distribution choice": "distribution_choice:Choice",
    "distribution integer": "distribution_integer:Integer",
    "sample random": "sample_random:RandomSampler",
    "sample grid": "sample_grid:GridSampler",
    "sample halton": "sample_halton:HaltonSampler",
    "sample guided": "sample_guided:Guided",
    "falsify random": "falsify_random:Random",
    "falsify halton": "falsify_halton:Halton",
    "falsify grid": "falsify_grid:Grid",
    "falsify cma": "falsify_cma:Cma",
    "read csv": "read_csv:Csv",
    "read ros_map": "read_ros_map:RosMap",
    "emit json": "emit_json:Json",
    "emit svg": "emit_svg:Svg",
    "piece straight": "pieces:StraightPiece",
    "piece arc": "pieces:ArcPiece",
    "piece clothoid": "pieces:ClothoidPiece",
    "select route": "selectors:Route",
    "select road": "selectors:RoadById",
    "drive_signal speed": "drive_signals:Speed",
    "drive_signal acceleration": "drive_signals:AccelerationSignal",
    "drive_signal cross_track_error": "drive_signals:CrossTrack",
    "drive_signal progress": "drive_signals:Progress",
    "drive_signal station": "drive_signals:Station",
    "drive_signal steering": "drive_signals:Steering",
    "drive_signal heading": "drive_signals:HeadingSignal",
    "drive_signal lateral_acceleration": "drive_signals:LateralAcceleration",
    "drive_signal jerk": "drive_signals:JerkSignal",
    "drive_signal yaw_rate": "drive_signals:YawRate",
    "drive_signal contacts": "drive_signals:Contacts",
    "drive_signal distance": "drive_signals:DistanceSignal",
    "drive_signal gap": "drive_signals:GapSignal",
    "drive_signal time": "drive_signals:Time",
    "agent car": "agents:Car",
    "agent van": "agents:Van",
    "agent truck": "agents:Truck",
    "agent bus": "agents:Bus",
    "agent motorcycle": "agents:Motorcycle",
    "agent bicycle": "agents:Bicycle",
    "agent pedestrian": "agents:Pedestrian",
    "agent animal": "agents:Animal",
    "object tree": "objects:Tree",
    "object bush": "objects:Bush",
    "object building": "objects:Building",
    "object wall": "objects:Wall",
    "object parked_car": "objects:ParkedCar",
    "object parked_van": "objects:ParkedVan",
    "object parked_truck": "objects:ParkedTruck",
    "object cone": "objects:Cone",
    "object barrier": "objects:Barrier",
    "object sign": "objects:Sign",
    "object traffic_light": "objects:TrafficLight",
    "object lamp": "objects:Lamp",
    "object bench": "objects:Bench",
    "object bin": "objects:Bin",
    "object rock": "objects:Rock",
    "object box": "objects:Box",
}


@hookimpl
def roadlang_kinds() -> Mapping[str, str]:
    """Verb and name to where the class is."""
    return {kind: f"{__name__}.{target}" for kind, target in _KINDS.items()}


@hookimpl
def roadlang_planned() -> Iterable[str]:
    """Kinds that are planned."""
    from .planned import PLANNED

    return PLANNED
