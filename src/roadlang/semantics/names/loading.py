"""Reads a scene file and what it includes; names must be declared once in all of them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from ...diagnostics import Code, Diagnostic, Label, Source, Span, diagnose, did_you_mean
from ...syntax import parse, parse_formula
from ...syntax.tree import nodes as ast
from .file_checks import missing_file
from .program import Declaration, Program, Setting

BUILT_IN = frozenset({"abs", "min", "max", "fresh", "time", "inf"})


def load(path: Path, text: str, overrides: Mapping[str, str]) -> Program:
    """The program of a scene file; what is wrong with it is in its `diagnostics`."""
    source = Source(str(path), text)
    program = Program(path, source)
    loader = _Loader(program)
    loader.read(source, path, ())
    for name, value in overrides.items():
        loader.override(name, value)
    return program


class _Loader:
    def __init__(self, program: Program) -> None:
        self._program = program
        self._included: dict[str, Span] = {}

    def read(self, source: Source, path: Path, chain: tuple[str, ...]) -> set[str]:
        """Add the statements of one file; returns the params that it and its includes have."""
        tree, found = parse(source)
        self._program.diagnostics.extend(found)
        self._program.spoiled.update(word.text for word in tree.spoiled)
        self._program.inputs.append(source.path)
        chain = (*chain, os.path.realpath(path))
        params: set[str] = set()
        for statement in tree.statements:
            if isinstance(statement, ast.Include):
                params |= self._include(statement, path.parent, chain)
            elif isinstance(statement, ast.Header):
                self._header(statement, len(chain) == 1)
            elif name := getattr(statement, "name", None):
                self._declare(name, statement, path.parent)
                if isinstance(statement, ast.Param):
                    params.add(name.text)
            else:
                self._program.add_unnamed(statement, path.parent)
        return params

    def override(self, name: str, text: str) -> None:
        """A value from the command line."""
        source = Source(f"--set {name}", text)
        declared = self._program.declarations.get(name)
        if (declared is None and self._program.incomplete) or name in self._program.spoiled:
            return
        if declared is None or declared.role != "param":
            span = source.span(0, len(text))
            help_ = self._about_settings(name)
            self._report(Code.UNKNOWN_PARAM, span, help=help_, name=name, where="this scene file")
            return
        value, found = parse_formula(source)
        self._program.diagnostics.extend(found)
        if value is not None and not any(diagnostic.is_error for diagnostic in found):
            self._program.settings[name] = Setting(name, value, value.span, True)

    def _about_settings(self, name: str) -> tuple[str, ...]:
        declared = self._program.declarations.get(name)
        if declared is not None and declared.role == "let":
            return (f"`{name}` is a `let`; declare it as `param` to set it from outside",)
        params = [found.name.text for found in self._program.in_role("param")]
        return did_you_mean(name, params) or _list_of_params(params)

    def _header(self, header: ast.Header, is_main: bool) -> None:
        headers = self._program.headers
        same = [found for found in headers if found.span.source == header.span.source]
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
        elif known is not None:
            labels = [Label(known.name.span, "first declared here")]
            self._report(Code.DUPLICATE_NAME, name.span, labels=labels, name=name.text)
            self._program.spoiled.add(name.text)
        else:
            found = Declaration(statement, folder, name=name)
            self._program.declarations[name.text] = found

    def _include(self, statement: ast.Include, folder: Path, chain: tuple[str, ...]) -> set[str]:
        target = folder / statement.path.value
        real = os.path.realpath(target)
        span = statement.path.span
        if real in chain:
            names = [os.path.basename(file) for file in (*chain[chain.index(real) :], real)]
            self._report(Code.CIRCULAR_INCLUDE, span, cycle=" includes ".join(names))
            self._program.incomplete = True
            return set()
        if real in self._included:
            labels = [Label(self._included[real], "included here first")]
            self._report(Code.DUPLICATE_INCLUDE, span, labels=labels, file=statement.path.value)
            return set()
        self._included[real] = span
        text = self._text(target, statement.path)
        settings = self._settings(statement)
        if text is None:
            self._program.incomplete = True
            return set()
        params = self.read(Source(str(target), text), target, chain)
        for key in settings:
            unsure = self._program.incomplete or key.text in self._program.spoiled
            if key.text not in params and not unsure:
                self._report(
                    Code.UNKNOWN_PARAM,
                    key.span,
                    help=did_you_mean(key.text, params) or _list_of_params(sorted(params)),
                    name=key.text,
                    where=f"`{statement.path.value}`",
                )
                self._program.settings.pop(key.text, None)
        return params

    def _text(self, target: Path, written: ast.String) -> str | None:
        try:
            return target.read_bytes().decode("utf-8-sig")
        except UnicodeDecodeError:
            self._report(
                Code.UNREADABLE_INCLUDE,
                written.span,
                file=written.value,
                reason="it is not UTF-8 text",
            )
        except OSError as error:
            if isinstance(error, FileNotFoundError):
                self._program.diagnostics.append(
                    missing_file(target.parent, target.name, written.span, written.value)
                )
            else:
                reason = error.strerror or type(error).__name__
                self._report(
                    Code.UNREADABLE_INCLUDE, written.span, file=written.value, reason=reason
                )
        except ValueError as error:
            self._report(
                Code.UNREADABLE_INCLUDE, written.span, file=written.value, reason=str(error)
            )
        return None

    def _settings(self, statement: ast.Include) -> list[ast.Word]:
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
            setting = Setting(option.key.text, option.value, option.value.span)
            self._program.settings.setdefault(option.key.text, setting)
        return keys

    def _report(self, code: str, span: Span, **values: object) -> None:
        found: Diagnostic = diagnose(code, span, **values)  # type: ignore[arg-type]
        self._program.diagnostics.append(found)


def _list_of_params(params: list[str]) -> tuple[str, ...]:
    if not params:
        return ("it has no `param` at all",)
    return ("its params are " + ", ".join(f"`{name}`" for name in params),)
