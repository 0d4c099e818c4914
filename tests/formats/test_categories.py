"""Kinds of strangers in all formats: by the category and role that they state, else by size."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, ClassVar

import pytest

from roadlang.api import AgentKind, Length, ObjectKind, Scene, option
from roadlang.testing import sample
from roadlang_formats.emit_commonroad import CommonRoadBackend
from roadlang_formats.emit_opendrive import OpenDriveBackend
from roadlang_formats.emit_openscenario import OpenScenarioBackend
from roadlang_formats.emit_scenic import ScenicBackend
from roadlang_formats.emit_sumo import SumoBackend
from roadlang_godot.build.agent_looks import category_of
from roadlang_standard.semantic_classes import class_of_category

TEXT = """
road main { draw with segments { pieces: [straight(200m)] }, lanes: 2 }
agent ego is jeep on main at 20m
agent bearer is litter on main at 50m { lane: -1 }
agent rider is trike on main at 70m { lane: -1 }
agent huge is carrier on main at 100m { lane: -1 }
object wood is poplar on main at 60m { offset: 8m }
emit json
"""


@dataclass(frozen=True)
class Sized(AgentKind):
    """As large as a car."""

    length: Length = option(4.2)
    width: Length = option(1.8)
    height: Length = option(1.6)


@dataclass(frozen=True)
class Jeep(Sized):
    """Of the police."""

    name: ClassVar[str] = "jeep"
    category: ClassVar[str] = "car"
    role: ClassVar[str] = "police"


@dataclass(frozen=True)
class Litter(Sized):
    """Carried by people on foot."""

    name: ClassVar[str] = "litter"
    category: ClassVar[str] = "pedestrian"


@dataclass(frozen=True)
class Trike(Sized):
    """States no category, and is small."""

    name: ClassVar[str] = "trike"
    length: Length = option(1.9)
    width: Length = option(0.8)


@dataclass(frozen=True)
class Carrier(Sized):
    """States no category, and is large."""

    name: ClassVar[str] = "carrier"
    length: Length = option(9.0)
    width: Length = option(2.5)
    height: Length = option(3.4)


@dataclass(frozen=True)
class Poplar(ObjectKind):
    """A tree."""

    name: ClassVar[str] = "poplar"
    category: ClassVar[str] = "tree"
    length: Length = option(2.0)
    width: Length = option(2.0)
    height: Length = option(15.0)


@pytest.fixture(scope="module")
def scene() -> Scene:
    return sample(TEXT, 1, kinds=[Jeep, Litter, Trike, Carrier, Poplar])[0].record


def text_of(backend: Any, scene: Scene, ending: str) -> str:
    return str(backend.files(scene)[ending])


def test_the_scene_states_categories(scene: Scene) -> None:
    found = {thing.name: (thing.category, thing.role) for thing in (*scene.agents, *scene.objects)}
    assert found == {
        "ego": ("car", "police"),
        "bearer": ("pedestrian", ""),
        "rider": ("bicycle", ""),
        "huge": ("truck", ""),
        "wood": ("tree", ""),
    }


def test_text_formats_go_by_them(scene: Scene) -> None:
    drama = text_of(OpenScenarioBackend(), scene, "xosc")
    assert re.findall(r'Vehicle name="\w+" vehicleCategory="(\w+)" role="(\w+)"', drama) == [
        ("car", "police"),
        ("bicycle", "civil"),
        ("truck", "civil"),
    ]
    assert 'pedestrianCategory="pedestrian"' in drama
    assert 'miscObjectCategory="tree"' in drama
    assert 'type="tree"' in text_of(OpenDriveBackend(), scene, "xodr")
    program = text_of(ScenicBackend(), scene, "scenic")
    assert re.findall(r"new (\w+) at", program) == ["Car", "Pedestrian", "Vehicle", "Car", "Object"]
    routes = text_of(SumoBackend(), scene, "rou.xml")
    assert {"authority", "bicycle", "truck"} <= set(re.findall(r'vClass="(\w+)"', routes))
    obstacles = text_of(CommonRoadBackend(), scene, "cr.xml")
    assert obstacles.count("<type>parkedVehicle</type>") == 2


def test_pictures_go_by_them(scene: Scene) -> None:
    assert [category_of(agent) for agent in scene.agents] == [
        "police_car", "pedestrian", "bicycle", "truck"
    ]  # fmt: skip
    classes = [class_of_category(agent.category).label for agent in scene.agents]
    assert classes == ["car", "pedestrian", "bicycle", "truck"]
