"""Places of networks that were moved by hand, as the text of a scene file has them."""

from __future__ import annotations

import pytest

from roadlang.syntax.network_edits import (
    NetworkMoves,
    found_network,
    network_moves_of,
    with_network_moves,
)

TEXT = """image plan from "plan.png" { scale: 1m/px }
network base from plan { lanes: 2 }
network wide from base
network moved from wide { perturb with sine { amplitude: 1m, wavelength: 50m } }
road main from base
"""
MOVES = NetworkMoves(((1.0, 2.0), (30.0, -4.0)), ((0.5, 0.0), (0.0, -2.0)))


@pytest.mark.parametrize("name", ["base", "wide", "moved"])
def test_what_was_found_is_at_the_bottom_of_what_is_derived(name: str) -> None:
    assert found_network(TEXT, name) == "base"


@pytest.mark.parametrize("name", ["main", "plan", "nothing"])
def test_what_is_no_network_was_not_found(name: str) -> None:
    assert found_network(TEXT, name) is None


def test_chains_of_any_length_end_and_circles_too() -> None:
    chain = "".join(f"network n{i + 1} from n{i}\n" for i in range(150))
    assert found_network("network n0 from plan\n" + chain, "n150") == "n0"
    assert found_network("network a from b\nnetwork b from a\n", "a") is None
    assert found_network("network a from a\n", "a") is None


@pytest.mark.parametrize("name", ["base", "wide"])
def test_moves_that_are_written_are_read_and_replaced(name: str) -> None:
    assert network_moves_of(TEXT, name) == NetworkMoves()
    once = with_network_moves(TEXT, name, MOVES)
    assert once is not None
    assert network_moves_of(once, name) == MOVES
    other = NetworkMoves(MOVES.at[:1], MOVES.by[1:])
    twice = with_network_moves(once, name, other)
    assert twice is not None
    assert network_moves_of(twice, name) == other
    assert with_network_moves(twice, name, MOVES) == once


def test_nothing_to_move_and_nothing_that_can_be_moved_is_not_written() -> None:
    assert with_network_moves(TEXT, "base", NetworkMoves()) is None
    assert with_network_moves(TEXT, "nothing", MOVES) is None
    assert network_moves_of(TEXT, "nothing") is None


@pytest.mark.parametrize(
    ("options", "radius"),
    [
        ("moved_at: [(1m, 2m)], moved_by: [(0m, 3m)], moved_radius: 9m", 9.0),
        ("moved_at: [(1m, 2m)], moved_by: [(0m, 3m)]", NetworkMoves().radius),
        ("moved_at: [(1m, 2m)], moved_by: [(0m, 3m), (1m, 1m)]", None),
        ("moved_at: [(1m, 2m)]", None),
        ("moved_at: [(x, 2m)], moved_by: [(0m, 3m)]", None),
        ("moved_at: [(1m, 2m)], moved_by: [(0m, 3m)], moved_radius: 3m..9m", None),
    ],
)
def test_moves_are_read_where_they_are_numbers(options: str, radius: float | None) -> None:
    found = network_moves_of(f"network base from plan {{ {options} }}\n", "base")
    assert (None if found is None else found.radius) == radius
