"""Imports run one way, as docs/architecture.md says; kinds use the public API alone."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src" / "roadlang"
STANDARD = ROOT / "plugins" / "standard" / "roadlang_standard"


def rooms_of_the_page() -> dict[str, set[str]]:
    """Room: the rooms it may import, as the table in docs/architecture.md has it."""
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    table = {}
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 3 and re.fullmatch(r"`\w+/`", cells[0]):
            table[cells[0].strip("`/")] = set(re.findall(r"`(\w+)`", cells[2]))
    return table


ROOMS = rooms_of_the_page()


def modules(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.py"))


def imported(path: Path) -> Iterator[str]:
    """Absolute names of the modules that a file imports, those for type checking too."""
    package = ("roadlang", *path.relative_to(SOURCE).parent.parts) if SOURCE in path.parents else ()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else ()
            stem = ".".join([*base, *filter(None, [node.module])])
            yield stem
            yield from (f"{stem}.{alias.name}" for alias in node.names)


def test_every_room_is_in_the_table():
    folders = {path.name for path in SOURCE.iterdir() if (path / "__init__.py").exists()}
    assert folders == set(ROOMS)


def test_the_table_has_no_cycle():
    below: set[str] = set()
    for room, allowed in ROOMS.items():
        assert allowed <= below, f"{room} imports {allowed - below}, which stand above it"
        below.add(room)


@pytest.mark.parametrize("room", [room for room in ROOMS if room != "cli"])
def test_a_room_imports_only_what_the_table_allows(room):
    allowed = ROOMS[room] | {room}
    for path in modules(SOURCE / room):
        for name in imported(path):
            parts = name.split(".")
            if parts[0] == "roadlang" and len(parts) > 1 and parts[1] in ROOMS:
                assert parts[1] in allowed, f"{path.relative_to(ROOT)} imports {name}"


def test_pluggy_lives_in_the_plugins_room_alone():
    for path in modules(SOURCE):
        if "plugins" not in path.relative_to(SOURCE).parts:
            assert not any(name.split(".")[0] == "pluggy" for name in imported(path)), path


def test_standard_kinds_import_the_public_api_and_the_geometry_that_it_exports():
    for path in modules(STANDARD):
        for name in imported(path):
            if name.split(".")[0] == "roadlang" and name != "roadlang":
                where = path.relative_to(ROOT)
                public = name.startswith(("roadlang.api", "roadlang.geometry"))
                assert public, f"{where} imports {name}"


def test_every_module_says_what_it_is_for():
    for path in (*modules(SOURCE), *modules(STANDARD)):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        assert ast.get_docstring(tree), f"{path.relative_to(ROOT)} has no docstring"


def test_files_and_functions_are_small():
    for path in (*modules(SOURCE), *modules(STANDARD)):
        text = path.read_text(encoding="utf-8")
        where = path.relative_to(ROOT)
        assert text.count("\n") <= 400, f"{where} has {text.count(chr(10))} lines"
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                lines = (node.end_lineno or 0) - node.lineno + 1
                assert lines <= 60, f"{where}: {node.name} has {lines} lines"
