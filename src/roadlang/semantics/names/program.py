"""A scene file with all that it includes, as declarations by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ...diagnostics import Diagnostic, Source, Span
from ...syntax.tree import nodes as ast


@dataclass(frozen=True, slots=True)
class PlacedStatement:
    """A statement and where it stands."""

    statement: ast.Statement
    folder: Path
    """of the file that it stands in: paths are relative to it"""
    number: int = 1
    """counted among the statements without a name that have the same word"""

    @property
    def role(self) -> str:
        """The statement word."""
        return self.statement.keyword


@dataclass(frozen=True, slots=True)
class Declaration(PlacedStatement):
    """A statement that declares a name."""

    name: ast.Word = field(kw_only=True)
    override_folders: Mapping[str, Path] = field(default_factory=dict, kw_only=True)
    """of the files that override some of it, by the paths of these files"""

    def folder_at(self, span: Span) -> Path:
        """What a path that is written at a place of the statement is relative to."""
        return self.override_folders.get(span.source.path, self.folder)


@dataclass(frozen=True, slots=True)
class Setting:
    """A value that replaces that of a `param`: from an `include` block or from `--set`."""

    name: str
    value: ast.Expression
    span: Span
    from_command_line: bool = False


@dataclass
class Program:
    """Everything that was read. `spoiled`: names of which it is not known what they are, since
    their statement could not be read or there are two of them."""

    path: Path
    source: Source
    headers: list[ast.Header] = field(default_factory=list)
    declarations: dict[str, Declaration] = field(default_factory=dict)
    unnamed: list[PlacedStatement] = field(default_factory=list)
    settings: dict[str, Setting] = field(default_factory=dict)
    spoiled: set[str] = field(default_factory=set)
    inputs: list[str] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    incomplete: bool = False
    """An included file could not be read: nobody knows what it declares."""

    def add_unnamed(self, statement: ast.Statement, folder: Path) -> None:
        """Add a statement that declares no name (`emit`, `world`, ...)."""
        same = [found for found in self.unnamed if found.role == statement.keyword]
        self.unnamed.append(PlacedStatement(statement, folder, len(same) + 1))

    def in_role(self, *roles: str) -> list[Declaration]:
        """The declarations with one of these statement words, in order."""
        return [found for found in self.declarations.values() if found.role in roles]


def expression_of(program: Program, name: str) -> ast.Expression:
    """What a `param` or `let` is set to, here or from outside."""
    setting = program.settings.get(name)
    if setting is not None:
        return setting.value
    statement = program.declarations[name].statement
    assert isinstance(statement, ast.Param | ast.Let)
    return statement.value
