"""What the standard kinds are: units, who is random, who is the default, what lanes are for."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest

from roadlang.plugins.discovery import load_registry
from roadlang.simulation.observing.observation_vector import ObservationVector
from roadlang_standard.drive_onnx import OnnxController
from roadlang_standard.process import messages


@cache
def kinds(verb: str) -> dict[str, Any]:
    return {
        entry.name: entry.load()
        for entry in load_registry().entries
        if entry.verb == verb and entry.origin.is_shipped
    }


def facts(verb: str, member: str) -> dict[str, Any]:
    return {name: getattr(kind, member) for name, kind in kinds(verb).items()}


def those(verb: str, member: str) -> set[str]:
    return {name for name, value in facts(verb, member).items() if value}


@pytest.mark.parametrize(
    ("verb", "units"),
    [
        ("signal", {"deviation": "m", "distance": "m", "curvature": "1/m", "heading": "rad",
                    "width": "m", "clearance": "m", "margin": "m"}),
        ("number", {"start": "m", "distance": "m", "gap": "m", "start_lane": "", "confidence": "",
                    "length": "m", "sup_distance": "m", "frechet": "m"}),
        ("drive_signal", {"speed": "m/s", "acceleration": "m/s^2", "cross_track_error": "m",
                          "progress": "", "station": "m", "steering": "rad", "heading": "rad",
                          "lateral_acceleration": "m/s^2", "jerk": "m/s^3", "yaw_rate": "rad/s",
                          "contacts": "", "distance": "m", "gap": "m", "x": "m", "y": "m",
                          "time_to_collision": "s", "post_encroachment_time": "s", "time": "s"}),
    ],
)  # fmt: skip
def test_signals_and_numbers_have_units(verb: str, units: dict[str, str]) -> None:
    found = facts(verb, "unit")
    assert {name: found[name] for name in units} == units


def test_derivatives_look_back_at_the_sample_before_and_encounters_at_the_whole_drive() -> None:
    found = facts("drive_signal", "looks_back")
    assert {name for name in ("jerk", "yaw_rate", "lateral_acceleration") if found[name] == 1} == {
        "jerk", "yaw_rate", "lateral_acceleration"
    }  # fmt: skip
    assert found["post_encroachment_time"] == float("inf")
    for name in ("speed", "x", "y", "heading", "station", "progress", "contacts", "distance"):
        assert found[name] == 0


def test_signals_of_one_agent_are_its_members_and_those_of_two_are_functions() -> None:
    found = facts("drive_signal", "member")
    for name in ("speed", "x", "y", "progress", "contacts", "jerk"):
        assert found[name]
    for name in ("distance", "gap", "time_to_collision", "post_encroachment_time", "time"):
        assert not found[name]
    assert those("number", "member") == {"start", "start_lane"}
    assert those("number", "of_groups") == {"distance", "gap"}
    assert those("number", "is_integer") == {"start_lane"}
    assert those("signal", "on_connections") == {"curvature"}


@pytest.mark.parametrize(
    ("verb", "random"),
    [("adjust", {"noise", "shadows"}), ("perturb", {"harmonics", "random_walk"})],
)
def test_kinds_that_draw_numbers_of_their_own(verb: str, random: set[str]) -> None:
    assert those(verb, "is_random") == random


@pytest.mark.parametrize(
    ("verb", "defaults"),
    [("emit", {"json", "svg"}), ("extract", {"auto"}), ("distribution", {"uniform"}),
     ("sample", {"random"}), ("simulate", {"builtin"}), ("falsify", {"cma"}),
     ("lane", {"drive", "sidewalk"}), ("perturb", set()), ("drive", set()), ("agent", set())],
)  # fmt: skip
def test_what_is_used_where_nothing_is_written(verb: str, defaults: set[str]) -> None:
    assert those(verb, "is_default") == defaults


def test_choices_have_no_order_and_all_other_distributions_do() -> None:
    assert those("distribution", "is_ordered") == {"uniform", "normal", "integer"}


def test_only_adaptive_searches_learn_from_results() -> None:
    assert those("falsify", "is_adaptive") == {"cma", "elites"}


def test_grids_and_sequences_are_visited_in_order() -> None:
    assert those("sample", "sequential") == {"grid", "halton"}


def test_what_faults_of_geometry_are_the_users_own() -> None:
    """Points, pieces, displacements and places are written in the scene file, pictures are not."""
    for verb in ("draw", "perturb", "piece", "position", "read", "select"):
        assert those(verb, "geometry_is_user_input") == set(kinds(verb)), verb
    for verb in ("extract", "adjust", "signal", "emit", "agent", "object"):
        assert those(verb, "geometry_is_user_input") == set(), verb


def test_lanes_by_their_width_users_and_place() -> None:
    assert facts("lane", "default_width") == {
        "drive": 3.25, "bus": 3.5, "bike": 1.5, "parking": 2.3, "shoulder": 1.5, "sidewalk": 2.0,
        "median": 2.0, "grass": 2.0,
    }  # fmt: skip
    assert those("lane", "drivable") == {"drive", "bus"}
    assert those("lane", "raised") == {"sidewalk", "median"}
    users = {name: users for name, users in facts("lane", "users").items() if users}
    assert users == {
        "drive": ("car", "bus", "bicycle"), "bus": ("bus",), "bike": ("bicycle",),
        "sidewalk": ("pedestrian",),
    }  # fmt: skip
    directions = facts("lane", "direction")
    assert {name for name, way in directions.items() if way == "side"} == {"drive", "bus", "bike"}
    assert directions["sidewalk"] == "both"
    marking = facts("lane", "default_marking")
    assert {name for name, line in marking.items() if line == "none"} == {"shoulder", "grass"}


def test_readers_are_found_by_the_ending_of_a_file() -> None:
    assert facts("read", "suffixes") == {
        "csv": (".csv", ".tsv", ".txt"), "geojson": (".geojson",), "opendrive": (".xodr",),
        "osm": (".osm",), "ros_map": (".yaml", ".yml"), "scene": (".json",)
    }  # fmt: skip
    networks = dict.fromkeys(("geojson", "opendrive", "osm", "ros_map", "scene"), ("network",))
    assert facts("read", "reads") == {"csv": ("road",), **networks}


def test_signals_cost_what_is_computed_for_each_station() -> None:
    """Cheap ones are evaluated first: a width is read, a clearance compares all with all."""
    costs = facts("signal", "cost")
    assert sorted(costs, key=lambda name: costs[name]) == [
        "width", "deviation", "distance", "margin", "heading", "curvature", "clearance"
    ]  # fmt: skip
    numbers = facts("number", "cost")
    assert numbers["confidence"] < numbers["sup_distance"] < numbers["lp_distance"]
    assert numbers["frechet"] == max(numbers.values())


def test_policies_observe_by_default_what_environments_do() -> None:
    """Programs that drive have a protocol of their own version, with the same distances."""
    policy, vector = OnnxController("policy.onnx"), ObservationVector()
    assert (policy.distances, policy.agents) == (vector.distances, vector.agents)
    assert vector.distances == messages.DISTANCES
