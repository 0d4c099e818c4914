"""A kind with options from Python: for figures, engines and whatever else no scene file names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from .finding import entry_of
from .given_options import given_options, option_faults
from .guard import plugin_guard
from .options import OptionSchema
from .registry import KindEntry, Registry


def configured(
    registry: Registry, verb: str, name: str, options: Mapping[str, Any]
) -> tuple[KindEntry, Any]:
    """The kind that a scene would record as `name`, with `options` in SI units and radians.

    Raises `DiagnosticError`: RL930 where there is no such kind, RL220, RL221, RL206,
    RL223 and RL208 for its options, RL470 where the plugin fails.
    """
    entry = entry_of(registry, verb, name)
    with plugin_guard(entry, None):
        schemas = entry.options
    options = given_options(schemas, options)
    owner = f"`{entry.verb} {entry.name}`"
    faults = [*option_faults(owner, schemas, options), *_missing(entry, schemas, options)]
    if faults:
        raise DiagnosticError(*faults)
    with plugin_guard(entry, None):
        return entry, entry.load()(**options)


def _missing(
    entry: KindEntry, schemas: tuple[OptionSchema, ...], options: Mapping[str, Any]
) -> list[Diagnostic]:
    names = [f"`{s.name}`" for s in schemas if s.required and s.name not in options]
    if not names:
        return []
    sort = "option" if len(names) == 1 else "options"
    owner = f"`{entry.verb} {entry.name}`"
    return [diagnose(Code.MISSING_OPTION, owner=owner, sort=sort, names=", ".join(names))]
