"""The entry points through which plugins are found; looking for them imports none of them."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from importlib.metadata import Distribution, EntryPoint

GROUP = "roadlang"
"""`acme = "roadlang_acme"`: a module with the hooks of a plugin."""
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
    """A plugin, or a command of one, that may turn out to be broken. `name` is its own."""

    name: str
    origin: Origin
    point: EntryPoint | None
    plugin: Any = None

    def load(self) -> Any:
        """What the entry point leads to; raises whatever importing it raises."""
        return self.point.load() if self.point is not None else self.plugin

    @property
    def installed(self) -> Distribution | None:
        """The distribution, of what is installed."""
        return None if self.point is None else self.point.dist


def plugin_candidates(blocked: Iterable[str] = ()) -> list[Candidate]:
    """The plugins that nobody has left out, shipped ones first."""
    from importlib.metadata import entry_points  # which imports 40 modules

    found = (
        Candidate(point.name, _origin_of(point, point.name), point)
        for point in entry_points(group=GROUP)
    )
    return _kept(found, blocked)


def command_candidates() -> list[Candidate]:
    """The commands of plugins that nobody has left out, shipped ones first.

    A command belongs to the plugin of its distribution that has the same top-level package, or to
    the first plugin of it; of a distribution without plugins, to one of the command's name.
    """
    from importlib.metadata import entry_points

    commands = entry_points(group=COMMANDS)
    plugins = entry_points(group=GROUP) if commands else ()
    found = []
    for point in commands:
        of_it = [p for p in plugins if p.dist is not None and _same(p.dist, point.dist)]
        near = [p for p in of_it if _package(p) == _package(point)]
        owner = (near or of_it or [point])[0].name
        found.append(Candidate(point.name, _origin_of(point, owner), point))
    return _kept(found)


def blocked_by_environment() -> frozenset[str]:
    """The plugins that `--no-plugin` and the environment leave out."""
    words = os.environ.get(BLOCKED_VARIABLE, "").split(",")
    return frozenset(word.strip() for word in words if word.strip())


def _kept(found: Iterable[Candidate], blocked: Iterable[str] = ()) -> list[Candidate]:
    refused = {*blocked, *blocked_by_environment()}
    if "all" in refused:
        return []
    return sorted((each for each in found if each.origin.plugin not in refused), key=_order)


def _order(candidate: Candidate) -> tuple[bool, bool, str, str]:
    # What ships comes first in every listing; otherwise order means nothing.
    origin = candidate.origin
    return not origin.is_shipped, candidate.name != _FIRST, candidate.name, origin.distribution


def _origin_of(point: EntryPoint, plugin: str) -> Origin:
    if point.dist is None:
        return Origin(plugin, point.value, "0")
    name = point.dist.metadata["Name"]
    return Origin(plugin, name, point.dist.version, name.lower() == DISTRIBUTION)


def _package(point: EntryPoint) -> str:
    return point.value.partition(":")[0].partition(".")[0]


def _same(one: Distribution, other: Distribution | None) -> bool:
    return other is not None and one.metadata["Name"] == other.metadata["Name"]
