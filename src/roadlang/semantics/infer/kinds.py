"""Kinds by name, and diagnostics for those that do not exist."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...diagnostics import Code, Span
from ...plugins.attribution import PluginFault, attributed
from ...plugins.finding import called
from ...plugins.kinds import VERBS
from ...plugins.options import schema_of
from ...plugins.registry import AmbiguousKind, KindEntry, UnknownKind
from ..checker import Checker, ResolvedKind
from ..suggestions import meant_name
from .kinds_elsewhere import kind_help

MOST_LISTED = 12
"""Names in one line of help"""
FUNCTIONS = ("signal", "drive_signal", "number", "distribution", "piece", "select", "region",
             "lane", "position")  # fmt: skip
"""Verbs whose kinds are written as calls, `route(p, q)`."""
_NOUNS = {
    "agent": "kind of agent",
    "object": "kind of object",
    "piece": "piece of a road",
    "select": "way to choose a road",
    "region": "region",
    "lane": "kind of lane",
    "position": "position",
    "monitor": "monitor",
}


def find_kind(checker: Checker, verb: str, name: str, span: Span) -> ResolvedKind | None:
    """The kind, or None, with the reason reported at `span`."""
    key = (verb, name)
    if key in checker.kinds and (known := checker.kinds[key]) is not None:
        return known
    try:
        entry = checker.registry.find(verb, name)
    except AmbiguousKind as error:
        names = " or ".join(f"`{entry.qualified}`" for entry in error.entries)
        owners = " and ".join(str(entry.origin) for entry in error.entries)
        help_ = f"write {names}"
        checker.report(
            Code.AMBIGUOUS_KIND, span, kind=display_name(verb, name), owners=owners, help=help_
        )
        return None
    except UnknownKind:
        _report_missing(checker, verb, name, span)
        return None
    found = _load(checker, entry, span)
    if name == entry.name:
        _warn_of_others(checker, entry, span)
    checker.kinds[key] = found
    return found


def _warn_of_others(checker: Checker, entry: KindEntry, span: Span) -> None:
    """A plain name means the shipped kind: the one of another plugin is written with the plugin's
    name."""
    for other in checker.registry.shadowed(entry):
        checker.report(
            Code.SHADOWED_KIND,
            span,
            kind=display_name(entry.verb, entry.name),
            other=other.origin,
            help=f"write `{other.qualified}` for that, or `{entry.qualified}` for this one",
        )


def find_default(checker: Checker, verb: str, span: Span) -> ResolvedKind | None:
    """The kind that a file means where it names none, or None, with the reason reported."""
    try:
        name = checker.registry.default(verb).qualified
    except UnknownKind:
        name = "default"
    return find_kind(checker, verb, name, span)


def verbs_with(checker: Checker, verbs: Iterable[str], name: str) -> list[str]:
    """Those of the verbs that have a kind of this name, a planned one included; those of shipped
    kinds come first, as a plain name means these."""
    registry, verbs = checker.registry, tuple(verbs)
    found = registry.shipped_first(verbs, name)
    return found + [v for v in verbs if v not in found and registry.is_planned(v, name)]


def _load(checker: Checker, entry: KindEntry, span: Span) -> ResolvedKind | None:
    found = loaded(entry)
    if isinstance(found, ResolvedKind):
        return found
    kind_name = display_name(entry.verb, entry.name)
    checker.report(Code.BROKEN_PLUGIN, span, kind=kind_name, plugin=entry.origin, reason=found)
    return None


def loaded(entry: KindEntry) -> ResolvedKind | str:
    """The kind, or why it cannot be had: a plugin may do anything when it is imported."""
    try:
        with attributed():
            kind = entry.load()
            return ResolvedKind(entry, kind, schema_of(kind))
    except PluginFault as fault:
        return str(fault)


def display_name(verb: str, name: str) -> str:
    """A kind as the language writes it: `perturb with sine`, `emit svg`, `car`."""
    if verb in ("emit",):
        return f"emit {name}"
    if verb in (
        "agent",
        "object",
        "piece",
        "select",
        "region",
        "lane",
        "position",
        "signal",
        "drive_signal",
        "number",
    ):
        return name
    if verb in ("distribution", "monitor"):
        return name
    return f"{verb} with {name}"


def _report_missing(checker: Checker, verb: str, name: str, span: Span) -> None:
    registry = checker.registry
    if registry.is_planned(verb, name):
        built = _listing(verb, registry.names(verb))
        checker.report(Code.PLANNED_KIND, span, kind=display_name(verb, name), help=built)
        return
    broken = registry.broken_kind([verb], name)
    if broken is not None:
        kind, plugin, reason = display_name(verb, name), broken.origin, broken.reason
        checker.report(Code.BROKEN_PLUGIN, span, kind=kind, plugin=plugin, reason=reason)
        return
    known = (*registry.names(verb), *registry.planned_names(verb))
    qualified = tuple(entry.qualified for entry in registry.of(verb))
    meant = called(registry, verb, name) or meant_name(name, qualified if "." in name else known)
    if {verb, *verbs_with(checker, ("agent", "object"), name)} == {"agent", "object"}:
        meant = None  # `object b is car` means the agent, not an object with a similar name
    help_ = [] if meant else _of_other_verbs(checker, verb, name) or _not_installed(checker, name)
    if not (meant or help_):
        help_ = _word_of_option(checker, verb, name) or _described(checker, verb, name)
    if not meant and (not help_ or verb == "lane"):  # a lane is no agent: which lanes there are
        help_ += _listing(verb, registry.names(verb))
    if not meant:
        help_ += [*kind_help(verb, name), *registry.hints]
    noun = _NOUNS.get(verb, f"kind of `{verb}`")
    checker.report(Code.UNKNOWN_KIND, span, name=name, noun=noun, help=help_, meant=meant)


def _not_installed(checker: Checker, name: str) -> list[str]:
    plugin, dot, _ = name.rpartition(".")
    there = {entry.origin.plugin for entry in checker.registry.entries}
    return [f"no plugin called `{plugin}` is installed"] if dot and plugin not in there else []


def _word_of_option(checker: Checker, verb: str, word: str) -> list[str]:
    """How to write it with the kinds of a verb that have such a word among the values of an
    option."""
    kinds = [loaded(entry) for entry in checker.registry.of(verb)]
    return [
        f"write `{display_name(verb, kind.entry.name)} {{ {option.name}: {word} }}`"
        for kind in kinds
        if isinstance(kind, ResolvedKind)
        for option in kind.schema
        if word in option.words
    ]


def _described(checker: Checker, verb: str, word: str) -> list[str]:
    """Kinds of a verb that say in the first line of their help that they are such a thing, as
    `ranges` is "a lidar"."""
    kinds = [loaded(entry) for entry in checker.registry.of(verb)]
    lines = {
        kind.entry.name: (kind.kind.__doc__ or "").strip().partition("\n")[0].rstrip(".")
        for kind in kinds
        if isinstance(kind, ResolvedKind)
    }
    words = re.escape(word.replace("_", " "))
    is_named = re.compile(rf"\ban? {words}\b", re.IGNORECASE).search
    return [
        f"`{display_name(verb, name)}`: {line[0].lower()}{line[1:]}"
        for name, line in lines.items()
        if is_named(line)
    ]


def _of_other_verbs(checker: Checker, verb: str, name: str) -> list[str]:
    verbs = [other for other in VERBS if other != verb and checker.registry.has(other, name)]
    return [_written(other, name) for other in verbs[:1]]


def _written(verb: str, name: str) -> str:
    """How a kind of another verb is written."""
    if verb in ("agent", "object"):
        return f"`{name}` is a kind of {verb}: write `{verb} NAME is {name}`"
    if verb == "drive_signal":
        return f"`{name}` is a signal of agents: write it in a formula, as in `ego.{name}`"
    if verb in FUNCTIONS:
        return f"`{name}` is a function: write `{name}(...)`"
    return f"`{name}` is a kind of `{verb}`: write `{display_name(verb, name)}`"


def _listing(verb: str, names: Iterable[str]) -> list[str]:
    known = list(names)
    if not known:
        return [f"no installed plugin provides a kind of `{verb}`"]
    shown = ", ".join(f"`{name}`" for name in known[:MOST_LISTED])
    if len(known) == 1:
        return [f"the only kind of `{verb}` is {shown}"]
    rest = f", ... (`roadlang plugins --verb {verb}` lists all)"
    return [f"the kinds of `{verb}` are {shown}{rest if len(known) > MOST_LISTED else ''}"]
