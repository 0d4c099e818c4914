"""The source tree as data: its files, the table of packages, and what each file imports."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path
from typing import TypeVar, cast

N = TypeVar("N", bound=ast.AST)
ROOT = Path(__file__).parents[2]
CORE = "src/roadlang"
SHIPPED_PLUGINS = (
    "plugins/standard/roadlang_standard",
    "plugins/godot/roadlang_godot",
    "plugins/formats/roadlang_formats",
)
DIVIDED_PACKAGES = {
    "geometry": "roadlang.geometry",
    "world": "roadlang.world",
    "extraction": "roadlang_standard.extraction",
}
"""The packages whose subpackages the page lists, as it names them."""
PAGE = "docs/architecture.md"


@dataclass(frozen=True)
class Import:
    """`module`: absolute; `name`: what is taken of it, or "".

    `late`: inside a function or for type checking. `literal`: False where the name is computed.
    """

    module: str
    name: str
    line: int
    late: bool
    literal: bool = True


@dataclass(frozen=True)
class SourceFile:
    """`path` from the root of the repository, with slashes."""

    path: str
    text: str

    @property
    def tree(self) -> ast.Module:
        return _parsed(self.text)

    def nodes(self, kind: type[N]) -> list[N]:
        """The nodes of the tree that are of this type itself, not of a subclass."""
        return cast("list[N]", _nodes(self.text).get(kind, []))

    @property
    def functions(self) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
        """Also methods, and functions in functions."""
        yield from self.nodes(ast.FunctionDef)
        yield from self.nodes(ast.AsyncFunctionDef)

    @property
    def module(self) -> str:
        """`roadlang.world.roads.roads`; of a package the package itself."""
        parts = self.path.removesuffix(".py").split("/")
        start = next(i for i, part in enumerate(parts) if part.startswith("roadlang"))
        parts = parts[start:]
        return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)

    @property
    def package(self) -> str:
        is_package = self.path.endswith("__init__.py")
        return self.module if is_package else self.module.rpartition(".")[0]

    @property
    def top_package(self) -> str | None:
        """The folder below `src/roadlang`; None of the files beside the packages and of plugins."""
        parts = self.path.split("/")
        return parts[2] if self.path.startswith(f"{CORE}/") and len(parts) > 3 else None

    @property
    def imports(self) -> tuple[Import, ...]:
        return _imports(self.text, self.package)


@dataclass(frozen=True)
class SourceTree:
    """All Python files of the core and of the plugins in the wheel, and the page of packages."""

    files: Mapping[str, SourceFile]
    page: str

    @classmethod
    def read(cls, root: Path = ROOT) -> SourceTree:
        """The sources on disk."""
        paths = [p for folder in (CORE, *SHIPPED_PLUGINS) for p in (root / folder).rglob("*.py")]
        files = {}
        for path in sorted(paths):
            name = path.relative_to(root).as_posix()
            files[name] = SourceFile(name, path.read_text(encoding="utf-8"))
        return cls(files, (root / PAGE).read_text(encoding="utf-8"))

    def with_lines(self, path: str, lines: str) -> SourceTree:
        """A copy in which `lines` are added to a file, or are a new one."""
        before = self.files[path].text if path in self.files else '"""New."""\n'
        return self.with_text(path, f"{before}\n{lines}\n")

    def with_text(self, path: str, text: str) -> SourceTree:
        """A copy in which a file has another text."""
        return replace(self, files={**self.files, path: SourceFile(path, text)})

    @cached_property
    def core(self) -> tuple[SourceFile, ...]:
        return tuple(file for file in self.files.values() if file.path.startswith(f"{CORE}/"))

    @cached_property
    def plugins(self) -> tuple[SourceFile, ...]:
        """The files of the plugins that ship in the wheel."""
        return tuple(file for file in self.files.values() if file.path.startswith("plugins/"))

    @cached_property
    def packages(self) -> dict[str, Package]:
        """The table of the page, from the bottom to the top."""
        table: dict[str, Package] = {}
        for line in self.page.splitlines():
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if len(cells) == 4 and re.fullmatch(r"`\w+/`", cells[0]):
                name = cells[0].strip("`/")
                packages = frozenset(table) if cells[2] == "all" else _words(cells[2])
                table[name] = Package(packages, _words(cells[3]))
        return table

    @cached_property
    def subpackages(self) -> dict[str, dict[str, frozenset[str]]]:
        """By package, what each part may import of the others, from the bottom to the top."""
        row = re.compile(r"\| `(\w+)/(\w+)` \|[^|\n]*\|([^|\n]*)\|")
        parts: dict[str, dict[str, frozenset[str]]] = {}
        for folder, name, cell in row.findall(self.page):
            parts.setdefault(DIVIDED_PACKAGES[folder], {})[name] = _words(cell)
        return parts

    @cached_property
    def modules(self) -> frozenset[str]:
        return frozenset(file.module for file in self.files.values())

    def target(self, found: Import) -> str | None:
        """The module of ours that an import loads."""
        for name in (f"{found.module}.{found.name}", found.module):
            if name in self.modules:
                return name
        return None


@dataclass(frozen=True)
class Package:
    """What a package may import: other packages, and distributions of third parties."""

    packages: frozenset[str]
    third_parties: frozenset[str]


def _words(cell: str) -> frozenset[str]:
    return frozenset(re.findall(r"`(\w+)`", cell))


@cache
def _parsed(text: str) -> ast.Module:
    return ast.parse(text)


@cache
def _nodes(text: str) -> dict[type[ast.AST], list[ast.AST]]:
    """Every node, by its type: a tree is walked once and not once for each rule."""
    found: dict[type[ast.AST], list[ast.AST]] = {}
    for node in ast.walk(_parsed(text)):
        found.setdefault(type(node), []).append(node)
    return found


@cache
def _imports(text: str, package: str) -> tuple[Import, ...]:
    return tuple(_imports_below(_parsed(text), package, late=False))


@cache
def source_tree() -> SourceTree:
    """The sources, read once in each process."""
    return SourceTree.read()


def forget_trees() -> None:
    """Drop what was parsed."""
    for remembered in (_parsed, _nodes, _imports):
        remembered.cache_clear()


def _imports_below(node: ast.AST, package: str, *, late: bool) -> Iterator[Import]:
    for child in ast.iter_child_nodes(node):
        inside = late or _is_late(child)
        if isinstance(child, ast.Import):
            for alias in child.names:
                yield Import(alias.name, "", child.lineno, late)
        elif isinstance(child, ast.ImportFrom):
            stem = _absolute("." * child.level + (child.module or ""), package)
            for alias in child.names:
                yield Import(stem, alias.name, child.lineno, late)
        elif isinstance(child, ast.Call) and _name_of(child.func) in (
            "import_module",
            "__import__",
        ):
            yield _dynamic(child, package, late)
        yield from _imports_below(child, package, late=inside)


def _is_late(node: ast.AST) -> bool:
    if isinstance(node, ast.If):
        return dotted(node.test) == "TYPE_CHECKING"
    return isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)


def _dynamic(call: ast.Call, package: str, late: bool) -> Import:
    """`import_module("..world", __package__)`, or one whose module is not written out."""
    argument = call.args[0] if call.args else None
    if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
        return Import(_absolute(argument.value, package), "", call.lineno, late)
    return Import("", "", call.lineno, late, literal=False)


def _absolute(name: str, package: str) -> str:
    dots = len(name) - len(name.lstrip("."))
    if not dots:
        return name
    base = package.split(".")
    return ".".join([*base[: len(base) - dots + 1], *filter(None, [name[dots:]])])


def _name_of(node: ast.expr) -> str:
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else ""


def dotted(node: ast.expr) -> str:
    """`np.random.rand` of such an expression, "" of any other."""
    if isinstance(node, ast.Attribute):
        stem = dotted(node.value)
        return f"{stem}.{node.attr}" if stem else ""
    return node.id if isinstance(node, ast.Name) else ""
