"""Chains of names: short ones are compiled, long ones get one diagnostic, none ends in a crash."""

from __future__ import annotations

from pathlib import Path

import pytest

import roadlang
from roadlang.diagnostics import Code, Diagnostic
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }\n"
CHAINS = {
    "numbers": ("param a0 = 0m..1m\n", "let a{i} = a{j} + 1mm\n",
                "require r: always (abs(curvature(main)) * a{j} < 9999)\n"),
    "formulas": ("let a0 = abs(curvature(main)) < 1/m\n", "let a{i} = a{j} and width(main) > 1m\n",
                 "require r: always (a{j})\n"),
    "signals": ("let a0 = curvature(main)\n", "let a{i} = a{j} + 0.0001/m\n",
                "require r: always (a{j} < 9999/m)\n"),
    "negations": ("let a0 = always (abs(curvature(main)) < 1/m)\n", "let a{i} = not a{j}\n",
                  "require r: a{j} or true\n"),
    "lists": ("let a0 = [1m, 2m]\n", "let a{i} = [a{j}, 1m]\n", ""),
    "conditions": ("let a0 = once (ego.speed > 1m/s)\n", "let a{i} = historically (a{j})\n",
                   "agent ego is car on main at 1m {{ drive with brake {{ when: a{j} }} }}\n"),
}  # fmt: skip


def chain(name: str, length: int) -> str:
    """A file with a `let` that names another, which names another, and so on."""
    first, following, use = CHAINS[name]
    links = "".join(following.format(i=i, j=i - 1) for i in range(1, length))
    return ROAD + first + links + use.format(j=length - 1)


def errors_of(text: str) -> list[Diagnostic]:
    found = check_text(text, Path("scene.rl"), {}, load_registry())[1]
    return [diagnostic for diagnostic in found if diagnostic.is_error]


@pytest.mark.parametrize("name", CHAINS)
def test_a_chain_of_sixty_names_is_compiled(name: str) -> None:
    scene = roadlang.loads(chain(name, 60)).sample()[0]
    assert scene.to_json()


@pytest.mark.parametrize(
    ("name", "length"), [*((name, 300) for name in CHAINS), ("formulas", 3000), ("lists", 3000)]
)
def test_a_long_chain_gets_one_diagnostic_at_a_name(name: str, length: int) -> None:
    (error,) = errors_of(chain(name, length))
    assert error.code == Code.NESTING_TOO_DEEP
    assert error.span is not None
    assert error.span.text.startswith("a")


def test_constants_are_computed_at_once_however_long_their_chain() -> None:
    links = "".join(f"let a{i} = a{i - 1} + 1mm\n" for i in range(1, 5000))
    assert not errors_of("let a0 = 1m\n" + links + ROAD + "require r: length(main) > a4999 - 5m\n")


def test_agents_may_stand_behind_one_another_in_a_long_row() -> None:
    row = "agent g0 is car on main at 1m\n" + "".join(
        f"agent g{i} is car on main at g{i - 1}.start + 1cm {{ overlap: true }}\n"
        for i in range(1, 250)
    )
    scene = roadlang.loads(ROAD + row).sample()[0]
    assert scene.agents["g249"].start == pytest.approx(1 + 249 * 0.01)


def test_a_call_in_a_call_is_one_level() -> None:
    calls = "abs(" * 140 + "1m" + ")" * 140
    assert not errors_of(f"param a = {calls}\n")


def test_what_is_made_of_a_name_too_deep_is_left_alone() -> None:
    """Of the name nothing is known, so that the roles of a call cannot be wrong."""
    deep = "let deep = " + "(0m + " * 300 + "main.length" + ")" * 300 + "\n"
    (error,) = errors_of(ROAD + deep + "require r: always (deviation(deep, main) < 1m)\n")
    assert error.code == Code.NESTING_TOO_DEEP
