"""What a drive signal measures, checked: of a whole trace, or of many agents at one moment."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from .guard import plugin_guard
from .kinds import DriveSignal
from .option_types import EntityType, OptionType
from .options import schema_of
from .registry import KindEntry
from .results import real_numbers

if TYPE_CHECKING:
    from ..geometry.arrays import Floats
    from ..ir.trace import Trace


def drive_signal_kind(entry: KindEntry) -> type[DriveSignal]:
    """The kind, loaded."""
    kind = entry.load()
    assert issubclass(kind, DriveSignal)
    return kind


def named_entities(entry: KindEntry, options: Mapping[str, Any]) -> dict[str, str]:
    """The options that name agents and objects, with those names."""
    named = [option.name for option in schema_of(entry.load()) if _takes_actors(option.type)]
    return {name: str(options[name]) for name in named if options.get(name) is not None}


def _takes_actors(type_: OptionType) -> bool:
    return isinstance(type_, EntityType) and not {"agent", "object"}.isdisjoint(type_.roles)


def drive_signal_values(entry: KindEntry, options: Mapping[str, Any], trace: Trace) -> Floats:
    """What a drive signal gives for options that hold agents. Raises RL470, RL474."""
    kind = drive_signal_kind(entry)
    with plugin_guard(entry, None):
        found = kind(**options).values_in(trace)
    return real_numbers(found, "values", entry, None)
