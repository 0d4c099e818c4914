"""Where a name that is no option of a block does belong: to a kind beside it or in it."""

from __future__ import annotations

from collections.abc import Iterable

from ...plugins.finding import called
from ..checker import Checker, ResolvedKind
from .kinds import display_name, loaded

_FEW = 2
"""Of more kinds that have an option, the list of options tells more."""


def kind_as_option(checker: Checker, name: str, verbs: Iterable[str]) -> tuple[str, ...]:
    """Help where the name of a kind stands as an option: `waypoints` in the block of a road, which
    has passes of these verbs."""
    found = [verb for verb in verbs if checker.registry.has(verb, name)]
    return tuple(_write(verb, name) for verb in found[:1])


def option_elsewhere(checker: Checker, name: str, verbs: Iterable[str]) -> tuple[str, ...]:
    """The one or two kinds of these verbs that have the option, or the kind that is also called
    so."""
    verbs = tuple(verbs)
    found = [
        f"`{display_name(verb, kind.entry.name)}`"
        for verb in verbs
        for kind in map(loaded, checker.registry.of(verb))
        if isinstance(kind, ResolvedKind) and any(option.name == name for option in kind.schema)
    ]
    if 0 < len(found) <= _FEW:
        return (f"`{name}` is an option of {' and '.join(found)}",)
    kinds = [(verb, called(checker.registry, verb, name)) for verb in verbs]
    return tuple(_write(verb, kind) for verb, kind in kinds if kind is not None)


def _write(verb: str, kind: str) -> str:
    return f"write `{display_name(verb, kind)} {{ ... }}`"
