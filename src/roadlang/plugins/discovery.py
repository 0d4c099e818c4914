"""Finds the plugins that are installed and collects their kinds; a broken one breaks nothing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any

import pluggy

from . import hookspecs
from .attribution import PluginFault, attributed
from .compatibility import unmet_requirement
from .entry_points import GROUP, Candidate, Origin, plugin_candidates
from .kind_checks import KindFault, check_name
from .registry import BrokenPlugin, KindEntry, Registry, entries_of


def load_registry(blocked: Iterable[str] = ()) -> Registry:
    """The registry of all installed plugins but those in `blocked` and in the environment.

    A plugin that fails in any way is left out and listed in `Registry.broken` with the reason.
    """
    return collect(plugin_candidates(blocked))


def registry_of(plugins: Mapping[str, Any], *, installed: bool = False) -> Registry:
    """The shipped kinds and those of plugin modules or objects by name, for tests and programs
    that embed us. `installed`: also those of all installed plugins."""
    found = [point for point in plugin_candidates() if installed or point.origin.is_shipped]
    extra = (
        Candidate(name, Origin(name, name, "0"), None, plugin) for name, plugin in plugins.items()
    )
    return collect([*found, *extra])


def collect(found: Iterable[Candidate]) -> Registry:
    """Load each candidate separately and collect the kinds of those that work."""
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
        except KeyboardInterrupt as error:  # it may hang
            raise KeyboardInterrupt(f"while {candidate.origin} was loaded") from error
        else:
            entries.extend(brought)
            broken.extend(faults)
            planned.update(expected)
    return Registry(tuple(entries), tuple(broken), frozenset(planned))


def _check_entry_point(candidate: Candidate, found: list[Candidate]) -> None:
    """Raises `KindFault`: its kinds could not be distinguished from others', or could not be
    written in a scene file."""
    origin = candidate.origin
    check_name(origin.plugin, "its entry point")
    others = [c.origin for c in found if c is not candidate and c.origin.plugin == origin.plugin]
    if others and not origin.is_shipped:
        owner = next((other for other in others if other.is_shipped), others[0])
        raise KindFault(f"its entry point `{origin.plugin}` is also that of {owner}")
    unmet = unmet_requirement(candidate.installed)
    if unmet is not None:
        raise KindFault(unmet)


def _load(candidate: Candidate) -> tuple[list[KindEntry], list[BrokenPlugin], list[str]]:
    if candidate.kinds is not None:
        return *entries_of(candidate.kinds, candidate.origin), []
    plugin = candidate.load()
    if candidate.origin.is_shipped:
        return _shipped(plugin, candidate.origin)
    return _hooked(plugin, candidate.origin)


@cache
def _shipped(plugin: Any, origin: Origin) -> tuple[list[KindEntry], list[BrokenPlugin], list[str]]:
    """What a plugin in the wheel brings, which is the same whenever it is asked."""
    return _hooked(plugin, origin)


def _hooked(plugin: Any, origin: Origin) -> tuple[list[KindEntry], list[BrokenPlugin], list[str]]:
    """What the hooks of a plugin bring."""
    # A manager for each plugin: one that raises in a hook would take the others' results along.
    manager = pluggy.PluginManager(GROUP)
    manager.add_hookspecs(hookspecs)
    manager.register(plugin, origin.plugin)
    manager.check_pending()
    if not manager.get_hookcallers(plugin):
        raise KindFault("it implements no hook of roadlang (is `@hookimpl` missing?)")
    entries: list[KindEntry] = []
    broken: list[BrokenPlugin] = []
    for kinds in manager.hook.roadlang_kinds():
        good, bad = entries_of(kinds, origin)
        entries, broken = [*entries, *good], [*broken, *bad]
    entries, twice = _once_each(entries, origin)
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
    broken = [BrokenPlugin(origin, f"it provides `{kind}` twice", kind) for kind in twice]
    return [entry for entry in entries if counts[entry.verb, entry.name] == 1], broken
