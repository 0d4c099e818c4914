"""The entry points through which plugins are found; looking for them imports none of them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .installed import EntryPoint, Installed, entry_points

GROUP = "roadlang"
"""`acme = "roadlang_acme"`: a module with the hooks of a plugin, imported by all commands that look
for kinds."""
KINDS = "roadlang.kinds."
"""`[roadlang.kinds.acme]` with `perturb.sine = "roadlang_acme:Sine"`: the kinds of the plugin
`acme`. Its modules are imported only where a scene names a kind in them."""
COMMANDS = "roadlang.commands"
"""`hello = "roadlang_acme.commands:hello"`: a `click.Command`."""
DISTRIBUTION = "roadlang"
"""What we are called: what comes from this distribution is shipped with roadlang."""
BLOCKED_VARIABLE = "ROADLANG_NO_PLUGINS"
"""Comma-separated names of plugins that are not loaded; `all` loads none."""
_FIRST = "standard"


@dataclass(frozen=True, slots=True)
class Origin:
    """The distribution that brings a kind; `plugin` is its entry point, the prefix of its kinds.

    `is_shipped`: it is roadlang itself, whatever its entry points are called.
    """

    plugin: str
    distribution: str
    version: str
    is_shipped: bool = False

    def __str__(self) -> str:
        return f"{self.distribution} {self.version}"


@dataclass(frozen=True)
class Candidate:
    """A plugin, or a command of a plugin, that may be broken.

    `name` is that of the plugin or command. `kinds` are the kinds of a plugin that names them in
    its metadata: `module:Class` by verb and name (`perturb sine`).
    """

    name: str
    origin: Origin
    point: EntryPoint | None
    plugin: Any = None
    kinds: Mapping[str, str] | None = None

    def load(self) -> Any:
        """What the entry point leads to; raises whatever importing it raises."""
        return self.point.load() if self.point is not None else self.plugin

    @property
    def installed(self) -> Installed | None:
        """The distribution, of what is installed."""
        return None if self.point is None else self.point.installed


def plugin_candidates(blocked: Iterable[str] = ()) -> list[Candidate]:
    """The installed plugins that are not disabled, shipped ones first."""
    return _not_blocked(_installed_plugins(entry_points(GROUP)), blocked)


def _installed_plugins(every: Sequence[EntryPoint]) -> list[Candidate]:
    found = [
        Candidate(point.name, _origin_of(point, point.name), point)
        for point in every
        if point.group == GROUP
    ]
    groups = dict.fromkeys(point.group for point in every if point.group.startswith(KINDS))
    for group in groups:
        points = [point for point in every if point.group == group]
        found += _with_kinds(group.removeprefix(KINDS), points)
    return found


def _with_kinds(name: str, points: Iterable[EntryPoint]) -> Iterator[Candidate]:
    """The plugins of one name that list their kinds: one for each distribution."""
    by_origin: dict[Origin, list[EntryPoint]] = {}
    for point in points:
        by_origin.setdefault(_origin_of(point, name), []).append(point)
    for origin, ours in by_origin.items():
        kinds = {point.name.replace(".", " ", 1): point.value for point in ours}
        yield Candidate(name, origin, ours[0], kinds=kinds)


def command_candidates() -> list[Candidate]:
    """The commands of plugins that are not disabled, shipped ones first.

    A command belongs to the plugin of its distribution that has the same top-level package, or to
    the first plugin of it; of a distribution without plugins, to one of the command's name.
    """
    every = entry_points(GROUP)
    commands = [point for point in every if point.group == COMMANDS]
    plugins = _installed_plugins(every) if commands else ()
    found = []
    for point in commands:
        providers = [p for p in plugins if p.installed == point.installed]
        near = [
            p for p in providers if p.point is not None and _package(p.point) == _package(point)
        ]
        owner = (near or providers)[0].name if providers else point.name
        found.append(Candidate(point.name, _origin_of(point, owner), point))
    return _not_blocked(found)


def blocked_by_environment() -> frozenset[str]:
    """The plugins that `--no-plugin` and the environment leave out."""
    words = os.environ.get(BLOCKED_VARIABLE, "").split(",")
    return frozenset(word.strip() for word in words if word.strip())


def _not_blocked(found: Iterable[Candidate], blocked: Iterable[str] = ()) -> list[Candidate]:
    refused = {*blocked, *blocked_by_environment()}
    if "all" in refused:
        return []
    return sorted((each for each in found if each.origin.plugin not in refused), key=_order)


def _order(candidate: Candidate) -> tuple[bool, bool, str, str]:
    # What ships comes first in every listing; otherwise order means nothing.
    origin = candidate.origin
    return not origin.is_shipped, candidate.name != _FIRST, candidate.name, origin.distribution


def _origin_of(point: EntryPoint, plugin: str) -> Origin:
    name = point.installed.name
    return Origin(plugin, name, point.installed.version, name.lower() == DISTRIBUTION)


def _package(point: EntryPoint) -> str:
    return point.module.partition(".")[0]
