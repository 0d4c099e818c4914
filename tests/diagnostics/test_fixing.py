"""Fixes are carried out where there is no choice, from the end of the text to its start."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from roadlang.diagnostics import Code, Diagnostic, Fix, Source, diagnose
from roadlang.diagnostics.fixing import apply_fixes

SOURCE = Source("scene.rl", "one two three")


def wrong(*fixes: tuple[int, int, str], source: Source = SOURCE) -> Diagnostic:
    made = [Fix(source.span(start, end), text) for start, end, text in fixes]
    return diagnose(Code.MISSPELLED_WORD, source.span(0, 1), word="one", fixes=made)


def test_every_certain_fix_is_made() -> None:
    assert apply_fixes(SOURCE, [wrong((0, 3, "1")), wrong((8, 13, "3"))]) == ("1 two 3", 2)


def test_a_choice_is_left_to_a_person() -> None:
    assert apply_fixes(SOURCE, [wrong((0, 3, "1"), (0, 3, "a"))]) == (SOURCE.text, 0)


def test_fixes_of_other_files_are_left() -> None:
    other = Source("other.rl", SOURCE.text)
    assert apply_fixes(SOURCE, [wrong((0, 3, "1"), source=other)]) == (SOURCE.text, 0)


def test_of_two_that_overlap_one_is_made() -> None:
    assert apply_fixes(SOURCE, [wrong((0, 7, "x")), wrong((4, 13, "y"))]) == ("one y", 1)


def test_the_same_fix_of_two_diagnostics_is_made_once() -> None:
    assert apply_fixes(SOURCE, [wrong((3, 3, ",")), wrong((3, 3, ","))]) == ("one, two three", 1)


@given(st.lists(st.tuples(st.integers(0, 13), st.integers(0, 13)), max_size=6))
def test_what_lies_outside_all_fixes_stays(ends: list[tuple[int, int]]) -> None:
    places = [(min(pair), max(pair)) for pair in ends]
    text, count = apply_fixes(SOURCE, [wrong((*place, "")) for place in places])
    covered = {i for start, end in places for i in range(start, end)}
    outside = [char for i, char in enumerate(SOURCE.text) if i not in covered]
    assert count <= len(places)
    assert is_subsequence(outside, text)


def is_subsequence(part: list[str], whole: str) -> bool:
    letters = iter(whole)
    return all(letter in letters for letter in part)
