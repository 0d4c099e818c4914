"""`override left.ego { ... }`: other options and passes of what an included file declares."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ...diagnostics import Code, Fix, Label, Span, diagnose
from ...syntax.tree import nodes as ast
from ...syntax.words import LABELED_PASS_VERBS
from ..suggestions import meant_name, suggestion
from .namespaces import Namespace
from .program import Declaration, Program


@dataclass(frozen=True, slots=True)
class PlacedOverride:
    """An override with its names in full; `depth`: how many includes lead to its file."""

    statement: ast.Override
    folder: Path
    depth: int
    space: Namespace


def apply_overrides(
    program: Program, overrides: Sequence[PlacedOverride], depths: Mapping[str, int]
) -> None:
    """Put what overrides hold into the declarations that they name.

    `depths` are those of the declarations. Outer files come last: what they say wins over what the
    files that they include say.
    """
    first: dict[tuple[str, int], Span] = {}
    for override in sorted(overrides, key=lambda placed: -placed.depth):
        target = override.statement.target
        declared = _declaration(program, override)
        if declared is None or not _is_included(program, override, declared, depths):
            continue
        known = first.setdefault((declared.name.text, override.depth), target.span)
        if known is not target.span:
            labels = [Label(known, "the first one")]
            _refused(Code.DUPLICATE_OVERRIDE, program, target, labels=labels)
            continue
        block = override.statement.block
        if block is None or (block.complete and not block.items):
            _refused(Code.EMPTY_OVERRIDE, program, target)
            continue
        _apply(program, override, declared, block)


def _declaration(program: Program, override: PlacedOverride) -> Declaration | None:
    """What an override names, or None, reported."""
    target = override.statement.target
    front = target
    while isinstance(front, ast.Member | ast.Numbered):
        front = front.of
    assert isinstance(front, ast.Name), "the grammar lets only references through"
    if front.text in program.spoiled:
        return None
    declared = program.declarations.get(front.text)
    if isinstance(target, ast.Name) and target.text in override.space.aliases:
        help_ = f"name what it declares: `override {target.text}.NAME {{ ... }}`"
        _refused(Code.NOT_OVERRIDABLE, program, target, what="a whole file", help=help_)
    elif declared is None:
        _report_unknown(program, front, override.space)
    elif front is not target:
        help_ = f"name the declaration, `{front.span.text}`, and write options in the braces"
        what = "one copy" if isinstance(target, ast.Numbered) else "a member of a declaration"
        _refused(Code.NOT_OVERRIDABLE, program, target, what=what, help=help_)
    elif not isinstance(declared.statement, ast.Geometry | ast.Actor):
        _report_other(program, target, declared.role)
    else:
        return declared
    return None


def _report_unknown(program: Program, name: ast.Name, space: Namespace) -> None:
    if program.incomplete:
        return
    within = {
        f"{alias}.{name}" for alias, inner in space.aliases.items() for name in inner.declared
    }
    meant = meant_name(name.text, sorted({*space.declared, *space.aliases, *within}))
    fixes = [Fix(name.span, meant)] if meant else []
    help_ = suggestion(name.text, meant) if meant else ()
    program.diagnostics.append(
        diagnose(Code.UNKNOWN_NAME, name.span, name=name.text, help=help_, fixes=fixes)
    )


def _report_other(program: Program, target: ast.Expression, role: str) -> None:
    help_ = "only images, networks, roads, agents and objects have options and passes"
    if role == "param":
        help_ = 'set it where the file is included: `include "FILE" { PARAM: value }`'
    article = "an" if role[0] in "aeiou" else "a"
    _refused(Code.NOT_OVERRIDABLE, program, target, what=f"{article} `{role}`", help=help_)


def _is_included(
    program: Program,
    override: PlacedOverride,
    declared: Declaration,
    depths: Mapping[str, int],
) -> bool:
    """Whether what is overridden is of a file further in; reported if not."""
    if depths[declared.name.text] > override.depth:
        return True
    target = override.statement.target
    place = declared.name.span
    same = place.source is target.span.source
    _refused(
        Code.NOT_INCLUDED, program, target,
        labels=[Label(place, "declared here")],
        help="it is declared in this file: edit the declaration" if same
        else f"it is declared in `{place.source.path}`, which this file does not include",
    )  # fmt: skip
    return False


def _apply(
    program: Program, override: PlacedOverride, declared: Declaration, block: ast.Block
) -> None:
    statement = declared.statement
    assert isinstance(statement, ast.Geometry | ast.Actor)
    source = override.statement.span.source
    program.declarations[declared.name.text] = replace(
        declared,
        statement=replace(statement, block=_merged(statement.block, block)),
        override_folders={**declared.override_folders, source.path: override.folder},
    )


def _merged(before: ast.Block | None, after: ast.Block) -> ast.Block:
    """The items of both; those of `after` stand where what they replace stood, else at the end."""
    if before is None:
        return after
    waiting: dict[tuple[str, str], list[ast.Option | ast.Pass]] = {}
    for item in after.items:
        waiting.setdefault(_replaced_by(item), []).append(item)
    replaced = set(waiting)
    items: list[ast.Option | ast.Pass] = []
    for item in before.items:
        if _replaced_by(item) in replaced:
            items.extend(waiting.pop(_replaced_by(item), ()))
        else:
            items.append(item)
    for rest in waiting.values():
        items.extend(rest)
    return replace(before, items=tuple(items), complete=before.complete and after.complete)


def _replaced_by(item: ast.Option | ast.Pass) -> tuple[str, str]:
    """What an item replaces: the option of its name, the sensor of its name, or all passes of its
    verb."""
    if isinstance(item, ast.Option):
        return "option", item.key.text
    if item.verb.text in LABELED_PASS_VERBS:
        name = item.kind.text.rpartition(".")[2] if item.label is None else item.label.text
        return f"{item.verb.text} as", name
    return "pass", item.verb.text


def _refused(code: str, program: Program, target: ast.Expression, **values: object) -> None:
    found = diagnose(code, target.span, name=target.span.text, **values)  # type: ignore[arg-type]
    program.diagnostics.append(found)
