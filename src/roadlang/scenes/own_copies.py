"""Conditions of the controllers of a group: the name of the group in them means the copy itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from ..ir.read_only import frozen
from ..ir.scene import Call

Drives = list[tuple[Call, ...]]
"""The controllers of each copy, or, where all copies have the same, of all."""


def of_own_copies(
    scenes: Sequence[Drives], group: str, names: Sequence[Sequence[str]]
) -> list[Drives]:
    """The controllers of the copies of a group in each scene, which are called `names` there: where
    a condition is about `group`, it is about the copy that drives."""
    known: dict[tuple[int, int], Drives] = {}
    found: list[Drives] = []
    for drives, copies in zip(scenes, names, strict=True):
        if not any(_speaks_of(call, group) for drive in drives for call in drive):
            found.append(drives)
            continue
        key = id(drives), len(copies)
        if key not in known:
            each = drives if len(drives) > 1 else [*drives] * len(copies)
            known[key] = [
                tuple(_about(call, group, name) for call in drive)
                for drive, name in zip(each, copies, strict=False)
            ]
        found.append(known[key])
    return found


def _speaks_of(call: Call, group: str) -> bool:
    conditions = (found for found in (call.when, call.during) if found is not None)
    return any(
        group in signal["options"].values()
        for condition in conditions
        for signal in condition["signals"].values()
    )


def _about(call: Call, group: str, name: str) -> Call:
    when, during = (_renamed(found, group, name) for found in (call.when, call.during))
    return replace(call, when=when, during=during)


def _renamed(condition: Mapping[str, Any] | None, group: str, name: str) -> Any:
    if condition is None:
        return None
    signals = {
        variable: {
            **signal,
            "options": {
                option: name if value == group else value
                for option, value in signal["options"].items()
            },
        }
        for variable, signal in condition["signals"].items()
    }
    return frozen({**condition, "signals": signals})
