"""The kinds that are there, by verb and name, and the plugins that are not, with the reason."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from operator import attrgetter
from typing import Any

from .entry_points import Origin
from .kind_checks import KindFault, check_kind, check_name
from .kinds import VERBS, Kind
from .options import OptionSchema, schema_of

_MOST_HINTS = 3


@dataclass(frozen=True, slots=True)
class KindEntry:
    """A kind that may not be imported yet: `target` is its class or `module:Class`."""

    verb: str
    name: str
    origin: Origin
    target: type[Kind] | str

    @property
    def qualified(self) -> str:
        """`acme.sine`: the name that no other plugin can bring."""
        return f"{self.origin.plugin}.{self.name}"

    @property
    def recorded(self) -> str:
        """The name in scenes and manifests: plain for shipped kinds, which plain names mean."""
        return self.name if self.origin.is_shipped else self.qualified

    def load(self) -> type[Kind]:
        """The class. Raises what importing raises, and `TypeError` for what is no such kind; the
        caller attributes it to `origin`."""
        if not isinstance(self.target, str):
            return self.target
        return _imported(self.target, self.verb, self.name)

    def __reduce__(self) -> tuple[Any, ...]:
        # By its name: a process imports only what it uses, and what nobody uses may be anything.
        target = self.target
        if not isinstance(target, str):
            target = f"{target.__module__}:{target.__qualname__}"
        return KindEntry, (self.verb, self.name, self.origin, target)

    @property
    def options(self) -> tuple[OptionSchema, ...]:
        """The options of the kind, which is imported for them."""
        return schema_of(self.load())

    @property
    def help(self) -> str:
        """The first paragraph of the docstring of the kind, which is imported for it."""
        first = inspect.cleandoc(self.load().__doc__ or "").split("\n\n")[0]
        return " ".join(first.split())


@cache
def _imported(target: str, verb: str, name: str) -> type[Kind]:
    """The kind at `module:Class`, which calls itself so."""
    module, _, attribute = target.partition(":")
    loaded = check_kind(attrgetter(attribute)(importlib.import_module(module)))
    if (loaded.verb, loaded.name) != (verb, name):
        raise KindFault(f"it is `{loaded.verb} {loaded.name}`, not `{verb} {name}`", loaded)
    return loaded


@dataclass(frozen=True, slots=True)
class BrokenPlugin:
    """A plugin that could not be loaded, or one of its kinds, `kind`, where the others could."""

    origin: Origin
    reason: str
    kind: str = ""

    def __str__(self) -> str:
        what = f"{self.kind} of {self.origin}" if self.kind else f"the plugin {self.origin}"
        return f"{what} could not be loaded: {self.reason}"


class UnknownKind(KeyError):
    """No plugin brings this kind."""


class AmbiguousKind(KeyError):
    """Several plugins bring it, none of them shipped; `entries` are the candidates."""

    def __init__(self, entries: tuple[KindEntry, ...]) -> None:
        super().__init__(entries[0].name)
        self.entries = entries


@dataclass(frozen=True)
class Registry:
    """Looked up by verb and name, plain (`sine`) or qualified (`acme.sine`).

    A plain name means the shipped kind where there is one, whatever else is installed.
    """

    entries: tuple[KindEntry, ...] = ()
    broken: tuple[BrokenPlugin, ...] = ()
    planned: frozenset[str] = frozenset()
    _by_name: Mapping[tuple[str, str], tuple[KindEntry, ...]] = field(
        init=False, repr=False, compare=False
    )

    def __post_init__(self) -> None:
        by_name: dict[tuple[str, str], tuple[KindEntry, ...]] = {}
        for entry in self.entries:
            for name in (entry.name, entry.qualified):
                key = (entry.verb, name)
                by_name[key] = (*by_name.get(key, ()), entry)
        object.__setattr__(self, "_by_name", by_name)

    def find(self, verb: str, name: str) -> KindEntry:
        """The kind that a name means, in a scene file or in a scene. Raises `UnknownKind`, and
        `AmbiguousKind` where two strangers bring it."""
        found = self._by_name.get((verb, name), ())
        if not found:
            raise UnknownKind(name)
        meant = [entry for entry in found if entry.origin.is_shipped] or found
        if len(meant) > 1:
            raise AmbiguousKind(found)
        return meant[0]

    def shadowed(self, entry: KindEntry) -> tuple[KindEntry, ...]:
        """The kinds of other plugins that have the plain name of this one."""
        named = self._by_name.get((entry.verb, entry.name), ())
        return tuple(other for other in named if other is not entry)

    def shipped_first(self, verbs: Iterable[str], name: str) -> list[str]:
        """The verbs that have a kind of this name, those of shipped kinds before all others."""
        having = [verb for verb in verbs if self.has(verb, name)]
        return sorted(having, key=lambda verb: not self._is_shipped(verb, name))

    def _is_shipped(self, verb: str, name: str) -> bool:
        return any(entry.origin.is_shipped for entry in self._by_name[verb, name])

    def has(self, verb: str, name: str) -> bool:
        """Whether `find` has something to find."""
        return (verb, name) in self._by_name

    def names(self, verb: str) -> tuple[str, ...]:
        """Plain names of all kinds of a verb, in order."""
        return tuple(sorted({entry.name for entry in self.entries if entry.verb == verb}))

    def broken_kind(self, verbs: Iterable[str], name: str) -> BrokenPlugin | None:
        """The reason why a kind is not there: it, or the whole plugin that it names, is broken."""
        plugin, dot, plain = name.rpartition(".")
        for broken in self.broken:
            if dot and plugin != broken.origin.plugin:
                continue
            verb, _, kind = broken.kind.partition(" ")
            if (verb in verbs and kind == plain) or (dot and not broken.kind):
                return broken
        return None

    @property
    def hints(self) -> tuple[str, ...]:
        """Help lines about broken plugins for where something was not found: it may be in one of
        them."""
        lines = [str(broken) for broken in self.broken]
        more = len(lines) - _MOST_HINTS
        rest = f"{more} more could not be loaded; `roadlang plugins` shows why"
        return tuple(lines[:_MOST_HINTS]) + ((rest,) if more > 0 else ())

    def is_planned(self, verb: str, name: str) -> bool:
        """Whether a kind is planned; `planned` holds `"emit gltf"`, `"read opendrive .xodr"`."""
        return name in self.planned_names(verb)

    def planned_names(self, verb: str) -> tuple[str, ...]:
        """The planned kinds of a verb, in order."""
        words = (text.split() for text in sorted(self.planned))
        return tuple(word[1] for word in words if len(word) > 1 and word[0] == verb)

    def planned_reader(self, suffix: str) -> str | None:
        """The planned reader of files with this ending."""
        for text in sorted(self.planned):
            verb, *rest = text.split()
            if verb == "read" and suffix in rest[1:]:
                return rest[0]
        return None

    def defaults(self, verb: str) -> Iterator[KindEntry]:
        """The kinds that a file means where it names none of the verb.

        Only kinds in the wheel count: a plugin that is installed besides must not change what a
        file means.
        """
        shipped = (entry for entry in self.of(verb) if entry.origin.is_shipped)
        return (entry for entry in shipped if entry.load().is_default)

    def default(self, verb: str) -> KindEntry:
        """The first of `defaults`. Raises `UnknownKind` without the plugins of the wheel."""
        found = next(self.defaults(verb), None)
        if found is None:
            raise UnknownKind(verb)
        return found

    def of(self, verb: str) -> Iterator[KindEntry]:
        """The kinds of a verb, shipped ones first."""
        return (entry for entry in self.entries if entry.verb == verb)


def entries_of(
    kinds: Iterable[type] | Mapping[str, str], origin: Origin
) -> tuple[list[KindEntry], list[BrokenPlugin]]:
    """The entries of what a `roadlang_kinds` hook returned, and those that are none."""
    if isinstance(kinds, Mapping):
        return _gathered(_entry_of_target, kinds.items(), origin)
    return _gathered(_entry_of_class, kinds, origin)


def _gathered(
    make: Callable[[Any, Origin], KindEntry], items: Iterable[Any], origin: Origin
) -> tuple[list[KindEntry], list[BrokenPlugin]]:
    entries: list[KindEntry] = []
    broken: list[BrokenPlugin] = []
    for item in items:
        try:
            entries.append(make(item, origin))
        except KindFault as fault:
            broken.append(BrokenPlugin(origin, str(fault), fault.kind))
    return entries, broken


def _entry_of_target(item: tuple[Any, Any], origin: Origin) -> KindEntry:
    key, target = item
    verb, _, name = str(key).partition(" ")
    if verb not in VERBS:
        raise KindFault(f"`{key}` is not a verb and a name, such as `perturb sine`")
    check_name(name)
    if not isinstance(target, str) or target.count(":") != 1:
        raise KindFault(f"the target of `{key}` is not `module:Class`: {target!r}")
    return KindEntry(verb, name, origin, target)


def _entry_of_class(kind: object, origin: Origin) -> KindEntry:
    checked = check_kind(kind)
    return KindEntry(checked.verb, checked.name, origin, checked)
