"""What agents look like: categories, and a color of its own for each."""

from __future__ import annotations

import dataclasses

import pytest

from roadlang.ir.category import category_by_size
from roadlang_godot.build.agent_looks import EGO_COLOR, category_of, color_of, look_of
from tests.godot.godot_scenes import bend, car, pieces, road


def test_five_hundred_agents_have_as_many_colors() -> None:
    assert len({color_of(number) for number in range(1, 501)} | {EGO_COLOR}) == 501


def test_ego_is_marked_unless_the_scene_gives_it_a_color() -> None:
    street = road("main", pieces(bend(50, 90)))
    ego = car("ego", street, 5.0, kind="car")
    assert look_of(ego, 1) == {"category": "car", "color": EGO_COLOR, "marked": True}
    default = dataclasses.replace(ego, options={"color": "#1f5fa8"})
    assert look_of(default, 1)["color"] == EGO_COLOR
    green = dataclasses.replace(ego, options={"color": "green"})
    assert look_of(green, 1) == {"category": "car", "color": "green", "marked": True}


@pytest.mark.parametrize(
    ("kind", "length", "width", "height", "category"),
    [
        ("roadlang.bus", 4.0, 1.8, 1.5, "bus"),
        ("acme.pod", 3.0, 1.6, 1.6, "car"),
        ("acme.minibus", 6.0, 2.1, 2.4, "van"),
        ("acme.lorry", 9.0, 2.5, 3.4, "truck"),
        ("acme.coach", 13.0, 2.5, 3.4, "bus"),
        ("acme.e_bike", 1.9, 0.7, 1.7, "bicycle"),
        ("acme.chopper", 2.4, 0.9, 1.3, "motorcycle"),
    ],
)
def test_kinds_of_plugins_look_like_what_has_their_size(
    kind: str, length: float, width: float, height: float, category: str
) -> None:
    street = road("main", pieces(bend(50, 90)))
    made = car("a", street, 5.0, kind=kind)
    usual = category_by_size(length, width, height)
    sized = dataclasses.replace(made, length=length, width=width, height=height, category=usual)
    assert category_of(sized) == category
