"""The rules of docs/architecture.md: each gives the places of a `SourceTree` that break it."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cache

from tests.architecture.shipped_kinds import DEFAULT_KINDS, WORDS, shipped_kinds
from tests.architecture.source_tree import SourceFile, SourceTree, dotted

Rule = Callable[[SourceTree], Iterator[str]]
MOST_LINES, MOST_FUNCTION_LINES = 300, 45
PUBLIC = ("roadlang.api", "roadlang.commands", "roadlang.geometry")
"""What plugins may import beside `roadlang` itself: `api`, `geometry`, which it exports, and what
commands need."""
JUNCTIONS = "geometry/junctions/"
BESIDE_THE_ROOMS = {"roadlang.testing": frozenset({"numpy", "pytest"})}
"""Third parties of the files that are in no package"""
COMPUTED_IMPORTS = (
    "src/roadlang/cli/commands.py",
    "src/roadlang/cli/chosen_extractor.py",
    "src/roadlang/geometry/__init__.py",
    "src/roadlang/plugins/registry.py",
    "src/roadlang/stl/__init__.py",
)
"""Files that import by a computed name: lazy exports of a package, and kinds by their target."""


@dataclass(frozen=True)
class Facade:
    """Files with methods that import their implementation, which stands on the file, when called.
    `circle`: where all files of that circle are; there are at most `most`."""

    files: tuple[str, ...]
    circle: str
    most: int


FACADES = {
    "formulas, which evaluate themselves": Facade(
        ("src/roadlang/stl/formula/evaluable.py",), r"roadlang\.stl\..*", 26
    ),
    "networks, which know their longest road": Facade(
        ("src/roadlang/geometry/networks/network.py",),
        r"roadlang\.geometry\.networks\.(network|paths)",
        2,
    ),
    "the front door": Facade(
        (
            "src/roadlang/session/falsification.py",
            "src/roadlang/session/loading.py",
            "src/roadlang/session/scene.py",
        ),
        r"roadlang\.session\..*",
        10,
    ),
}
"""The circles that are allowed. Each of their files says so in its docstring; there are at most
three."""
CLOCK = "src/roadlang/falsification/deadline.py"
"""The one file that looks at the clock: for a stop rule that says so."""
WITHOUT_FILES = (
    "src/roadlang/geometry/",
    "src/roadlang/stl/formula/",
    "src/roadlang/stl/evaluate/",
    "src/roadlang/evaluate/",
)
_FILE_MODULES = frozenset({"io", "os", "pathlib", "shutil", "socket", "subprocess", "tempfile"})
_FILE_CALLS = re.compile(
    r"(.*\.)?(open|fromfile|tofile|read_text|read_bytes|write_text|write_bytes)"
    r"|(np|numpy)\.(load|loadtxt|genfromtxt|save|savez|savetxt|memmap)"
)
_UNREPEATABLE = re.compile(
    r"(np|numpy)\.random\.(?!Generator|BitGenerator|Philox|PCG64|SeedSequence)\w+"
    r"|os\.urandom"
)
_UNREPEATABLE_MODULES = frozenset({"datetime", "random", "secrets", "time", "uuid"})


def packages_import_downward(sources: SourceTree) -> Iterator[str]:
    """A package imports what the table allows, also inside functions and by `import_module`."""
    for file in sources.core:
        if file.top_package is None:
            continue
        allowed = sources.packages[file.top_package].packages | {file.top_package}
        for found in file.imports:
            parts = found.module.split(".") if found.module else []
            parts += [found.name] if parts == ["roadlang"] else []
            is_package = (
                parts[:1] == ["roadlang"] and len(parts) > 1 and parts[1] in sources.packages
            )
            if is_package and parts[1] not in allowed:
                yield _at(file, found.line, f"`{file.top_package}` imports {found.module}")
            if not found.literal and file.path not in COMPUTED_IMPORTS:
                yield _at(file, found.line, "imports a module whose name is computed")


def subpackages_import_downward(sources: SourceTree) -> Iterator[str]:
    """A subpackage imports what its row of the page allows, also inside functions."""
    for package, parts in sources.subpackages.items():
        for file in sources.files.values():
            part = _part_of(package, file.module)
            if part not in parts:
                continue
            for found in file.imports:
                target = _part_of(package, sources.target(found) or "")
                if target and target not in parts[part] | {part}:
                    yield _at(file, found.line, f"`{part}` imports {found.module}")


def the_core_imports_no_kind_and_no_api(sources: SourceTree) -> Iterator[str]:
    """`api`, `commands` and `testing` stand above all packages, plugins outside."""
    plugins = {file.package.split(".")[0] for file in sources.plugins}
    outside = {"roadlang.api", "roadlang.commands", "roadlang.testing"}
    for file in sources.core:
        if file.module in outside:
            continue
        for found in file.imports:
            names = {found.module, f"{found.module}.{found.name}"}
            if names & outside or found.module.split(".")[0] in plugins:
                yield _at(file, found.line, f"imports {found.module} {found.name}".strip())


def third_parties_are_those_of_the_table(sources: SourceTree) -> Iterator[str]:
    """Each package imports the distributions that its row names, and the standard library."""
    for file in sources.core:
        beside = BESIDE_THE_ROOMS.get(file.module, frozenset())
        allowed = sources.packages[file.top_package].third_parties if file.top_package else beside
        for found in file.imports:
            top = found.module.split(".")[0]
            if top and top != "roadlang" and top not in sys.stdlib_module_names | allowed:
                yield _at(file, found.line, f"imports {top}")


def polygons_are_joined_in_one_package(sources: SourceTree) -> Iterator[str]:
    """shapely is imported by `geometry/junctions` alone, when a plan is made."""
    for file in sources.files.values():
        for found in file.imports:
            if found.module.split(".")[0] != "shapely":
                continue
            if not file.path.startswith(f"src/roadlang/{JUNCTIONS}"):
                yield _at(file, found.line, f"imports {found.module}")
            elif not found.late:
                yield _at(file, found.line, f"imports {found.module} before it is needed")


def private_names_stay_in_their_file(sources: SourceTree) -> Iterator[str]:
    """A name with a leading underscore is used by the module that defines it alone: also a member
    of a class, such as what it remembers."""
    for file in sources.files.values():
        for found in file.imports:
            last = found.name or found.module
            if sources.target(found) is not None and re.search(r"(^|\.)_[a-zA-Z]", last):
                yield _at(file, found.line, f"imports the private {last}")
        own = {"_exit", *_names_defined(file)}  # `os._exit` is public
        for node in file.nodes(ast.Attribute):
            if not re.match(r"_[a-zA-Z]", node.attr):
                continue
            if node.attr not in own and dotted(node.value) not in ("self", "cls"):
                yield _at(file, node.lineno, f"uses the private {dotted(node) or node.attr}")


def no_circles(sources: SourceTree) -> Iterator[str]:
    """No file imports another that imports it, over any number of steps, at any time. What a
    facade imports when it is called makes one circle in its package, of the files listed here."""
    facades = {path for facade in FACADES.values() for path in facade.files}
    whole, without_facades = _imported(sources, frozenset()), _imported(sources, facades)
    for circle in _circles(without_facades):
        yield f"{len(circle)} files in a circle: {', '.join(sorted(circle))}"
    allowed = dict(FACADES)
    for circle in _circles(whole):
        names = [n for n, f in allowed.items() if all(re.fullmatch(f.circle, m) for m in circle)]
        if not names or len(circle) > allowed.pop(names[0]).most:
            yield f"{len(circle)} files in a circle with a facade: {', '.join(sorted(circle))}"


def facades_are_few_and_explained(sources: SourceTree) -> Iterator[str]:
    """A facade says in its docstring what it is."""
    if len(FACADES) > 3:
        yield f"{len(FACADES)} facades"
    for path in (path for facade in FACADES.values() for path in facade.files):
        if "facade" not in (ast.get_docstring(sources.files[path].tree) or ""):
            yield f"{path} does not say that it is a facade"


def no_clock_and_no_global_random_numbers(sources: SourceTree) -> Iterator[str]:
    """A pass is a pure function: not in the packages (except `cli`), nor in the kinds that ship
    except those of Godot, an engine that answers in its own time."""
    shipped = [f for f in sources.plugins if "roadlang_godot" not in f.path]
    core = (f for f in sources.core if f.top_package != "cli" and f.path != CLOCK)
    for file in (*core, *shipped):
        for found in file.imports:
            if found.module.split(".")[0] in _UNREPEATABLE_MODULES:
                yield _at(file, found.line, f"imports {found.module}")
        for node in file.nodes(ast.Call):
            name = dotted(node.func)
            is_seeded = name.endswith("random.default_rng") and bool(node.args or node.keywords)
            if _UNREPEATABLE.fullmatch(name) and not is_seeded:
                yield _at(file, node.lineno, f"calls {name}")


def shipped_kinds_use_the_public_api(sources: SourceTree) -> Iterator[str]:
    """The plugins in the wheel are written as a stranger's are."""
    for file in sources.plugins:
        for found in file.imports:
            name = found.module
            public = name.startswith(PUBLIC) or (name == "roadlang" and found.name != "_")
            if name.split(".")[0] == "roadlang" and not public:
                yield _at(file, found.line, f"imports {name}")


