"""Curves that are pushed again and again: by compiled loops they are the same to the last bit."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from roadlang.geometry import CurveBatch, MovedBatch, displace
from roadlang.geometry.arrays import Floats
from roadlang.geometry.batches import compiled_rows, pushed_batch, row_loops
from roadlang.geometry.batches.pushed_batch import PushedBatch
from roadlang.geometry.numbers import compiling
from tests.geometry.geometry_shapes import circle, line

numba = pytest.importorskip("numba")
COUNT = 70
"""More rows than are moved together."""
KNOWN = ("points", "curvature", "speed", "toward_east", "toward_north", "heading", "folded")


@pytest.fixture
def compiled(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Whether the compiled loops are used, in a list; first they are."""
    used = [True]
    monkeypatch.setattr(compiled_rows, "pays", lambda numbers: used[0])
    return used


@pytest.fixture
def by_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    """Rows go through all their moves by numpy, few at a time."""
    monkeypatch.setattr(compiled_rows, "pays", lambda numbers: False)
    monkeypatch.setattr(pushed_batch, "_MANY", 0)


def waves(stations: Floats, length: float, size: float) -> list[Floats]:
    random = np.random.default_rng(4)
    turns = 2.0 * np.pi * stations / length
    sizes = size * random.uniform(0.1, 1.0, (3, COUNT, 1))
    varied = [sizes[k] * np.sin(random.integers(1, 9, (COUNT, 1)) * turns) for k in range(3)]
    return [*varied, 0.3 * np.cos(3.0 * turns)[None]]


def pushed(closed: bool, size: float, used: list[bool], fast: bool) -> CurveBatch:
    used[0] = fast
    road = circle(radius=40.0, count=300) if closed else line(250.0)
    stations = road.stations(count=180)
    found: CurveBatch = displace(road, stations, waves(stations, road.length, 0.5)[0])
    for wave in waves(stations, road.length, size):
        found = displace(found, stations, wave)
    return found


@pytest.mark.parametrize("size", [0.5, 6.0])
@pytest.mark.parametrize("closed", [False, True])
def test_compiled_they_are_the_same_to_the_last_bit(
    closed: bool, size: float, compiled: list[bool]
) -> None:
    fast = pushed(closed, size, compiled, fast=True)
    slow = pushed(closed, size, compiled, fast=False)
    assert isinstance(fast, PushedBatch)
    assert isinstance(slow, MovedBatch)
    for name in KNOWN:
        assert getattr(fast, name).tobytes() == getattr(slow, name).tobytes(), name
    assert slow.folded.any() == (size > 1.0)
    assert not slow.folded.all()


@pytest.mark.parametrize("size", [0.5, 6.0])
@pytest.mark.parametrize("closed", [False, True])
def test_by_numpy_they_are_the_same_to_the_last_bit(
    closed: bool, size: float, by_numpy: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    fast = pushed(closed, size, [True], fast=True)
    monkeypatch.setattr(pushed_batch, "_MANY", 1 << 30)
    slow = pushed(closed, size, [True], fast=True)
    assert isinstance(fast, PushedBatch)
    assert isinstance(slow, MovedBatch)
    for name in KNOWN:
        assert getattr(fast, name).tobytes() == getattr(slow, name).tobytes(), name


def test_rows_of_them_are_those_rows_before_and_after_they_are_computed(
    compiled: list[bool],
) -> None:
    whole, rows = pushed(False, 6.0, compiled, fast=False), np.array([3, 41, 69, 8])
    for known in ((), KNOWN):
        fast = pushed(False, 6.0, compiled, fast=True)
        for name in known:
            getattr(fast, name)
        some = fast.take(rows).take(np.array([0, 2, 3]))
        for name in KNOWN:
            same = getattr(whole, name)[rows[[0, 2, 3]]].tobytes()
            assert getattr(some, name).tobytes() == same, name
        assert fast.heading_of(rows).tobytes() == whole.heading[rows].tobytes()


def test_one_that_was_computed_or_chosen_from_is_pushed_on(compiled: list[bool]) -> None:
    slow, fast = (pushed(True, 0.5, compiled, fast=fast) for fast in (False, True))
    rows = np.array([5, 2, 60])
    assert fast.points.shape == (COUNT, 180, 2)
    more = 0.2 * np.sin(np.linspace(0.0, 4.0 * np.pi, 181))[:-1]
    for base, batch in ((slow, fast), (slow.take(rows), fast.take(rows))):
        compiled[0] = False
        expected = displace(base, base.stations, more)
        compiled[0] = True
        found = displace(batch, batch.stations, more)
        assert isinstance(found, PushedBatch)
        for name in KNOWN:
            assert getattr(found, name).tobytes() == getattr(expected, name).tobytes(), name


def test_they_are_compiled_where_numba_is_loaded_and_there_is_enough_to_do(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(compiled_rows, "_worked", [0])
    monkeypatch.delitem(sys.modules, "numba", raising=False)
    assert not compiled_rows.pays(compiled_rows.LOADING + 1)
    monkeypatch.setitem(sys.modules, "numba", np)
    assert not compiled_rows.pays(1000)
    assert compiled_rows.pays(compiled_rows.LOADING)


@pytest.mark.slow
def test_no_texts_are_compiled_with_them(compiled: list[bool]) -> None:
    calls: list[tuple[object, ...]] = []
    loop = compiled_rows.loop()

    def called(*given: object) -> None:
        calls.append(given)
        loop(*given)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiled_rows, "loop", lambda: called)
        assert pushed(False, 0.5, compiled, fast=True).folded is not None
    again = numba.njit(nogil=True, **compiling.OPTIONS)(row_loops.pushed)
    again(*calls[0])
    (code,) = again.inspect_llvm().values()
    assert "unicode" not in code  # of a message: it takes three times as long to compile
