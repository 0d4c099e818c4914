"""Rows of numbers that scenes have, and the arrays that are made of them."""

from __future__ import annotations

import copy
import dataclasses
import math
import pickle
from typing import Any

import numpy as np
import pytest

from roadlang.geometry.arrays import read_only
from roadlang.ir.encoding import to_json
from roadlang.ir.read_only import Floats
from roadlang.ir.scene_road import SceneRoad, numbers_of, with_rows

NUMBERS = [0.0, -0.0, 1.5, 1e30]


@pytest.fixture(params=["alone", "of a row"])
def floats(request: pytest.FixtureRequest) -> Floats:
    row = read_only(np.array(NUMBERS))
    return Floats(NUMBERS) if request.param == "alone" else Floats.of_row(NUMBERS, row)


def test_arrays_of_them_have_the_same_bits_as_those_of_a_tuple(floats: Floats) -> None:
    assert np.asarray(floats).tobytes() == np.array(tuple(NUMBERS)).tobytes()
    assert np.array(floats, np.float32).dtype == np.float32
    assert np.stack([floats, floats], axis=-1).shape == (4, 2)
    assert np.asarray(Floats()).shape == (0,)


def test_what_is_written_to_an_array_changes_nothing_else(floats: Floats) -> None:
    np.asarray(floats)[0] = 7.0
    assert floats[0] == 0.0
    assert np.asarray(floats)[0] == 0.0


def test_they_are_pickled_as_numbers_alone(floats: Floats) -> None:
    again = pickle.loads(pickle.dumps(floats))
    assert type(again) is Floats
    assert again == floats
    assert len(pickle.dumps(floats)) == len(pickle.dumps(Floats(NUMBERS)))
    assert [*map(math.copysign, [1.0] * 4, again)] == [1.0, -1.0, 1.0, 1.0]
    assert np.asarray(again).tobytes() == np.array(NUMBERS).tobytes()


def test_a_road_of_rows_is_pickled_with_its_rows() -> None:
    row = read_only(np.arange(1000.0))
    columns = ("stations", "x", "y", "heading", "curvature", "width")
    road = with_rows(
        SceneRoad("bent", (), (0.0, 1.0), (), (), (), (), (), 2, False, 2.0, "main"),
        dict.fromkeys(columns, row),
    )
    content = pickle.dumps(road)
    assert len(content) < len(columns) * row.nbytes + 1000
    assert not any(_is_made(road, name) for name in columns)
    again = pickle.loads(content)
    assert not any(_is_made(again, name) for name in columns)
    assert again == road
    assert not numbers_of(again, "x").flags.writeable


def test_a_road_of_rows_makes_tuples_when_they_are_read_and_is_else_like_any_other() -> None:
    columns = ("stations", "x", "y", "heading", "curvature", "width")
    rows = {name: read_only(np.arange(3.0) + len(name) / 4.0) for name in columns}
    members: dict[str, Any] = {
        "name": "bent", "reference_stations": (0.0, 1.0, 2.0), "lanes": 2, "closed": False,
        "root": "main", "length": 2.0,
    }  # fmt: skip
    plain = SceneRoad(**members | {name: tuple(row.tolist()) for name, row in rows.items()})
    template = SceneRoad(**{**members, **dict.fromkeys(columns, ()), "length": 1.0})

    def made() -> SceneRoad:
        return with_rows(template, rows, length=2.0)

    road = made()
    assert numbers_of(road, "x") is rows["x"]
    assert not any(_is_made(road, name) for name in columns)
    assert type(road.x) is Floats
    assert road.x is road.x
    assert _is_made(road, "x")
    assert not _is_made(road, "y")
    assert made() == plain
    assert plain == made()
    assert hash(made()) == hash(plain)
    assert to_json(made()) == to_json(plain)
    assert dataclasses.replace(made(), lanes=3) == dataclasses.replace(plain, lanes=3)
    for again in (copy.copy(made()), copy.deepcopy(made()), pickle.loads(pickle.dumps(made()))):
        assert again == plain
    assert numbers_of(plain, "x").tolist() == list(plain.x)
    for either in (road, plain):
        with pytest.raises(AttributeError, match="no member `elevator`"):
            either.elevator  # type: ignore[attr-defined]  # noqa: B018


def _is_made(road: SceneRoad, name: str) -> bool:
    try:
        vars(SceneRoad)[name].__get__(road)
    except AttributeError:
        return False
    return True
