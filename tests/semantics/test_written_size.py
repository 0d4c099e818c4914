"""What names itself twice over and over is refused before it is written out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from roadlang.diagnostics import Diagnostic
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text
from roadlang.semantics.checker import Checker

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (50m, 5m), (100m, 0m)] } }\n"
FORMULA = "let f0 = abs(curvature(main)) < 1/m\n"


def doubled(name: str, form: str, times: int) -> str:
    """`let f1 = f0 and f0`, `let f2 = f1 and f1`, ... by a form such as `{} and {}`."""
    lines = (
        f"let {name}{k} = {form.replace('{}', f'{name}{k - 1}')}\n" for k in range(1, times + 1)
    )
    return "".join(lines)


def _found(text: str) -> list[Diagnostic]:
    return check_text(text, Path("scene.rl"), {}, load_registry())[1]


def codes_of(text: str) -> list[str]:
    return [diagnostic.code for diagnostic in _found(text) if diagnostic.is_error]


@pytest.mark.parametrize(
    "form", ["{} and {}", "{} or {}", "{} implies {}", "{} iff {}", "{} xor {}"]
)
def test_23_doubled_formulas_are_refused(form: str) -> None:
    text = ROAD + FORMULA + doubled("f", form, 23) + "require r: always f23\n"
    assert codes_of(text) == ["RL242"]


def test_23_doubled_signals_and_lists_are_refused() -> None:
    signals = ROAD + "let g0 = curvature(main)\n" + doubled("g", "{} + {}", 23)
    assert codes_of(signals + "require r: always (g23 < 1/m)\n") == ["RL242"]
    lists = ROAD + "let l0 = [1, 2]\n" + doubled("l", "[{}, {}, {}, {}, {}, {}]", 23)
    assert codes_of(lists) == ["RL242"]


def test_the_place_is_the_statement_that_first_grows_too_large() -> None:
    lists = ROAD + "let l0 = [1, 2]\n" + doubled("l", "[{}, {}, {}, {}, {}, {}]", 23)
    (found,) = [diagnostic for diagnostic in _found(lists) if diagnostic.is_error]
    assert found.message.startswith("`l6` ")
    assert found.span is not None
    assert found.span.line == 8


def test_a_formula_that_is_written_too_large_is_refused_before_it_is_inferred(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    inferred = 0
    infer = Checker.infer

    def counted(checker: Checker, *arguments: Any) -> Any:
        nonlocal inferred
        inferred += 1
        return infer(checker, *arguments)

    monkeypatch.setattr(Checker, "infer", counted)
    many = " and ".join(["abs(curvature(main)) < 1/m"] * 16_667)
    text = f"{ROAD}require r: always ({many})\nlet unknown_too = nothing\n"
    assert codes_of(text) == ["RL242", "RL101"]
    assert inferred < 100


def test_numbers_and_a_few_doublings_are_fine() -> None:
    numbers = ROAD + "param p0 = 0.5..1\n" + doubled("p", "{} + {}", 23)
    assert not codes_of(numbers + "require r: p23 > 5000000\n")
    formulas = ROAD + FORMULA + doubled("f", "{} and {}", 11)
    assert not codes_of(formulas + "require r: always f11\n")


def test_a_long_list_that_is_typed_is_fine() -> None:
    points = ", ".join(f"({x}m, 0m)" for x in range(20_000))
    assert not codes_of(f"road main {{ draw with waypoints {{ points: [{points}] }} }}\n")
