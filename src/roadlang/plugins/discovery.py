"""Finds the plugins that are installed and collects their kinds; a broken one breaks nothing."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from importlib.metadata import EntryPoint, entry_points
from typing import Any

import pluggy

from . import hookspecs
from .compatibility import unmet_requirement
from .guard import PluginFault, attributed
from .kind_checks import KindFault, check_name
from .registry import BrokenPlugin, KindEntry, Origin, Registry, entries_of

GROUP = "roadlang"
DISTRIBUTION = "roadlang"
"""What we are called: kinds of this distribution are the shipped ones."""
BLOCKED_VARIABLE = "ROADLANG_NO_PLUGINS"
"""Comma-separated entry point names that are not loaded; `all` loads none."""
_FIRST = "standard"


def load_registry(blocked: Iterable[str] = ()) -> Registry:
    """The registry of all installed plugins but those in `blocked` and in the environment.

    A plugin that fails in any way is left out and listed in `Registry.broken` with the reason.
    """
    return collect(candidates(GROUP, blocked))


def registry_of(plugins: Mapping[str, Any], *, installed: bool = False) -> Registry:
    """The shipped kinds and those of plugin modules or objects by name, for tests and programs
    that embed us. `installed`: also those of all installed plugins."""
    found = [point for point in candidates(GROUP) if installed or point.origin.is_shipped]
    given = (Candidate(Origin(name, name, "0"), None, plugin) for name, plugin in plugins.items())
    return collect([*found, *given])


def blocked_by_environment() -> frozenset[str]:
    """The plugins that `--no-plugin` and the environment leave out."""
    words = os.environ.get(BLOCKED_VARIABLE, "").split(",")
    return frozenset(word.strip() for word in words if word.strip())


@dataclass(frozen=True)
class Candidate:
    """A plugin, or a command of one, that may turn out to be broken."""

    origin: Origin
    point: EntryPoint | None
    plugin: Any = None

    def load(self) -> Any:
        """The plugin itself; raises whatever importing it raises."""
        return self.point.load() if self.point is not None else self.plugin


def candidates(group: str, blocked: Iterable[str] = ()) -> list[Candidate]:
    """The entry points of a group that nobody has left out, shipped ones first."""
    refused = {*blocked, *blocked_by_environment()}
    if "all" in refused:
        return []
    found = [Candidate(_origin_of(point), point) for point in entry_points(group=group)]
    kept = (candidate for candidate in found if candidate.origin.plugin not in refused)
    return sorted(kept, key=_order)


def _order(candidate: Candidate) -> tuple[bool, bool, str, str]:
    # What ships comes first in every listing; otherwise order means nothing.
    origin = candidate.origin
    return not origin.is_shipped, origin.plugin != _FIRST, origin.plugin, origin.distribution


def _origin_of(point: EntryPoint) -> Origin:
    if point.dist is None:
        return Origin(point.name, point.value, "0")
    name = point.dist.metadata["Name"]
    return Origin(point.name, name, point.dist.version, name.lower() == DISTRIBUTION)


def collect(found: Iterable[Candidate]) -> Registry:
    """Load each candidate by itself and gather what the healthy ones bring."""
    found = list(found)
    entries: list[KindEntry] = []
    broken: list[BrokenPlugin] = []
    planned: set[str] = set()
    for candidate in found:
        try:
            _check_entry_point(candidate, found)
            with attributed():
                brought, faults, expected = _load(candidate)
        except (KindFault, PluginFault) as fault:
            broken.append(BrokenPlugin(candidate.origin, str(fault)))
        else:
            entries.extend(brought)
            broken.extend(faults)
            planned.update(expected)
    return Registry(tuple(entries), tuple(broken), frozenset(planned))


def _check_entry_point(candidate: Candidate, found: list[Candidate]) -> None:
    """Raises `KindFault`: its kinds could not be told from others', or not be written at all."""
    origin = candidate.origin
    check_name(origin.plugin, "its entry point")
    others = [c.origin for c in found if c is not candidate and c.origin.plugin == origin.plugin]
    if others and not origin.is_shipped:
        owner = next((other for other in others if other.is_shipped), others[0])
        raise KindFault(f"its entry point `{origin.plugin}` is also that of {owner}")
    if candidate.point is not None and candidate.point.dist is not None:
        unmet = unmet_requirement(candidate.point.dist)
        if unmet is not None:
            raise KindFault(unmet)


def _load(candidate: Candidate) -> tuple[list[KindEntry], list[BrokenPlugin], list[str]]:
    plugin = candidate.load()
    # A manager for each plugin: one that raises in a hook would take the others' results along.
    manager = pluggy.PluginManager(GROUP)
    manager.add_hookspecs(hookspecs)
    manager.register(plugin, candidate.origin.plugin)
    manager.check_pending()
    if not manager.get_hookcallers(plugin):
        raise KindFault("it implements no hook of roadlang (is `@hookimpl` missing?)")
    entries: list[KindEntry] = []
    broken: list[BrokenPlugin] = []
    for kinds in manager.hook.roadlang_kinds():
        good, bad = entries_of(kinds, candidate.origin)
        entries, broken = [*entries, *good], [*broken, *bad]
    entries, twice = _once_each(entries, candidate.origin)
    broken += twice
    planned = [text for texts in manager.hook.roadlang_planned() for text in texts]
    if not (entries or broken or planned):
        raise KindFault("its hook `roadlang_kinds` returned no kinds")
    return entries, broken, planned


def _once_each(
    entries: list[KindEntry], origin: Origin
) -> tuple[list[KindEntry], list[BrokenPlugin]]:
    """The kinds that a plugin brings once; neither of two of one name is the one that is meant."""
    counts = Counter((entry.verb, entry.name) for entry in entries)
    twice = [f"{verb} {name}" for (verb, name), count in counts.items() if count > 1]
    broken = [BrokenPlugin(origin, f"it brings `{kind}` twice", kind) for kind in twice]
    return [entry for entry in entries if counts[entry.verb, entry.name] == 1], broken
