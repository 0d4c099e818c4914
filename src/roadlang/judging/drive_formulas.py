"""Conditions on drives `{formula, signals, numbers}`, read once for all drives that they judge."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from ..ir.read_only import FrozenDict
from ..plugins.drive_signals import drive_signal_kind, named_entities
from ..plugins.finding import entry_of
from ..plugins.registry import KindEntry, Registry
from ..stl import Formula, from_json
from ..stl.formats.evaluation_json import evaluation_from_json
from ..stl.formula.evaluation_options import EvaluationOptions


@dataclass(frozen=True)
class VariableSignal:
    """A drive signal that a formula calls `variable`."""

    variable: str
    entry: KindEntry
    options: Mapping[str, Any]
    entities: Mapping[str, str]
    """the options that name agents and objects, with those names"""
    is_member: bool
    """of each member of a group by itself (`walkers.speed`)"""

    @property
    def members(self) -> frozenset[str]:
        """The agents and groups of a member signal."""
        return frozenset(self.entities.values() if self.is_member else ())


@dataclass(frozen=True)
class DriveFormula:
    """A formula over a drive, with what its variables stand for and how it is evaluated."""

    formula: Formula
    evaluation: EvaluationOptions
    numbers: Mapping[str, float]
    signals: tuple[VariableSignal, ...]


def drive_formula(condition: Mapping[str, Any], registry: Registry) -> DriveFormula:
    """What a condition says. Raises RL930 for a signal that no plugin brings."""
    if type(condition) is FrozenDict:  # the scenes of a run share theirs, and it cannot change
        return _kept(_Same(condition), _Same(registry))
    return _read(condition, registry)


class _Same:
    """An object as a key: equal to itself alone, and kept as long as the key is."""

    __slots__ = ("it",)

    def __init__(self, it: Any) -> None:
        self.it = it

    def __hash__(self) -> int:
        return id(self.it)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and self.it is other.it


@lru_cache(maxsize=64)
def _kept(condition: _Same, registry: _Same) -> DriveFormula:
    return _read(condition.it, registry.it)


def _read(condition: Mapping[str, Any], registry: Registry) -> DriveFormula:
    return DriveFormula(
        from_json(condition["formula"]),
        evaluation_from_json(condition.get("evaluation", {})),
        {name: float(number) for name, number in condition.get("numbers", {}).items()},
        tuple(
            _variable_signal(name, call, registry)
            for name, call in condition.get("signals", {}).items()
        ),
    )


def _variable_signal(variable: str, call: Mapping[str, Any], registry: Registry) -> VariableSignal:
    entry = entry_of(registry, "drive_signal", str(call["kind"]))
    options = call.get("options", {})
    is_member = drive_signal_kind(entry).member
    return VariableSignal(variable, entry, options, named_entities(entry, options), is_member)
