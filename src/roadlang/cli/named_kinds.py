"""Kinds that are asked for by name, and their options as text."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from .plugin_listing import kind_lines

if TYPE_CHECKING:
    from ..plugins.registry import KindEntry, Registry


def named_kinds(registry: Registry, words: Sequence[str]) -> list[KindEntry]:
    """Those of a name, or of a verb and a name (`emit svg`, `emit with svg`), or, where no kind has
    the name, those of the plugin that does; loaded."""
    from ..plugins.guard import plugin_guard

    spoken = [word for word in words if word != "with"]
    if not 1 <= len(spoken) <= 2:
        return []
    verb = _VERBS.get(spoken[0], spoken[0]) if len(spoken) == 2 else None
    found = [
        entry
        for entry in registry.entries
        if spoken[-1] in (entry.name, entry.qualified) and verb in (None, entry.verb)
    ]
    if not found and verb is None:
        found = [entry for entry in registry.entries if entry.origin.plugin == spoken[-1]]
    for entry in found:
        with plugin_guard(entry, None):
            entry.load()
    return found


def other_names(registry: Registry, words: Sequence[str]) -> tuple[str, ...]:
    """Help where kinds have the last word as another name, as in other tools."""
    from ..plugins.finding import called
    from ..plugins.kinds import VERBS

    meant = ((verb, called(registry, verb, words[-1])) for verb in VERBS)
    return tuple(f"did you mean `{verb} {name}`?" for verb, name in meant if name)


_VERBS = {"require": "monitor", "expect": "monitor"}
"""What scene files write before kinds that are listed under another verb."""


def kinds_text(entries: Sequence[KindEntry]) -> str:
    """Each kind with its options."""
    return "\n\n".join("\n".join(kind_lines(entry)) for entry in entries)
