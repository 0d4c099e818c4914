"""Memory of large arrays is used again, but never while anybody holds it."""

from __future__ import annotations

import gc
from typing import Any

import numpy as np
import pytest

from roadlang.geometry.arrays import Floats
from roadlang.simulation import recycled_memory
from roadlang.simulation.lines import lines
from roadlang.simulation.recycled_memory import LARGE, MemoryPool
from roadlang.simulation.tapes import repeating
from roadlang.simulation.vehicles import compiled

from .test_numpy_tapes import STANLEY
from .test_same_bytes import bytes_of, drives, records

COUNT = LARGE // 8


def _place(array: Floats) -> int:
    return array.ctypes.data


def test_memory_that_nobody_holds_is_used_again() -> None:
    pool = MemoryPool()
    first = pool.empty(2, COUNT)
    place = _place(first)
    del first
    assert _place(pool.empty(COUNT, 2)) == place


def test_memory_is_not_used_again_while_a_view_of_it_is_held() -> None:
    pool = MemoryPool()
    array = pool.empty(2, COUNT)
    array[:] = 7.0
    view = array.T[COUNT // 2 :, 1]
    del array
    other = pool.empty(2, COUNT)
    other[:] = 3.0
    assert (view == 7.0).all()
    place = _place(view)
    del view
    there = range(place - 16 * COUNT, place)
    assert _place(pool.empty(2, COUNT)) in there


def test_arrays_begin_where_a_processor_fetches_memory() -> None:
    assert _place(MemoryPool().empty(COUNT, 1)) % 64 == 0


def test_small_arrays_are_as_numpy_makes_them() -> None:
    assert MemoryPool().empty(3, 4).base is None


def test_memory_much_too_large_is_left_for_others() -> None:
    pool = MemoryPool()
    large = pool.empty(4, COUNT)
    place = _place(large)
    del large
    small = pool.empty(COUNT)
    assert _place(pool.empty(4, COUNT)) == place
    assert small.shape == (COUNT,)


def test_the_smallest_memory_that_is_large_enough_is_used() -> None:
    pool = MemoryPool()
    arrays = [pool.empty(3 * COUNT // 2), pool.empty(COUNT)]
    places = [_place(array) for array in arrays]
    while arrays:
        del arrays[0]  # the larger one is unused first
    assert _place(pool.empty(COUNT)) == places[1]


class _TakenByAnother(dict[int, Floats]):
    """Unused memory, all of which another thread takes after this one has looked what is there."""

    def values(self) -> Any:
        found = [*super().values()]
        self.clear()
        return found


def test_memory_that_another_thread_takes_is_not_used() -> None:
    pool = MemoryPool()
    array = pool.empty(COUNT)
    place = _place(array)
    del array
    pool._unused = _TakenByAnother(pool._unused)
    assert _place(pool.empty(COUNT)) != place


def test_no_more_unused_memory_is_kept_than_was_said() -> None:
    pool = MemoryPool(kept=3 * LARGE)
    arrays = [pool.empty(COUNT) for _ in range(4)]
    places = [_place(array) for array in arrays]
    while arrays:
        del arrays[0]  # the first becomes unused first
    kept = list(pool._unused.values())
    assert len(kept) == 2
    assert sum(one.nbytes for one in kept) <= 3 * LARGE
    assert _place(pool.empty(COUNT)) in places[2:]


class _Written(MemoryPool):
    """Memory in which others have left numbers."""

    def __init__(self) -> None:
        super().__init__()
        self.taken = 0

    def empty(self, *shape: int) -> Floats:
        array = super().empty(*shape)
        array[:] = np.nan
        self.taken += 1
        return array


@pytest.mark.parametrize("with_numba", [False, True])
def test_what_others_left_in_memory_is_in_no_trace(
    with_numba: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not with_numba:
        monkeypatch.setattr(compiled, "is_installed", lambda: False)
        monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    scenes, options = records(STANLEY, 6), {"control_step": 0.1}
    expected = [bytes_of(one) for one in drives(scenes, **options)]
    pool = _Written()
    monkeypatch.setattr(recycled_memory, "LARGE", 1024)
    monkeypatch.setattr(repeating, "LARGE", 8192)
    for module in (lines, repeating):
        monkeypatch.setattr(module, "RECYCLED", pool)
    kept: list[Any] = []
    for begin in range(0, 6, 2):
        kept += drives(scenes[begin : begin + 2], **options)
    again = drives(scenes, **options)  # while the first traces are held, and not read yet
    assert pool.taken > 6
    assert [bytes_of(one) for one in again] == expected
    assert [bytes_of(one) for one in kept] == expected


def test_memory_is_free_with_the_last_trace(monkeypatch: pytest.MonkeyPatch) -> None:
    """And not only once the garbage collector comes by."""
    monkeypatch.setattr(compiled, "is_installed", lambda: False)
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    pool = MemoryPool()
    monkeypatch.setattr(recycled_memory, "LARGE", 1024)
    monkeypatch.setattr(repeating, "LARGE", 8192)
    for module in (lines, repeating):
        monkeypatch.setattr(module, "RECYCLED", pool)
    scenes = records(STANLEY, 3)
    gc.collect()
    gc.disable()
    try:
        traces = drives(scenes, control_step=0.1)
        held = len(pool._unused)
        del traces
        assert len(pool._unused) > held
        places = {*pool._unused}
        del scenes
        gc.collect()
        assert {*pool._unused} == places
    finally:
        gc.enable()
