"""The table of operators: every spelling is read, every operator goes through every notation."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from roadlang import stl
from roadlang.diagnostics import DiagnosticError
from roadlang.stl.formula.formulas import COMPOUNDS, Measured, TemporalOperator, TruthChange
from roadlang.syntax.operators import BY_WORD, OPERATORS, PREFIXES, Operator
from roadlang.syntax.parsing import tables

P, Q = stl.parse("x > 1"), stl.parse("y < 2")


def example(operator: Operator) -> stl.Formula:
    """The operator over `x > 1` and, if it takes two, `y < 2`."""
    kind = COMPOUNDS[operator.word]
    if issubclass(kind, Measured):
        return kind(stl.Interval(1, 2), P, "<=", 3)
    parts = [P] if operator.form in PREFIXES else [P, Q]
    interval = stl.Interval(1, 2) if operator.form in ("temporal", "binding") else None
    return COMPOUNDS[operator.word].of(parts, interval)


def written(operator: Operator, spelling: str, interval: str = "[1, 2]") -> str:
    """The text of the example with another spelling of the operator."""
    if operator.form == "measure":
        return f"{spelling}{interval} (x > 1) <= 3"
    word = spelling + (interval if operator.form in ("temporal", "binding") else "")
    if operator.form in PREFIXES:
        return f"{word} (x > 1)"
    return f"(x > 1) {word} (y < 2)"


def spellings(field: str) -> list[tuple[Operator, str]]:
    found: list[tuple[Operator, str]] = []
    for operator in OPERATORS:
        value = getattr(operator, field)
        found.extend((operator, text) for text in ([value] if isinstance(value, str) else value))
    return [(operator, text) for operator, text in found if text]


def _shown(value: object) -> str:
    return value.word if isinstance(value, Operator) else str(value)


def test_every_operator_has_a_class_and_every_class_an_entry() -> None:
    assert set(COMPOUNDS) == set(BY_WORD)


@pytest.mark.parametrize(
    ("operator", "spelling"),
    [pair for field in ("word", "letter", "signs") for pair in spellings(field)],
    ids=_shown,
)
def test_words_letters_and_signs_are_read(operator: Any, spelling: Any) -> None:
    assert stl.parse(written(operator, spelling)) == example(operator)


def test_the_table_has_every_sign_that_the_grammar_reads() -> None:
    stored = json.loads(Path(tables.__file__).with_name("tables.json").read_text())
    patterns = dict(stored["terminals"])
    for operator in OPERATORS:
        pattern = patterns.get(operator.word.upper(), "")
        for sign in ("!", "&", "&&", "|", "||", "->", "=>", "<->", "<=>"):
            matched = re.fullmatch(pattern, sign) is not None
            assert matched == (sign in operator.signs), (operator.word, sign)


@pytest.mark.parametrize(("operator", "symbol"), spellings("symbols"), ids=_shown)
def test_for_a_symbol_the_word_is_suggested(operator: Any, symbol: Any) -> None:
    with pytest.raises(DiagnosticError) as refused:
        stl.parse(written(operator, symbol))
    assert f"write `{operator.word}`" in refused.value.diagnostics[0].help


@pytest.mark.parametrize(("operator", "command"), spellings("latex"), ids=_shown)
def test_latex_commands_are_read(operator: Any, command: Any) -> None:
    text = written(operator, f"\\{command} ", "_{[1, 2]}")
    assert stl.read_latex(text) == example(operator)


@pytest.mark.parametrize(("operator", "word"), spellings("breach"), ids=_shown)
def test_words_of_breach_are_read(operator: Any, word: Any) -> None:
    text = written(operator, word, "_[1, 2]").replace("x", "x[t]").replace("y ", "y[t] ")
    assert stl.read_breach(text) == example(operator)


@pytest.mark.parametrize("operator", OPERATORS, ids=lambda operator: operator.word)
def test_every_operator_survives_text_and_json(operator: Any) -> None:
    formula = example(operator)
    assert stl.parse(str(formula)) == formula
    assert next(iter(formula.to_json())) == operator.json
    assert stl.from_json(json.loads(json.dumps(formula.to_json()))) == formula


@pytest.mark.parametrize("operator", OPERATORS, ids=lambda operator: operator.word)
def test_a_mirror_looks_the_other_way(operator: Any) -> None:
    kind = COMPOUNDS[operator.word]
    if not issubclass(kind, TemporalOperator) or issubclass(kind, TruthChange | Measured):
        assert not operator.mirror
        return
    mirror = COMPOUNDS[operator.mirror]
    assert issubclass(mirror, TemporalOperator)
    assert mirror.past is not kind.past
