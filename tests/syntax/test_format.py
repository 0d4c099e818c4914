"""`roadlang fmt`: one canonical form, nothing lost, and formatting twice changes nothing."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings

from roadlang.diagnostics import Source
from roadlang.syntax import format_file, format_source, parse
from roadlang.syntax.parsing.lexer import lex
from roadlang.syntax.parsing.tables import tables
from roadlang.syntax.printing.nodes import one_line
from roadlang.syntax.tree import nodes as ast
from tests.syntax.strategies import files

SAMPLES = sorted((Path(__file__).parent / "samples").glob("*.rl"))
slow_to_draw = settings(
    max_examples=15,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)


def formatted(text: str) -> str:
    result, found = format_source(Source("test.rl", text))
    assert result is not None, found
    return result


@pytest.mark.parametrize("path", SAMPLES, ids=lambda path: path.stem)
def test_a_sample_keeps_its_tree_and_comments(path: Path) -> None:
    text = path.read_text()
    tree, _ = parse(Source("before.rl", text))
    again, found = parse(Source("after.rl", format_file(tree)))
    assert not found
    assert again == tree
    assert format_file(again) == format_file(tree)


@given(files())
@slow_to_draw
def test_any_tree_is_read_back_as_it_was_printed(tree: ast.File) -> None:
    text = format_file(tree)
    again, found = parse(Source("printed.rl", text))
    assert not found, text
    assert again == tree, text
    assert format_file(again) == text


@pytest.mark.slow
@given(files())
@settings(slow_to_draw, max_examples=75)
def test_very_many_trees_are_read_back(tree: ast.File) -> None:
    again, found = parse(Source("printed.rl", format_file(tree)))
    assert not found
    assert again == tree


@given(files().map(format_file))
@slow_to_draw
def test_comments_anywhere_are_kept_in_place(text: str) -> None:
    commented = _sprinkle(text, random.Random(text))
    tree, _ = parse(Source("commented.rl", commented))
    once = formatted(commented)
    again, found = parse(Source("once.rl", once))
    assert not found
    assert again == tree, commented
    assert formatted(once) == once


def _sprinkle(text: str, rng: random.Random) -> str:
    """Comments behind some of the tokens, which may be in the middle of an expression."""
    out, last = [], 0
    for number, (_, _, _, end) in enumerate(lex(Source("plain.rl", text), tables()).tokens):
        out.append(text[last:end])
        last = end
        starts_glued = text[end : end + 1] not in ("", " ", "\n")
        if not starts_glued and rng.random() < 0.2:
            comment = rng.choice(["  # note {}\n", "\n# line {}\n", "\n\n  # apart {}\n"])
            out.append(comment.format(number))
    return "".join(out) + text[last:]


def test_habits_of_the_literature_become_words() -> None:
    assert formatted("require a: G(p < 1m) -> F[0m:5m] !(q > 2m) && r < 1m") == (
        "require a: always (p < 1m) implies eventually[0m, 5m] not (q > 2m) and r < 1m\n"
    )


def test_a_block_stays_on_its_line_if_it_fits() -> None:
    assert formatted("world   {weather:rain,friction : 0.4}") == (
        "world { weather: rain, friction: 0.4 }\n"
    )


def test_a_block_over_several_lines_has_one_item_on_each() -> None:
    assert formatted("world { weather: rain, friction: 0.4\n}") == (
        "world {\n  weather: rain\n  friction: 0.4\n}\n"
    )


def test_passes_need_no_comma_behind_their_brace() -> None:
    text = "image b from a { adjust with blur { size: 5px } adjust with noise, scale: 1m/px }\n"
    assert formatted(text) == text


def test_one_blank_line_between_groups_is_kept() -> None:
    assert formatted("\n\nparam a = 1\n\n\n\nparam b = 2\nparam c = 3\n\n") == (
        "param a = 1\n\nparam b = 2\nparam c = 3\n"
    )


def test_comments_keep_their_column() -> None:
    text = "param a = 1      # one\nparam long = 2   # two\n"
    assert formatted(text) == text


def test_a_comment_after_a_block_that_is_broken_stands_beside_its_brace() -> None:
    options = ", ".join(f"option_{n}: {n}m" for n in range(12))
    text = f"world {{ {options} }}  # long\nparam a = 1{' ' * 150}# short\n"
    lines = formatted(text).splitlines()
    assert lines[-2:] == ["}  # long", "param a = 1  # short"]


def test_an_expression_on_one_line_is_the_same_however_it_was_laid_out() -> None:
    wide = "require r: G[0m:5m](\n  a<1m   # note\n  && b > 2m)\n"
    tree, _ = parse(Source("wide.rl", wide))
    again, _ = parse(Source("again.rl", formatted("require r: G[0m:5m](a<1m && b > 2m)")))
    texts = {
        one_line(statement.formula)
        for statement in (*tree.statements, *again.statements)
        if isinstance(statement, ast.Constraint) and statement.formula is not None
    }
    assert texts == {"always[0m, 5m] (a < 1m and b > 2m)"}


def test_statements_move_to_the_left_margin() -> None:
    assert formatted("  param a = 1\n    # note\n    param b = 2") == (
        "param a = 1\n# note\nparam b = 2\n"
    )


def test_a_long_formula_breaks_before_an_operator() -> None:
    long = " and ".join(f"distance(ego, walker_{number}) > 10m" for number in range(5))
    assert formatted(f"require apart: {long}").splitlines()[1].startswith("  and ")


def test_squared_lengths_are_not_confused_with_powers() -> None:
    text = "param a = (2m)^2\nparam b = 2m ^ 2\nparam c = 2m^2\nparam d = a^2 / 3m\n"
    assert formatted(text) == text


def test_a_file_with_errors_is_not_touched() -> None:
    result, found = format_source(Source("broken.rl", "param a = "))
    assert result is None
    assert [diagnostic.code for diagnostic in found] == ["RL001"]


@pytest.mark.parametrize(("letters", "lines"), [(99, 1), (100, 1), (101, 2)])
def test_a_line_has_a_hundred_columns_and_no_more(letters: int, lines: int) -> None:
    name = "x" * (letters - len("let a = b + "))
    text, _ = format_source(Source("p.rl", f"let a = b + {name}\n"))
    assert text is not None
    assert len(text.splitlines()) == lines


@pytest.mark.parametrize(("columns", "lines"), [(99, 1), (100, 1), (101, 4)])
def test_a_part_of_a_broken_line_has_a_hundred_columns_as_well(columns: int, lines: int) -> None:
    """The call stays on its line, or has a line for each argument."""
    name = "x" * (columns - len("  and f(, y)"))
    written = formatted(f"require a: {'p' * 60} < 3 and f({name}, y)\n")
    assert len(written.splitlines()) == 1 + lines, written
    assert max(map(len, written.splitlines())) <= 101


def test_a_number_and_its_power_are_kept_apart() -> None:
    """`2m^2` is one number, two square meters; `a^2` is no unit."""
    assert formatted("let a = 2m ^ 2\nlet b = a ^ 2\n") == "let a = 2m ^ 2\nlet b = a^2\n"


def test_an_override_has_one_form() -> None:
    text = "override   left.ego{drive with stanley,lane:-2}\n"
    assert formatted(text) == "override left.ego { drive with stanley, lane: -2 }\n"


def test_override_is_free_as_the_name_of_an_option() -> None:
    text = "agent ego is car on main at 5m { override: 3m }\n"
    assert formatted(text) == text


def test_the_options_of_a_formula_stay_behind_it() -> None:
    text = "require a: always (x < 3) {robustness:average}\nrequire b: x < 3 {}\n"
    expected = "require a: always (x < 3) { robustness: average }\nrequire b: x < 3 {}\n"
    assert formatted(text) == expected
