"""Many names that are not declared take time in proportion to them."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text
from roadlang.semantics.names.program import Declaration


def test_declarations_are_looked_through_once_for_all_unknown_names(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    looks = []

    def role(one: Declaration) -> str:
        looks.append(one.number)
        return one.statement.keyword

    monkeypatch.setattr(Declaration, "role", property(role))
    road = "road r { draw with waypoints { points: [(0m, 0m), (90m, 20m)] } }\n"
    names = "".join(f"let velocity{i} = {i}m\n" for i in range(100))
    wrong = "".join(f"require q{i}: veloicty{i} < 3m\n" for i in range(100))
    _, found = check_text(road + names + wrong, Path("scene.rl"), {}, load_registry())
    assert [one.code for one in found].count("RL101") == 100
    assert len(looks) < 20 * 201
