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


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("road b from zq", "this scene declares `main`"),
        ("agent e is car on zq at size", "this scene declares `main`"),
        ("agent e is car on main at ahead_of(f, 2m)\nagent f is car on zq at 5m", "`main`"),
    ],
)
def test_a_road_that_is_none_is_one_error_that_lists_the_roads(text: str, said: str) -> None:
    more = "road main { draw with waypoints { points: [(0m, 0m), (90m, 0m)] } }\n"
    whole = f"param size = 3m\n{more}{text}\n"
    _, (found,) = check_text(whole, Path("scene.rl"), {}, load_registry())
    assert found.code == "RL101"
    assert said in found.help[0]
    assert "size" not in found.help[0]