def packages_that_compute_read_no_files(sources: SourceTree) -> Iterator[str]:
    """Geometry, formulas and values are functions of their arguments."""
    for file in sources.core:
        if not file.path.startswith(WITHOUT_FILES):
            continue
        for found in file.imports:
            if found.module.split(".")[0] in _FILE_MODULES:
                yield _at(file, found.line, f"imports {found.module}")
        for node in file.nodes(ast.Call):
            if _FILE_CALLS.fullmatch(_called(node)):
                yield _at(file, node.lineno, f"calls {_called(node)}")


def the_core_names_no_shipped_kind(sources: SourceTree) -> Iterator[str]:
    """What the core has to know of a kind, the kind says itself."""
    kinds = shipped_kinds(sources) - {word for words in WORDS.values() for word in words.split()}
    for file in sources.core:
        prose = _docstrings(file)
        for node in file.nodes(ast.Constant):
            if not isinstance(node.value, str):
                continue
            allowed = node in prose or node.value in DEFAULT_KINDS.get(file.path, ())
            if not allowed and (node.value in kinds or _QUALIFIED.match(node.value)):
                yield _at(file, node.lineno, f'names the kind "{node.value}"')


def files_and_functions_are_small(sources: SourceTree) -> Iterator[str]:
    """Tables, which are read by looking up, may be longer."""
    for file in sources.files.values():
        count = file.text.count("\n")
        if count > MOST_LINES and file.path not in TABLES:
            yield f"{file.path} has {count} lines"
        for node in file.functions:
            lines = (node.end_lineno or 0) - node.lineno + 1
            if lines > MOST_FUNCTION_LINES:
                yield _at(file, node.lineno, f"{node.name} has {lines} lines")


