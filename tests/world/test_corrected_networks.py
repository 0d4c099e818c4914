"""`drawn`, `dismissed` and `confirmed` of a network: what a human says of a picture's roads."""

from __future__ import annotations

import pytest

from roadlang import DiagnosticError, testing

PLAN = '''
image plan from """
........................................
........................................
####################....################
........................................
........................................
""" { scale: 3m/px, legend: { "#": road } }
'''
"""Two roads along y = 7.5 m with a gap of 12 m; they end at x = 60 m and begin again at 72 m."""


def roads(options: str) -> list[float]:
    """The length of each road."""
    (scene,) = testing.sample(f"{PLAN}network town from plan {{ {options} }}", 1)
    return sorted(road.length for road in scene.roads.values())


def test_roads_are_as_they_were_found_without_corrections() -> None:
    assert len(roads("")) == 2


def test_a_drawn_road_closes_a_gap() -> None:
    (scene,) = testing.sample(
        f"{PLAN}network town from plan {{ drawn: [[(19px, 2px), (24px, 2px)]] }}\n"
        "road whole from town ",
        1,
    )
    assert scene.roads["whole"].length == pytest.approx(117.0, abs=0.5)


def test_a_drawn_road_may_lead_out_of_the_picture() -> None:
    assert len(roads("drawn: [[(30px, 2px), (45px, 20px)]]")) == 4


def test_a_dismissed_road_is_gone() -> None:
    assert len(roads("dismissed: [[(5px, 2px)]]")) == 1


def test_a_part_between_two_pixels_is_gone() -> None:
    left = roads("dismissed: [[(6px, 2px), (12px, 2px)]]")
    assert len(left) == 3
    assert sum(left) == pytest.approx(sum(roads("")) - 18.0, abs=0.5)


def test_a_pixel_without_a_road_is_said() -> None:
    scenes = testing.sample(f"{PLAN}network town from plan {{ confirmed: [(4px, 0px), (5px, 2px)], "
                            "dismissed: [[(21.5px, 4px)]] }", 1)  # fmt: skip
    said = [found.message for found in scenes.diagnostics if found.code == "RL434"]
    assert len(said) == 1
    assert "(21.5px, 4px)" in said[0]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("network town from plan { drawn: [[(1px, 2px)]] }", "RL208"),
        ("network town from plan { drawn: [(1px, 2px), (3px, 4px)] }", "RL206"),
        ("network town from plan { drawn: [[(1m, 2m), (3m, 4m)]] }", "RL201"),
        ("network town from plan { confirmed: [(uniform(1px, 2px), 2px)] }", "RL229"),
        ("network a from plan\nnetwork town from a { dismissed: [[(1px, 2px)]] }", "RL219"),
        ("network town from plan { drawn: [[(1px, 2px), (1px, 2px)]] }", "RL472"),
        ("network town from plan { drawn: [[(1px, 2px), (1e9px, 2px)]] }", "RL472"),
        ("network town from plan { drawn: [[(1px, 2px), (1px, -41px)]] }", "RL472"),
    ],
)
def test_what_cannot_be_is_an_error(text: str, code: str) -> None:
    with pytest.raises(DiagnosticError) as caught:
        testing.sample(PLAN + text, 1)
    assert caught.value.diagnostics[0].code == code
