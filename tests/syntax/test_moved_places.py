"""A road that is moved by hand gets a pass `perturb with nudges`; all else stays as it was."""

from __future__ import annotations

import pytest

import roadlang
from roadlang.geometry.networks.warp import RADIUS
from roadlang.plugins.options import schema_of
from roadlang.semantics.infer.statement_options import NetworkOptions
from roadlang.syntax.moved_places import LENGTH, MovedPlaces, moved_places_of, with_moved_places
from roadlang_standard.perturb_nudges import Nudges

ONE = MovedPlaces((40.0,), ((1.5, -2.0),))
WORDS = "perturb with nudges { at: [40m], by: [(1.5m, -2m)], length: 80m }"
DRAWN = "draw with waypoints { points: [(0m, 0m), (90m, 0m)] }"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("road r { # x\n  %s  # y\n  width: 8m # z\n}\n",
         "road r { # x\n  %s  # y\n  width: 8m # z\n  %s\n}\n"),
        ("road r { %s, width: 8m }\n", "road r { %s, width: 8m, %s }\n"),
        ("road r {\n  %s }\n", "road r {\n  %s, %s }\n"),
        ("road r {\r\n\t%s\r\n}\r\n", "road r {\r\n\t%s\r\n\t%s\r\n}\r\n"),
    ],
)  # fmt: skip
def test_the_pass_is_added_and_goes_again(before: str, after: str) -> None:
    text = before % DRAWN
    written = with_moved_places(text, "r", ONE, "nudges")
    assert written == after % (DRAWN, WORDS)
    assert moved_places_of(written, "r") == ONE
    assert len(roadlang.loads(written).sample()[0].roads) == 1
    assert with_moved_places(written, "r", MovedPlaces(), "nudges") == text


@pytest.mark.parametrize("block", ["", " {}", " { }"])
def test_a_road_without_options_gets_a_block(block: str) -> None:
    text = f"road base {{ {DRAWN} }}\nroad r from base{block}\n"
    written = with_moved_places(text, "r", ONE, "nudges")
    assert written == f"road base {{ {DRAWN} }}\nroad r from base {{ {WORDS} }}\n"


def test_only_the_numbers_of_a_pass_change() -> None:
    text = (
        f"road r {{ {DRAWN}\n  perturb with nudges {{ # mine\n    at: [10m, 4000cm]  # here\n"
        "    by: [(1m, 0m), (0m, 1m)], over: [5m, 80m] }\n}\n"
    )
    found = moved_places_of(text, "r")
    assert found == MovedPlaces((10.0, 40.0), ((1.0, 0.0), (0.0, 1.0)))
    moved = with_moved_places(text, "r", found.moved(40.0, (0.5, 0.25)), "nudges")
    assert moved == text.replace("4000cm", "40m").replace("(0m, 1m)", "(0.5m, 1.25m)")
    fewer = with_moved_places(text, "r", found.without(10.0), "nudges")
    assert fewer is not None
    assert "at: [40m]  # here" in fewer


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("{ %s, width: 6m }", "{ width: 6m }"),
        ("{ %s,\n  width: 6m }", "{ \n  width: 6m }"),
        ("{ %s\n  width: 6m }", "{\n  width: 6m }"),
        ("{ %s  # moved\n  , width: 6m }", "{   # moved\n  width: 6m }"),
        ("{\n  %s,\n  width: 6m\n}", "{\n  width: 6m\n}"),
        ("{\n  %s\n  , width: 6m\n}", "{\n  \n  width: 6m\n}"),
        ("{\n  # moved\n  %s }", "{\n  # moved\n   }"),
        ("{\n  # moved,\n  %s, width: 6m }", "{\n  # moved,\n  width: 6m }"),
        ("{ width: 6m,  # wide,\n  %s }", "{ width: 6m  # wide,\n   }"),
        ("{ width: 6m  # wide\r\n  %s }", "{ width: 6m  # wide\r\n   }"),
        ("{ width: 6m,\n  %s }", "{ width: 6m }"),
        ("{ width: 6m, %s, lanes: 2 }", "{ width: 6m, lanes: 2 }"),
        ("{ width: 6m\n  %s,  # moved\n  lanes: 2 }", "{ width: 6m\n  # moved\n  lanes: 2 }"),
        ("{ width: 6m, %s }  # all", "{ width: 6m }  # all"),
    ],
)
def test_what_is_left_without_the_pass_can_be_read(before: str, after: str) -> None:
    text = f"road m {{ {DRAWN} }}\nroad a from m %s\n"
    left = with_moved_places(text % before % WORDS, "a", MovedPlaces(), "nudges")
    assert left == text % after
    assert len(roadlang.loads(text % before % WORDS).sample()[0].roads) == 2
    assert len(roadlang.loads(left).sample()[0].roads) == 2


def test_nudges_that_are_drawn_at_random_are_left_alone() -> None:
    text = f"road r {{ {DRAWN}, perturb with nudges {{ at: [10m..20m], by: [(1m, 0m)] }} }}\n"
    assert moved_places_of(text, "r") == MovedPlaces()
    written = with_moved_places(text, "r", ONE, "nudges")
    assert written == text.replace(" }\n", f", {WORDS} }}\n")


def test_a_road_of_another_file_cannot_be_changed() -> None:
    assert with_moved_places('include "a.rl"\n', "r", ONE, "nudges") is None


def test_places_move_as_much_road_as_the_options_say_by_default() -> None:
    """The text is edited without the plugins, whose defaults hold where nothing is written."""
    assert Nudges.length == LENGTH
    said = {option.name: option.help for option in schema_of(NetworkOptions)}
    assert f"by default {RADIUS:g}m" in said["moved_radius"]
