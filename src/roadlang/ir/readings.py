"""Readings of sensors, as controllers get them and as files keep them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .read_only import ReadOnlyMapping

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..geometry.arrays import Floats


class Reading(ReadOnlyMapping[str, Any]):
    """A reading of a sensor: named arrays, `reading.distances` or `reading["distances"]`.

    Of one agent an array has the shape that the sensor states, and is a `float` where that is ();
    in a batch it has a leading axis of N agents. `time`: when it was measured, in seconds as the
    `time` of observations.
    """

    __slots__ = ("_arrays", "time")

    def __init__(self, time: Any, arrays: Mapping[str, Any]) -> None:
        self.time = time
        self._arrays = arrays

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._arrays:
            known = ", ".join(self._arrays) if not name.startswith("_") else ""
            raise AttributeError(f"a reading has no array `{name}`; it has {known}")
        return self._arrays[name]

    def __getitem__(self, name: str) -> Any:
        return self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __reduce__(self) -> tuple[Any, ...]:
        return Reading, (self.time, dict(self._arrays))

    def single(self, row: int) -> Reading:
        """That of one agent of a batch."""
        arrays = {name: array[row] for name, array in self._arrays.items()}
        numbers = {name: a.item() if a.ndim == 0 else a for name, a in arrays.items()}
        return Reading(float(self.time[row]), numbers)


class Readings(ReadOnlyMapping[str, Reading]):
    """Readings by the names of sensors; the error for another name says which there are."""

    __slots__ = ("_known",)

    def __init__(self, known: Mapping[str, Reading]) -> None:
        self._known = known

    def __getitem__(self, name: str) -> Reading:
        if name not in self._known:
            raise KeyError(no_such_sensor(name, self))
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._known)

    def __len__(self) -> int:
        return len(self._known)


def no_such_sensor(name: str, known: Iterable[str]) -> str:
    """What is wrong with asking for a sensor that agents do not have."""
    return f"there is no sensor `{name}`; the agent has {', '.join(known) or 'none'}"


def batch_of_one(reading: Reading) -> Reading:
    """The reading of one agent as that of a batch."""
    import numpy as np

    arrays = {name: np.asarray(array)[None] for name, array in reading.items()}
    return Reading(np.array([reading.time]), arrays)


ARRAYS_ENDING = "npz"
"""of the files that hold the arrays of records"""


@dataclass(frozen=True, slots=True)
class SensorRecord:
    """The readings of one sensor in a drive, in the order of their measurement."""

    agent: str
    sensor: str
    time: Floats
    """(K,) seconds, of the measurements"""
    arrival: Floats
    """(K,) seconds, when controllers got them"""
    arrays: Mapping[str, NDArray[Any]]
    """each (K, ...)"""
    files: Mapping[str, bytes] = field(default_factory=dict)
    """what the kind writes of them, by the ends of the names"""
