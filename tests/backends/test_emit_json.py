"""`emit json`: a scene whole, in a versioned schema, read back exactly."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import jsonschema
import numpy as np
import pytest

from roadlang.ir.encoding import NotFinite, scene_from_json, to_json
from roadlang.ir.scene_schema import scene_schema
from roadlang.ir.scene_versions import UnknownSceneSchema
from roadlang_standard.emit_json import Json
from tests.backends.handmade_scenes import bend, town


@pytest.mark.parametrize("scene", [bend(), town()], ids=["bend", "town"])
def test_a_scene_fits_the_published_schema(scene: Any) -> None:
    text = Json().files(scene)["json"]
    jsonschema.Draft202012Validator(scene_schema()).validate(json.loads(text))


def test_a_scene_reads_back_exactly() -> None:
    scene = bend()
    assert to_json(scene_from_json(to_json(scene))) == to_json(scene)
    assert scene_from_json(to_json(scene)).roads == scene.roads


def test_the_schema_refuses_another_version() -> None:
    record = json.loads(to_json(bend()))
    record["schema"] = "roadlang.scene/0"
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(record, scene_schema())


def test_the_first_member_says_what_the_file_is() -> None:
    assert to_json(bend()).splitlines()[1] == '  "schema": "roadlang.scene/2",'


@pytest.mark.parametrize("value", [float("nan"), float("inf"), float("-inf")])
def test_a_number_that_is_not_finite_is_refused_with_its_place(value: float) -> None:
    scene = bend()
    road = scene.roads[0]
    broken = replace(scene, roads=(replace(road, x=(*road.x[:3], value, *road.x[4:])),))
    with pytest.raises(NotFinite) as refused:
        to_json(broken)
    assert refused.value.place == "roads[0].x[3]"


def test_numpy_numbers_are_numbers() -> None:
    scene = replace(bend(), values={"reach": np.float64(8.5), "count": np.int64(3)})
    assert json.loads(to_json(scene))["values"] == {"count": 3, "reach": 8.5}


def test_maps_are_sorted_so_that_equal_scenes_are_equal_bytes() -> None:
    one = replace(bend(), values={"a": 1, "b": 2})
    other = replace(bend(), values={"b": 2, "a": 1})
    assert to_json(one) == to_json(other)


def test_scenes_of_the_first_schema_are_read() -> None:
    """`colour` became `color`; what was added since is empty."""
    scene = bend()
    painted = replace(scene.agents[0], options={"color": "#112233"})
    record = json.loads(to_json(replace(scene, agents=(painted,))))
    record["schema"] = "roadlang.scene/1"
    record["agents"][0]["options"] = {"colour": "#112233"}
    del record["signals"]
    for verdict in record["requirements"] + record["expectations"]:
        del verdict["profiles"], verdict["tightest"]
    read = scene_from_json(json.dumps(record))
    assert read == scene_from_json(to_json(replace(scene, agents=(painted,))))
    assert read.schema == "roadlang.scene/2"


def test_agents_and_objects_of_earlier_scenes_get_a_category() -> None:
    """By their kinds, else by their sizes; scenes of the present version state it."""
    sizes = {"pedestrian": (0.4, 0.6, 1.75), "standard.bus": (12.0, 2.5, 3.1)}
    sizes["rig"] = (9.0, 2.5, 3.4)
    agent = bend().agents[0]
    agents = tuple(
        replace(agent, name=kind, kind=kind, length=size[0], width=size[1], height=size[2])
        for kind, size in sizes.items()
    )
    things = tuple(replace(agent, name=kind, kind=kind) for kind in ("tree", "parked_van", "rig"))
    record = json.loads(to_json(replace(bend(), agents=agents, objects=things)))
    for actor in record["agents"] + record["objects"]:
        del actor["category"]
    read = scene_from_json(json.dumps(record))
    assert [actor.category for actor in read.agents] == ["pedestrian", "bus", "truck"]
    assert [actor.category for actor in read.objects] == ["tree", "van", "obstacle"]


def test_signals_of_the_first_schema_get_their_present_names() -> None:
    """`cross_track` became `cross_track_error`, and the operands of `distance` were renamed."""
    scene = bend()
    old = {
        "formula": {"<": ["e", "d"]},
        "signals": {
            "e": {"kind": "cross_track", "options": {"agent": "ego"}},
            "d": {"kind": "roadlang.distance", "options": {"one": "ego", "other": "van"}},
        },
    }
    record = {**json.loads(to_json(scene)), "schema": "roadlang.scene/1"}
    record["expectations"] = [{"name": "a", "text": "", "domain": "drive", "formula": old}]
    record["name"] = "cross_track"
    record["expectations"][0] |= {"robustness": None, "satisfied": None}
    read = scene_from_json(json.dumps(record))
    formula = read.expectations[0].formula
    assert formula is not None
    assert read.name == "cross_track"  # a name of the author's
    assert formula["signals"] == {
        "e": {"kind": "cross_track_error", "options": {"agent": "ego"}},
        "d": {"kind": "roadlang.distance", "options": {"first": "ego", "second": "van"}},
    }


@pytest.mark.parametrize("schema", ["roadlang.scene/9", None, 2])
def test_other_schemas_are_refused(schema: str | int | None) -> None:
    record = {**json.loads(to_json(bend())), "schema": schema}
    with pytest.raises(UnknownSceneSchema, match="scene/2"):
        scene_from_json(json.dumps(record))
