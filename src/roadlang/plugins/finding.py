"""The kind that a name means, or the diagnostic that says why there is none to be had."""

from __future__ import annotations

from collections.abc import Iterable

from ..diagnostics import Code, Diagnostic, DiagnosticError, Span, diagnose, did_you_mean
from .attribution import PluginFault, attributed
from .registry import AmbiguousKind, KindEntry, Registry

_NOUNS = {"simulate": "engine", "emit": "backend"}


def find_entry(registry: Registry, verb: str, name: str, span: Span | None = None) -> KindEntry:
    """The kind that a command or a scene names.

    Raises `UnknownKind`, and `DiagnosticError` RL213 where several plugins bring it.
    """
    try:
        return registry.find(verb, name)
    except AmbiguousKind as error:
        shown = f"{verb} {name}"
        raise DiagnosticError(ambiguous_kind(error.entries, shown, span)) from None


def entry_of(registry: Registry, verb: str, name: str) -> KindEntry:
    """As `find_entry`. Raises `DiagnosticError` RL930 where there is no such kind."""
    if not registry.has(verb, name):
        known = registry.names(verb)
        meant = called(registry, verb, name)
        near = (f"did you mean `{meant}`?",) if meant else did_you_mean(name, known)
        hints = near or (f"there are {', '.join(known)}",)
        what = _NOUNS.get(verb, f"`{verb}` kind")
        raise DiagnosticError(diagnose(Code.UNKNOWN_CHOICE, what=what, name=name, help=hints))
    return find_entry(registry, verb, name)


def called(registry: Registry, verb: str, word: str) -> str | None:
    """The kind of a verb that has this as another name; plugins that fail are passed over."""
    for entry in registry.of(verb):
        try:
            with attributed():
                names = entry.load().also_called
        except PluginFault:
            continue
        if word in names:
            return entry.name
    return None


def ambiguous_kind(
    entries: Iterable[KindEntry], shown: str, span: Span | None = None
) -> Diagnostic:
    """RL213: plugins that are not ours bring a kind of one name; `shown` is how it was written."""
    entries = tuple(entries)
    return diagnose(
        Code.AMBIGUOUS_KIND,
        span,
        kind=shown,
        owners=" and ".join(str(entry.origin) for entry in entries),
        help="write " + " or ".join(f"`{entry.qualified}`" for entry in entries),
    )
