"""The kinds that are there, by verb and name, and the plugins that are not, with the reason."""

from __future__ import annotations

import importlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from operator import attrgetter
from typing import Any

from .kinds import VERBS, Kind
from .options import OptionSchema, schema_of

SHIPPED = ("standard", "godot")
"""The entry points of the kinds that ship in the wheel, in the order of listings."""


@dataclass(frozen=True, slots=True)
class Origin:
    """The distribution that brings a kind; `plugin` is its entry point, the prefix of its kinds."""

    plugin: str
    distribution: str
    version: str

    @property
    def is_shipped(self) -> bool:
        """Whether this plugin is part of roadlang's own wheel."""
        return self.plugin in SHIPPED

    def __str__(self) -> str:
        return f"{self.distribution} {self.version}"


@dataclass(frozen=True, slots=True)
class KindEntry:
    """A kind that may not be imported yet: `target` is its class or `module:Class`."""

    verb: str
    name: str
    origin: Origin
    target: type[Kind] | str

    @property
    def qualified(self) -> str:
        """`plugin.name`, which no two kinds of one verb share."""
        return f"{self.origin.plugin}.{self.name}"

    @property
    def recorded(self) -> str:
        """The name in scenes and manifests: plain for standard kinds, whatever else there is."""
        return self.name if self.origin.is_shipped else self.qualified

    def load(self) -> type[Kind]:
        """The class. Raises what importing raises, and `TypeError` for what is no such kind; the
        caller blames `origin`."""
        if not isinstance(self.target, str):
            return self.target
        module, _, attribute = self.target.partition(":")
        loaded = attrgetter(attribute)(importlib.import_module(module))
        _check_class(loaded)
        if (loaded.verb, loaded.name) != (self.verb, self.name):
            found = f"`{loaded.verb} {loaded.name}`"
            raise TypeError(f"{self.target} is {found}, not `{self.verb} {self.name}`")
        kind: type[Kind] = loaded
        return kind

    def __reduce__(self) -> tuple[Any, ...]:
        # By its name: a process imports only what it uses, and what nobody uses may be anything.
        target = self.target
        if not isinstance(target, str):
            target = f"{target.__module__}:{target.__qualname__}"
        return KindEntry, (self.verb, self.name, self.origin, target)

    @property
    def options(self) -> tuple[OptionSchema, ...]:
        """The options of the kind. Loads its class."""
        return schema_of(self.load())

    @property
    def help(self) -> str:
        """First line of the kind's docstring. Loads its class."""
        return (self.load().__doc__ or "").strip().split("\n")[0]


@dataclass(frozen=True, slots=True)
class BrokenPlugin:
    """A plugin that could not be loaded, or a part of it that is no kind."""

    origin: Origin
    reason: str


class UnknownKind(KeyError):
    """No plugin brings this kind."""


class AmbiguousKind(KeyError):
    """Several plugins bring it; `entries` are the candidates."""

    def __init__(self, entries: tuple[KindEntry, ...]) -> None:
        super().__init__(entries[0].name)
        self.entries = entries


@dataclass(frozen=True)
class Registry:
    """Looked up by verb and name, plain (`sine`) or qualified (`acme.sine`)."""

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
        """The kind. Raises `UnknownKind`, `AmbiguousKind`."""
        found = self._by_name.get((verb, name), ())
        if not found:
            raise UnknownKind(name)
        if len(found) > 1:
            raise AmbiguousKind(found)
        return found[0]

    def find_recorded(self, verb: str, name: str) -> KindEntry:
        """The kind that a scene names (`KindEntry.recorded`). Raises as `find` does."""
        for plugin in SHIPPED:
            if self.has(verb, f"{plugin}.{name}"):
                return self.find(verb, f"{plugin}.{name}")
        return self.find(verb, name)

    def has(self, verb: str, name: str) -> bool:
        """Whether `verb with name` can be written."""
        return (verb, name) in self._by_name

    def names(self, verb: str) -> tuple[str, ...]:
        """Plain names of all kinds of a verb, in order."""
        return tuple(sorted({entry.name for entry in self.entries if entry.verb == verb}))

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
        """All kinds of a verb."""
        return (entry for entry in self.entries if entry.verb == verb)


def entries_of(kinds: Iterable[type] | Mapping[str, str], origin: Origin) -> list[KindEntry]:
    """The entries of what a `roadlang_kinds` hook returned. Raises `TypeError` with the reason."""
    if isinstance(kinds, Mapping):
        return [_entry_of_target(key, target, origin) for key, target in kinds.items()]
    return [_entry_of_class(kind, origin) for kind in kinds]


def _entry_of_target(key: str, target: str, origin: Origin) -> KindEntry:
    verb, _, name = key.partition(" ")
    if verb not in VERBS or not name.isidentifier():
        raise TypeError(f"`{key}` is not a verb and a name, such as `perturb sine`")
    if not isinstance(target, str) or target.count(":") != 1:
        raise TypeError(f"the target of `{key}` is not `module:Class`: {target!r}")
    return KindEntry(verb, name, origin, target)


def _entry_of_class(kind: object, origin: Origin) -> KindEntry:
    checked = _check_class(kind)
    return KindEntry(checked.verb, checked.name, origin, checked)


def _check_class(kind: object) -> type[Kind]:
    """Raises `TypeError` with what keeps a class from being a kind."""
    if not (isinstance(kind, type) and issubclass(kind, Kind)):
        raise TypeError(f"{kind!r} does not derive from a kind of roadlang.api")
    if not isinstance(kind.name, str) or not kind.name.isidentifier():
        raise TypeError(f"{kind.__name__} has no `name` that is an identifier")
    if kind.verb not in VERBS:
        raise TypeError(f"{kind.__name__} has no verb: derive from `Perturber` or another base")
    schema_of(kind)
    return kind
