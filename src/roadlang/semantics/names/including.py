"""Reads a scene file and what it includes; names must be declared once in all of them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from ...diagnostics import (
    Code,
    Diagnostic,
    Fix,
    Label,
    Source,
    Span,
    diagnose,
    did_you_mean,
    nearest,
)
from ...files.reading import LARGEST_SCENE_FILE, UnreadableFile, read_file, written_text
from ...syntax import parse
from ...syntax.tree import nodes as ast
from .file_checks import missing_file
from .namespaces import Namespace, resolved
from .overriding import PlacedOverride, apply_overrides
from .program import Declaration, Program, Setting
from .setting_values import parsed_setting

MOST_INCLUDES = 200
BUILT_IN = frozenset({"abs", "min", "max", "fresh", "time", "inf"})


def load(path: Path, text: str, overrides: Mapping[str, str | Source]) -> Program:
    """The program of a scene file; what is wrong with it is in its `diagnostics`."""
    source = Source(str(path), text)
    program, space = Program(path, source), Namespace()
    loader = _Loader(program)
    loader.read(source, path, (), space)
    loader.declare_all()
    for name, value in overrides.items():
        loader.override(name, value, space)
    return program


@dataclass(frozen=True, slots=True)
class _Found:
    """A statement as it was read; `depth`: how many includes lead to its file."""

    statement: ast.Statement
    folder: Path
    space: Namespace
    depth: int


class _Loader:
    """Reads all files first: what a name means may be declared in a later one."""

    def __init__(self, program: Program) -> None:
        self._program = program
        self._included: dict[tuple[str, str], Span] = {}
        self._found: list[_Found] = []
        self._spaces: dict[str, Namespace] = {}
        """where the value of each setting stands"""

    def read(
        self, source: Source, path: Path, chain: tuple[str, ...], space: Namespace
    ) -> set[str]:
        """Add the statements of one file; returns the params that it and its includes have."""
        tree, found = parse(source)
        self._program.diagnostics.extend(found)
        self._program.spoiled.update(space.prefix + word.text for word in tree.spoiled)
        self._program.inputs.append(source.path)
        depth = len(chain)
        chain = (*chain, os.path.realpath(path))
        params: set[str] = set()
        for statement in tree.statements:
            if isinstance(statement, ast.Include):
                params |= self._include(statement, path.parent, chain, space)
                continue
            self._found.append(_Found(statement, path.parent, space, depth))
            name = getattr(statement, "name", None)
            if name is not None and not isinstance(statement, ast.Header):
                space.declared.add(name.text)
                if isinstance(statement, ast.Param):
                    params.add(name.text)
        return params

    def declare_all(self) -> None:
        """Declare what was read, each name in full."""
        settings = self._program.settings
        for setting, space in self._spaces.items():
            if setting in settings:
                value = resolved(settings[setting].value, space, self._report_unknown_member)
                settings[setting] = replace(settings[setting], value=value)
        overrides: list[PlacedOverride] = []
        depths: dict[str, int] = {}
        for found in self._found:
            statement = resolved(found.statement, found.space, self._report_unknown_member)
            if isinstance(statement, ast.Override):
                place = (found.folder, found.depth, found.space)
                overrides.append(PlacedOverride(statement, *place))
            elif isinstance(statement, ast.Header):
                if not found.space.prefix:
                    self._header(statement, found.depth == 0)
            elif name := getattr(statement, "name", None):
                self._declare(name, statement, found.folder)
                depths.setdefault(name.text, found.depth)
                self._check_alias(name, found.space)
            elif not found.space.prefix:  # under a name a file gives its declarations alone
                self._program.add_unnamed(statement, found.folder)
        apply_overrides(self._program, overrides, depths)

    def _report_unknown_member(self, member: ast.Member, inner: Namespace, alias: str) -> None:
        name = member.name.text
        if self._program.incomplete or inner.prefix + name in self._program.spoiled:
            self._program.spoiled.add(inner.prefix + name)
            return
        meant = nearest(name, sorted(inner.declared))
        self._program.spoiled.add(inner.prefix + name)
        self._report(
            Code.UNKNOWN_INCLUDED_NAME, member.name.span, name=name, alias=alias,
            help=f"did you mean `{alias}.{meant}`?" if meant else _list_of_names(inner),
            fixes=[Fix(member.name.span, meant)] if meant else [],
        )  # fmt: skip

    def override(self, name: str, value: str | Source, space: Namespace) -> None:
        """A value from outside: from the command line, or from a place in a file."""
        source = value if isinstance(value, Source) else Source(f"--set {name}", value)
        declared = self._program.declarations.get(name)
        if (declared is None and self._program.incomplete) or name in self._program.spoiled:
            return
        if declared is None or declared.role != "param":
            span = source.span(len(source.text) - len(source.text.lstrip()), len(source.text))
            help_ = self._about_settings(name)
            self._report(Code.UNKNOWN_PARAM, span, help=help_, name=name, where="this scene file")
            return
        parsed, found = parsed_setting(source, declared, space, self._report_unknown_member)
        self._program.diagnostics.extend(found)
        if parsed is not None and not any(diagnostic.is_error for diagnostic in found):
            self._program.settings[name] = Setting(name, parsed, parsed.span, True)

    def _about_settings(self, name: str) -> tuple[str, ...]:
        declared = self._program.declarations.get(name)
        if declared is not None and declared.role == "let":
            return (f"`{name}` is a `let`; declare it as `param` to set it from outside",)
        params = [found.name.text for found in self._program.in_role("param")]
        return did_you_mean(name, params) or _list_of_params(params)

    def _header(self, header: ast.Header, is_main: bool) -> None:
        headers = self._program.headers
        same = [found for found in headers if found.span.source is header.span.source]
        if same:
            self._report(
                Code.DUPLICATE_STATEMENT,
                header.span,
                labels=[Label(same[0].span, "the first one")],
                word="scenario",
            )
        elif is_main:
            headers.insert(0, header)
        else:
            headers.append(header)

    def _declare(self, name: ast.Word, statement: ast.Statement, folder: Path) -> None:
        known = self._program.declarations.get(name.text)
        if name.text in BUILT_IN:
            self._program.spoiled.add(name.text)
            self._report(Code.BUILT_IN_NAME, name.span, name=name.text)
        elif known is None:
            self._program.declarations[name.text] = Declaration(statement, folder, name=name)
        else:
            labels = [Label(known.name.span, "first declared here")]
            if name.span.text:  # else it is missing, which was reported
                self._report(Code.DUPLICATE_NAME, name.span, labels=labels, name=name.text)
            self._program.spoiled.add(name.text)

    def _check_alias(self, name: ast.Word, space: Namespace) -> None:
        """A name is not that of an included file as well."""
        alias = space.spans.get(name.text.removeprefix(space.prefix))
        if alias is not None:
            labels = [Label(alias, "an included file has this name")]
            self._report(Code.DUPLICATE_NAME, name.span, labels=labels, name=name.text)

    def _include(
        self, statement: ast.Include, folder: Path, chain: tuple[str, ...], space: Namespace
    ) -> set[str]:
        target = folder / statement.path.value
        real = os.path.realpath(target)
        span = statement.path.span
        if real in chain:
            names = [os.path.basename(file) for file in (*chain[chain.index(real) :], real)]
            self._report(Code.CIRCULAR_INCLUDE, span, cycle=" includes ".join(names))
            self._program.incomplete = True
            return set()
        inner = self._namespace(statement, real, space)
        if (real, inner.prefix) in self._included:
            labels = [Label(self._included[real, inner.prefix], "included here first")]
            file = statement.path.value
            self._report(Code.DUPLICATE_INCLUDE, span, labels=labels, file=file)
            return set()
        self._included[real, inner.prefix] = span
        if len(self._included) > MOST_INCLUDES:
            if len(self._included) == MOST_INCLUDES + 1:
                self._report(Code.TOO_MANY_INCLUDES, span, most=MOST_INCLUDES)
            self._program.incomplete = True
            return set()
        settings = self._settings(statement, inner, space)
        source = self._source(target, statement.path)
        if source is None:
            self._program.incomplete = True
            return set()
        params = self.read(source, target, chain, inner)
        for key in settings:
            full_name = inner.prefix + key.text
            unsure = self._program.incomplete or full_name in self._program.spoiled
            if key.text not in params and not unsure:
                help_ = did_you_mean(key.text, params) or _list_of_params(sorted(params))
                where = f"`{statement.path.value}`"
                self._report(Code.UNKNOWN_PARAM, key.span, help=help_, name=key.text, where=where)
                self._program.settings.pop(full_name, None)
        if statement.alias is None:
            return params
        return {f"{statement.alias.text}.{name}" for name in params}

    def _namespace(self, statement: ast.Include, real: str, space: Namespace) -> Namespace:
        """The names of the included file: the same as around it, or its own under its alias."""
        alias = statement.alias
        if alias is None:
            return space
        if alias.text in space.aliases:
            inner = space.aliases[alias.text]
            if (real, inner.prefix) not in self._included:
                labels = [Label(space.spans[alias.text], "first declared here")]
                self._report(Code.DUPLICATE_NAME, alias.span, labels=labels, name=alias.text)
            return inner
        if alias.text in BUILT_IN:
            self._report(Code.BUILT_IN_NAME, alias.span, name=alias.text)
        inner = Namespace(f"{space.prefix}{alias.text}.")
        space.aliases[alias.text] = inner
        space.spans[alias.text] = alias.span
        return inner

    def _source(self, target: Path, written: ast.String) -> Source | None:
        try:
            text = written_text(read_file(target, LARGEST_SCENE_FILE))
            return Source(str(target), text, included_at=written.span)
        except UnicodeDecodeError:
            reason = "it is not UTF-8 text"
        except UnreadableFile as error:
            if error.is_missing:
                self._program.diagnostics.append(
                    missing_file(target.parent, target.name, written.span, written.value)
                )
                return None
            reason = error.reason
        self._report(Code.UNREADABLE_INCLUDE, written.span, file=written.value, reason=reason)
        return None

    def _settings(
        self, statement: ast.Include, inner: Namespace, space: Namespace
    ) -> list[ast.Word]:
        if statement.block is None:
            return []
        for found in statement.block.passes:
            self._report(
                Code.MISPLACED_PASS, found.verb.span, what="`include`", verb=found.verb.text
            )
        keys: list[ast.Word] = []
        for option in statement.block.options:
            if any(key.text == option.key.text for key in keys):
                self._report(Code.DUPLICATE_OPTION, option.key.span, name=option.key.text)
                continue
            keys.append(option.key)
            # The including file is read first: what it sets wins over what its includes set.
            full_name = inner.prefix + option.key.text
            setting = Setting(full_name, option.value, option.value.span)
            self._program.settings.setdefault(full_name, setting)
            self._spaces.setdefault(full_name, space)
        return keys

    def _report(self, code: str, span: Span, **values: object) -> None:
        found: Diagnostic = diagnose(code, span, **values)  # type: ignore[arg-type]
        self._program.diagnostics.append(found)


def _list_of_names(space: Namespace) -> tuple[str, ...]:
    names = sorted(space.declared)
    if not names:
        return ("it declares no names",)
    return ("it declares " + ", ".join(f"`{name}`" for name in names[:20]),)


def _list_of_params(params: list[str]) -> tuple[str, ...]:
    if not params:
        return ("it has no `param` at all",)
    return ("its params are " + ", ".join(f"`{name}`" for name in params),)
