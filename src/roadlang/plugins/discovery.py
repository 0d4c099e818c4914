"""Finds the plugins that are installed and collects their kinds; a broken one breaks nothing."""

from __future__ import annotations

import os
from collections.abc import Iterable
from importlib.metadata import Distribution, EntryPoint, entry_points
from typing import Any

import pluggy

from . import hookspecs
from .guard import PluginFault, attributed
from .registry import SHIPPED, BrokenPlugin, KindEntry, Origin, Registry, entries_of

GROUP = "roadlang"
BLOCKED_VARIABLE = "ROADLANG_NO_PLUGINS"
"""Comma-separated entry point names that are not loaded; `all` loads none."""


def load_registry(blocked: Iterable[str] = ()) -> Registry:
    """The registry of all installed plugins but those in `blocked` and in the environment.

    A plugin that fails in any way is left out and listed in `Registry.broken` with the reason.
    """
    refused = {*blocked, *_blocked_by_environment()}
    points = [] if "all" in refused else sorted(entry_points(group=GROUP), key=_order)
    return collect(_Candidate(point.name, point) for point in points if point.name not in refused)


def registry_of(plugins: dict[str, Any]) -> Registry:
    """A registry of plugin modules or objects by name, for tests and programs that embed us."""
    return collect(_Candidate(name, None, plugin) for name, plugin in plugins.items())


def _blocked_by_environment() -> list[str]:
    words = os.environ.get(BLOCKED_VARIABLE, "").split(",")
    return [word.strip() for word in words if word.strip()]


def _order(point: EntryPoint) -> tuple[int, str]:
    # What ships comes first in every listing; otherwise order means nothing.
    place = SHIPPED.index(point.name) if point.name in SHIPPED else len(SHIPPED)
    return (place, point.name)


class _Candidate:
    """A plugin that may turn out to be broken."""

    def __init__(self, name: str, point: EntryPoint | None, plugin: Any = None) -> None:
        self.name = name
        self._point = point
        self._plugin = plugin

    @property
    def origin(self) -> Origin:
        distribution: Distribution | None = self._point.dist if self._point else None
        if distribution is None:
            return Origin(self.name, self.name, "0")
        return Origin(self.name, distribution.metadata["Name"], distribution.version)

    def load(self) -> Any:
        return self._point.load() if self._point is not None else self._plugin


def collect(candidates: Iterable[_Candidate]) -> Registry:
    """Load each candidate by itself and gather what the healthy ones bring."""
    entries: list[KindEntry] = []
    broken: list[BrokenPlugin] = []
    planned: set[str] = set()
    for candidate in candidates:
        origin = candidate.origin
        try:
            with attributed():
                found, expected = _load(candidate, origin)
        except PluginFault as fault:
            broken.append(BrokenPlugin(origin, str(fault)))
        else:
            entries.extend(found)
            planned.update(expected)
    return Registry(tuple(entries), tuple(broken), frozenset(planned))


def _load(candidate: _Candidate, origin: Origin) -> tuple[list[KindEntry], list[str]]:
    plugin = candidate.load()
    # A manager for each plugin: one that raises in a hook would take the others' results along.
    manager = pluggy.PluginManager(GROUP)
    manager.add_hookspecs(hookspecs)
    manager.register(plugin, candidate.name)
    manager.check_pending()
    if not manager.get_hookcallers(plugin):
        raise TypeError("it implements no hook of roadlang (is `@hookimpl` missing?)")
    entries: list[KindEntry] = []
    for kinds in manager.hook.roadlang_kinds():
        entries.extend(entries_of(kinds, origin))
    _refuse_duplicates(entries)
    planned = [text for texts in manager.hook.roadlang_planned() for text in texts]
    if not (entries or planned):
        raise TypeError("its hook `roadlang_kinds` returned no kinds")
    return entries, planned


def _refuse_duplicates(entries: Iterable[KindEntry]) -> None:
    seen: set[tuple[str, str]] = set()
    for entry in entries:
        if (entry.verb, entry.name) in seen:
            raise TypeError(f"it brings `{entry.verb} {entry.name}` twice")
        seen.add((entry.verb, entry.name))
