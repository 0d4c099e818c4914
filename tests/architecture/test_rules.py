"""The sources keep every rule of docs/architecture.md."""

from __future__ import annotations

import ast
import re

import pytest

from tests.architecture.rules import RULES, Rule
from tests.architecture.shipped_kinds import DEFAULT_KINDS, WORDS, shipped_kinds
from tests.architecture.source_tree import DIVIDED_PACKAGES, ROOT, source_tree

SOURCES = source_tree()


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_the_sources_keep(rule: Rule) -> None:
    assert not list(rule(SOURCES))


@pytest.mark.parametrize("group", WORDS)
def test_each_name_that_is_exempt_is_a_kind_and_in_the_core(group: str) -> None:
    strings = {
        node.value
        for file in SOURCES.core
        for node in file.nodes(ast.Constant)
        if isinstance(node.value, str)
    }
    assert set(WORDS[group].split()) <= shipped_kinds(SOURCES) & strings


def test_each_default_kind_is_named_where_it_is_allowed() -> None:
    for path, kinds in DEFAULT_KINDS.items():
        assert kinds <= shipped_kinds(SOURCES)
        assert all(f'"{kind}"' in SOURCES.files[path].text for kind in kinds)


def test_every_room_is_in_the_table() -> None:
    folders = {path.parent.name for path in (ROOT / "src" / "roadlang").glob("*/__init__.py")}
    assert folders == set(SOURCES.packages)


@pytest.mark.parametrize("package", DIVIDED_PACKAGES.values())
def test_every_subpackage_is_in_the_table(package: str) -> None:
    modules = {m.removeprefix(f"{package}.") for m in SOURCES.modules if f"{package}." in m}
    folders = {module.partition(".")[0] for module in modules if "." in module}
    assert folders <= set(SOURCES.subpackages[package]) <= {m.partition(".")[0] for m in modules}


@pytest.mark.parametrize("package", DIVIDED_PACKAGES.values())
def test_the_subpackages_have_no_circle(package: str) -> None:
    below: set[str] = set()
    for name, below_it in SOURCES.subpackages[package].items():
        assert below_it <= below, f"{name} imports {below_it - below}, which stand above it"
        below.add(name)


def test_the_table_has_no_circle() -> None:
    below: set[str] = set()
    for name, package in SOURCES.packages.items():
        assert package.packages <= below, (
            f"{name} imports {package.packages - below}, which stand above it"
        )
        below.add(name)


def test_what_the_page_says_is_somewhere_is_there() -> None:
    section = SOURCES.page.partition("## Where to find things")[2].partition("\n## ")[0]
    rows = [line.split("|")[2] for line in section.splitlines() if line.startswith("| ")][1:]
    paths = [path for row in rows for path in re.findall(r"`([^`]+)`", row)]
    assert len(paths) > len(rows) >= 20
    assert [path for path in paths if not (ROOT / path).exists()] == []
