"""Images, networks and roads."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from ...diagnostics import Code
from ...ir import scenario as ir
from ...ir.values import NO_OPTIONS, Entity, Options, PassCall
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..infer.blocks import lower_options, lower_passes, value_spans
from ..infer.file_readers import reader_of
from ..infer.kinds import find_default
from ..infer.statement_spec import StatementSpec
from ..names.file_checks import file_fault
from ..names.program import Declaration
from ..types.expression_types import DeclaredType, TypedExpression
from .lane_lists import lanes_fit
from .randomness import is_random

_SOURCE_ROLES = {"image": ("image",), "network": ("image", "network"), "road": ("network", "road")}
_MAKERS: dict[str, Any] = {
    "image": ir.ScenarioImage,
    "network": ir.ScenarioNetwork,
    "road": ir.ScenarioRoad,
}


@dataclass(frozen=True, slots=True)
class _ReadSource:
    """A source that was read; `fine` is False where it was reported."""

    source: ir.Source | None
    fine: bool = True


def lower_geometry(
    checker: Checker, spec: StatementSpec, declaration: Declaration
) -> ir.ScenarioImage | ir.ScenarioNetwork | ir.ScenarioRoad | None:
    """The statement, or None, reported."""
    statement = declaration.statement
    assert isinstance(statement, ast.Geometry)
    word, name = statement.word, statement.name.text
    context = Context(user=name, place=name, per="road" if word == "network" else "scene")
    source = _source(checker, statement, declaration.folder, context)
    bound = lower_options(checker, spec, statement.block, Context(name, name), statement.name.span)
    passes = lower_passes(checker, spec, statement.block, context)
    if not (source.fine and bound.complete) or passes is None:
        return None
    if statement.block is not None and not statement.block.complete:
        return None
    if not _spacing_is_fixed(checker, statement, bound.values):
        return None
    if not lanes_fit(checker, statement, bound.stated):
        return None
    if not _belongs_together(checker, statement, source.source, passes):
        return None
    options = _with_default(checker, statement, source.source, passes)
    if options is None:
        return None
    if isinstance(source.source, ir.FileSource):
        checker.program.inputs.append(source.source.resolved)
    lowered: ir.ScenarioImage | ir.ScenarioNetwork | ir.ScenarioRoad = _MAKERS[word](
        name, source.source, bound.values, options, statement.span
    )
    if isinstance(lowered, ir.ScenarioImage):
        return lowered
    return replace(lowered, option_spans=value_spans(statement.block))


_SHARED_BY_ALL = (
    *("station_spacing", "moved_at", "moved_by", "moved_radius", "u_turns"),
    *("drawn", "dismissed", "confirmed"),
)


def _spacing_is_fixed(checker: Checker, statement: ast.Geometry, options: Options) -> bool:
    """Stations are shared by all candidates, so that these can be evaluated together."""
    for name in _SHARED_BY_ALL:
        value = dict(options).get(name)
        if value is None or statement.block is None or not is_random(checker, value):
            continue
        span = next(o.value.span for o in statement.block.options if o.key.text == name)
        checker.report(
            Code.MUST_NOT_BE_RANDOM, span, what=f"`{name}`", expected="the same in every scene"
        )
        return False
    return True


def _source(
    checker: Checker, statement: ast.Geometry, folder: Path, context: Context
) -> _ReadSource:
    source, word = statement.source, statement.word
    if source is None:
        return _ReadSource(None)
    if isinstance(source, ast.String):
        picture = word == "image" and not _has_reader(statement)
        fault = file_fault(folder, source.value, source.span, picture=picture)
        if fault is not None:
            checker.diagnostics.append(fault)
            return _ReadSource(None, fine=False)
        resolved = os.path.join(folder, source.value)
        return _ReadSource(ir.FileSource(source.value, resolved))
    if isinstance(source, ast.Text):
        if word == "image":
            return _ReadSource(ir.TextSource(source.value))
        expected = _expected_source(word)
        checker.report(
            Code.WRONG_TYPE, source.span, what=f"`{word}`", expected=expected, found="a text image"
        )
        return _ReadSource(None, fine=False)
    typed = checker.infer(source, replace(context, roles=_SOURCE_ROLES[word]))
    if typed.is_unknown:
        return _ReadSource(None, fine=False)
    value = typed.value
    fits = isinstance(typed.type, DeclaredType) and typed.type.role in _SOURCE_ROLES[word]
    if fits and isinstance(value, Entity):
        return _ReadSource(ir.NameSource(value.name, value.role))
    _report_source(checker, word, typed)
    return _ReadSource(None, fine=False)


def _report_source(checker: Checker, word: str, typed: TypedExpression) -> None:
    if isinstance(typed.type, DeclaredType):
        name, found = typed.span.text, typed.type
        checker.report(
            Code.WRONG_ENTITY_TYPE,
            typed.span,
            name=name,
            found=found,
            expected=_expected_source(word),
            what=f"`{word}`",
            help=_through_network(word, name, typed.type.role),
        )
    else:
        what = f"`{word}`"
        checker.report(
            Code.WRONG_TYPE,
            typed.span,
            what=what,
            expected=_expected_source(word),
            found=typed.type,
        )


def _through_network(word: str, name: str, role: str) -> tuple[str, ...]:
    if word == "road" and role == "image":
        return (f"extract a network first: `network town from {name}`, then `road NAME from town`",)
    return ()


def _expected_source(word: str) -> str:
    kinds = {"image": "a file, a text or an image", "network": "an image, a file or a network"}
    return kinds.get(word, "a network, a road or a file")


def _has_reader(statement: ast.Geometry) -> bool:
    block = statement.block
    return block is not None and any(item.verb.text == "read" for item in block.passes)


def _belongs_together(
    checker: Checker,
    statement: ast.Geometry,
    source: ir.Source | None,
    passes: tuple[PassCall, ...],
) -> bool:
    """Whether the passes and options are at home with such a source."""
    word, name = statement.word, statement.name
    verbs = [call.verb for call in passes]
    if source is None and (word != "road" or "draw" not in verbs):
        help_ = (
            "write `from` and a network, a road or a file, or `draw with` in its block"
            if word == "road"
            else f"write `from` and {_expected_source(word)}"
        )
        checker.report(Code.MISSING_SOURCE, name.span, name=name.text, help=help_)
        return False
    role = source.role if isinstance(source, ir.NameSource) else None
    wants = {
        "draw": (source is None, "a road without `from`"),
        "read": (isinstance(source, ir.FileSource), "a file"),
        "extract": (role == "image", "an image"),
    }
    for call in passes:
        fits, expected = wants.get(call.verb, (True, ""))
        if not fits and call.span is not None:
            checker.report(Code.INCOMPATIBLE_SOURCE, call.span, verb=call.verb, expected=expected)
            return False
    return _options_belong(checker, statement, source, role)


def _options_belong(
    checker: Checker, statement: ast.Geometry, source: ir.Source | None, role: str | None
) -> bool:
    """Whether the options are at home with such a source."""
    if statement.word == "image" or statement.block is None:
        return True
    options = {option.key.text: option for option in statement.block.options}
    found = (role != "network", "an image or a file")
    needs = {"within": found, "moved_at": found, "moved_by": found}
    needs |= dict.fromkeys(("drawn", "dismissed", "confirmed"), (role == "image", "an image"))
    if statement.word == "road":
        needs = {
            "select": (role == "network" or isinstance(source, ir.FileSource), "a network"),
            "then": (role == "road", "a road"),
            "taper": ("then" in options, "a road with `then`"),
        }
    for name, (fits, expected) in needs.items():
        if name in options and not fits:
            span = options[name].key.span
            checker.report(Code.INCOMPATIBLE_SOURCE, span, verb=name, expected=expected)
            return False
    return _moves_have_places(checker, options)


def _moves_have_places(checker: Checker, options: Mapping[str, ast.Option]) -> bool:
    """Whether `moved_at` and `moved_by` have as many members, where both are written as lists."""
    values = [options[name].value for name in ("moved_at", "moved_by") if name in options]
    counts = [len(value.items) for value in values if isinstance(value, ast.ListValue)]
    if not values or (len(counts) == 2 and counts[0] == counts[1]) or len(counts) < len(values):
        return True
    at, by = counts if len(counts) == 2 else (counts[0], 0)
    if "moved_at" not in options:
        at, by = by, at
    reason = f"has {by} moves, but `moved_at` has {at} places"
    span = values[-1].span
    checker.report(Code.INVALID_OPTION, span, option="moved_by", kind="network", reason=reason)
    return False


def _with_default(
    checker: Checker,
    statement: ast.Geometry,
    source: ir.Source | None,
    passes: tuple[PassCall, ...],
) -> tuple[PassCall, ...] | None:
    """The passes with the implicit one: `extract with auto`, or a reader."""
    if any(call.verb in ("extract", "read", "draw") for call in passes):
        return passes
    name = statement.name.text
    if isinstance(source, ir.NameSource) and source.role == "image" and statement.word != "image":
        assert statement.source is not None
        found = find_default(checker, "extract", statement.source.span)
        if found is None:
            return None
        return (
            PassCall("extract", found.entry.qualified, NO_OPTIONS, f"{name}/extract 1"),
            *passes,
        )
    if isinstance(source, ir.FileSource) and statement.word != "image":
        assert statement.source is not None
        kind = reader_of(checker, source.path, statement.word, statement.source.span)
        if kind is None:
            return None
        return (PassCall("read", kind, NO_OPTIONS, f"{name}/read 1"), *passes)
    return passes