def every_file_says_what_it_is_for(sources: SourceTree) -> Iterator[str]:
    """The first line of its docstring."""
    for file in sources.files.values():
        if not ast.get_docstring(file.tree):
            yield f"{file.path} has no docstring"


TABLES = ("src/roadlang/syntax/tree/nodes.py",)
RULES: tuple[Rule, ...] = (
    packages_import_downward,
    subpackages_import_downward,
    the_core_imports_no_kind_and_no_api,
    third_parties_are_those_of_the_table,
    polygons_are_joined_in_one_package,
    private_names_stay_in_their_file,
    no_circles,
    facades_are_few_and_explained,
    no_clock_and_no_global_random_numbers,
    shipped_kinds_use_the_public_api,
    packages_that_compute_read_no_files,
    the_core_names_no_shipped_kind,
    files_and_functions_are_small,
    every_file_says_what_it_is_for,
)
_QUALIFIED = re.compile(r"(standard|godot)\.")


def _at(file: SourceFile, line: int, fault: str) -> str:
    return f"{file.path}:{line}: {fault}"


def _part_of(package: str, module: str) -> str:
    """The folder or file of a package that a module is in; "" of one elsewhere."""
    return module.partition(f"{package}.")[2].partition(".")[0]


def _called(node: ast.Call) -> str:
    func = node.func
    if isinstance(func, ast.Attribute):
        return dotted(func) or f"_.{func.attr}"
    return dotted(func)


def _names_defined(file: SourceFile) -> Iterator[str]:
    """Functions, classes, variables and members that a file defines."""
    yield from (function.name for function in file.functions)
    yield from (node.name for node in file.nodes(ast.ClassDef))
    yield from (n.attr for n in file.nodes(ast.Attribute) if isinstance(n.ctx, ast.Store))
    yield from (n.id for n in file.nodes(ast.Name) if isinstance(n.ctx, ast.Store))


def _docstrings(file: SourceFile) -> set[ast.AST]:
    """Strings that are statements of their own."""
    return {n.value for n in file.nodes(ast.Expr) if isinstance(n.value, ast.Constant)}


def _imported(sources: SourceTree, not_late: Collection[str]) -> dict[str, set[str]]:
    """The modules that each module imports, in functions too but those of the files `not_late`."""
    graph: dict[str, set[str]] = {}
    for file in sources.files.values():
        edges = graph.setdefault(file.module, set())
        for found in file.imports:
            target = sources.target(found)
            is_left_out = found.late and file.path in not_late
            if target is not None and target != file.module and not is_left_out:
                edges.add(target)
    return graph


def _circles(graph: Mapping[str, set[str]]) -> list[set[str]]:
    """Strongly connected components of more than one module (by reachability)."""

    @cache
    def reachable(start: str) -> frozenset[str]:
        seen, pending = set(), [start]
        while pending:
            for target in graph.get(pending.pop(), ()):
                if target not in seen:
                    seen.add(target)
                    pending.append(target)
        return frozenset(seen)

    circles: list[set[str]] = []
    done: set[str] = set()
    for module in graph:
        if module not in done and module in reachable(module):
            circle = {other for other in reachable(module) if module in reachable(other)}
            done |= circle
            circles.append(circle)
    return circles
