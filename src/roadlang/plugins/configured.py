"""A kind with options from Python: for figures, engines and whatever else no scene file names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose, did_you_mean
from .describing import bounds_text, value_text
from .finding import entry_of
from .guard import plugin_guard
from .options import OptionSchema
from .registry import KindEntry, Registry


def configured(
    registry: Registry, verb: str, name: str, options: Mapping[str, Any]
) -> tuple[KindEntry, Any]:
    """The kind that a scene would record as `name`, with `options` in SI units and radians.

    Raises `DiagnosticError`: RL930 where there is no such kind, RL220, RL221 and RL208 for its
    options, RL470 where the plugin fails.
    """
    entry = entry_of(registry, verb, name)
    with plugin_guard(entry, None):
        schemas = entry.options
    owner = f"`{entry.verb} {entry.name}`"
    faults = [*option_faults(owner, schemas, options), *_missing(entry, schemas, options)]
    if faults:
        raise DiagnosticError(*faults)
    with plugin_guard(entry, None):
        return entry, entry.load()(**options)


def option_faults(
    owner: str, schemas: Sequence[OptionSchema], options: Mapping[str, Any]
) -> list[Diagnostic]:
    """RL220 for names that are no options of `owner`, RL208 for numbers out of bounds."""
    return [*_unknown(owner, schemas, options), *_out_of_bounds(schemas, options)]


def _unknown(
    owner: str, schemas: Sequence[OptionSchema], options: Mapping[str, Any]
) -> list[Diagnostic]:
    known = [schema.name for schema in schemas]
    return [
        diagnose(
            Code.UNKNOWN_OPTION,
            owner=owner,
            name=name,
            help=did_you_mean(name, known) or f"its options are {', '.join(known) or 'none'}",
        )
        for name in options
        if name not in known
    ]


def _missing(
    entry: KindEntry, schemas: tuple[OptionSchema, ...], options: Mapping[str, Any]
) -> list[Diagnostic]:
    names = [f"`{s.name}`" for s in schemas if s.required and s.name not in options]
    if not names:
        return []
    sort = "option" if len(names) == 1 else "options"
    owner = f"`{entry.verb} {entry.name}`"
    return [diagnose(Code.MISSING_OPTION, owner=owner, sort=sort, names=", ".join(names))]


def _out_of_bounds(schemas: Sequence[OptionSchema], options: Mapping[str, Any]) -> list[Diagnostic]:
    faults = []
    for schema in schemas:
        value = options.get(schema.name)
        if not isinstance(value, int | float) or isinstance(value, bool):
            continue
        if not schema.constraints.allow(value):
            faults.append(
                diagnose(
                    Code.VALUE_OUT_OF_BOUNDS,
                    what=f"`{schema.name}`",
                    expected=f"be {bounds_text(schema)}",
                    found=f"is {value_text(float(value), schema.type)}",
                )
            )
    return faults
