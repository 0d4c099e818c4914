"""What worker processes share."""

from __future__ import annotations

import shutil
from multiprocessing.shared_memory import SharedMemory

import pytest

from roadlang.search.shared_state import SharedState, read

VALUE = {"roads": [1.5, 2.5], "name": "bent"}


def test_a_value_is_read_until_it_is_withdrawn() -> None:
    shared = SharedState(VALUE)
    assert isinstance(shared.reference, tuple)
    assert read(shared.reference) == read(shared.reference) == VALUE
    shared.withdraw()
    shared.withdraw()
    with pytest.raises(FileNotFoundError):
        read(shared.reference)


def test_where_memory_is_short_the_value_goes_along(monkeypatch: pytest.MonkeyPatch) -> None:
    """Writing beyond the memory of a container would kill the process."""
    full = shutil.disk_usage("/")._replace(free=10)
    monkeypatch.setattr(shutil, "disk_usage", lambda folder: full)
    shared = SharedState(VALUE)
    assert isinstance(shared.reference, bytes)
    assert read(shared.reference) == VALUE
    shared.withdraw()


def test_where_there_is_no_shared_memory_the_value_goes_along(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refused(*_: object, **__: object) -> None:
        raise OSError("no such device")

    monkeypatch.setattr(SharedMemory, "__init__", refused)
    assert read(SharedState(VALUE).reference) == VALUE
