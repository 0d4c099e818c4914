"""The kinds that this plugin provides; each is imported when it is used."""

from __future__ import annotations

from collections.abc import Mapping

from roadlang.api import hookimpl

_KINDS = {
    "emit commonroad": "emit_commonroad:CommonRoadBackend",
    "emit lanelet2": "emit_lanelet2:Lanelet2Backend",
    "emit geojson": "emit_geojson:GeoJsonBackend",
    "emit gltf": "emit_gltf:GltfBackend",
    "emit mujoco": "emit_mujoco:MujocoBackend",
    "emit road_mask": "emit_road_mask:RoadMaskBackend",
    "emit opendrive": "emit_opendrive:OpenDriveBackend",
    "emit openscenario": "emit_openscenario:OpenScenarioBackend",
    "emit scenic": "emit_scenic:ScenicBackend",
    "emit sumo": "emit_sumo:SumoBackend",
    "read opendrive": "read_opendrive:OpenDriveMap",
    "read geojson": "read_geojson:GeoJson",
    "read osm": "read_osm:OpenStreetMap",
    "read scene": "read_scene:SceneMap",
}


@hookimpl
def roadlang_kinds() -> Mapping[str, str]:
    """Verb and name to where the class is."""
    return {kind: f"{__package__}.{target}" for kind, target in _KINDS.items()}
