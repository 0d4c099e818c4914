"""The house as it stands keeps every rule of docs/architecture.md."""

from __future__ import annotations

import re

import pytest

from tests.architecture.house import ROOT, House
from tests.architecture.rules import RULES, Rule

HOUSE = House.read()


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_the_house_keeps(rule: Rule) -> None:
    assert not list(rule(HOUSE))


def test_every_room_is_in_the_table() -> None:
    folders = {path.parent.name for path in (ROOT / "src" / "roadlang").glob("*/__init__.py")}
    assert folders == set(HOUSE.rooms)


def test_the_table_has_no_circle() -> None:
    below: set[str] = set()
    for name, room in HOUSE.rooms.items():
        assert room.rooms <= below, f"{name} imports {room.rooms - below}, which stand above it"
        below.add(name)


def test_what_the_page_says_is_somewhere_is_there() -> None:
    section = HOUSE.page.partition("## Where to find what")[2].partition("\n## ")[0]
    rows = [line.split("|")[2] for line in section.splitlines() if line.startswith("| ")][1:]
    paths = [path for row in rows for path in re.findall(r"`([^`]+)`", row)]
    assert len(paths) > len(rows) >= 20
    assert [path for path in paths if not (ROOT / path).exists()] == []
