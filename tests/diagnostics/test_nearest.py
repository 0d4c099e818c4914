"""Did you mean: slips of the keyboard are found, strangers are not."""

from __future__ import annotations

import importlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.diagnostics.nearest import CHOSEN, MANY, edits, nearest

words = st.text("abcde", min_size=0, max_size=8)


@pytest.mark.parametrize(
    ("word", "known", "meant"),
    [
        ("amplitdue", ["amplitude", "phase"], "amplitude"),
        ("aps", ["abs", "gap", "max"], "abs"),
        ("e2", ["e1", "main"], "e1"),
        ("wodht", ["width", "length"], "width"),  # two slips in five letters
        ("wodhx", ["width", "length"], None),  # and three
        ("Sine", ["sine", "scale"], "sine"),
        ("pure-pursuit", ["pure_pursuit"], "pure_pursuit"),
        ("curve", ["curvature", "length"], "curvature"),
        ("xyz", ["main", "bent"], None),
        ("color", ["speed", "closed"], None),
        ("bended", ["main", "bent", "ego"], "bent"),
        ("contour", ["cone", "bent"], None),
        ("x", ["y"], None),
        ("anything", [], None),
    ],
)
def test_nearest(word: str, known: list[str], meant: str | None) -> None:
    assert nearest(word, known) == meant


@given(words, words)
def test_edits_are_symmetric_and_zero_for_the_same(a: str, b: str) -> None:
    assert edits(a, b, 20) == edits(b, a, 20)
    assert (edits(a, b, 20) == 0) == (a == b)


@given(words, st.integers(0, 6))
def test_swapping_two_neighbors_is_one_edit(a: str, index: int) -> None:
    if index + 1 < len(a) and a[index] != a[index + 1]:
        swapped = a[:index] + a[index + 1] + a[index] + a[index + 2 :]
        assert edits(a, swapped, 20) == 1


@given(words, words)
def test_no_more_than_asked_for_is_counted(a: str, b: str) -> None:
    assert edits(a, b, 2) == min(edits(a, b, 20), 3)


LETTERS = "abcdefghijklmnopqrstuvwxyz"


def many_names(count: int) -> list[str]:
    return [f"a_parameter_of_the_road_with_a_name_{index:04d}" for index in range(count)]


@given(st.integers(0, 4999), st.integers(0, 39), st.sampled_from(LETTERS))
def test_a_slip_is_found_among_thousands_of_names(index: int, at: int, letter: str) -> None:
    known = many_names(5000)
    word = known[index][:at] + letter + known[index][at + 1 :]
    found = nearest(word, known)
    assert found is not None
    assert edits(word, found, 2) <= edits(word, known[index], 2)


def test_a_word_is_compared_with_few_of_many_names(monkeypatch: pytest.MonkeyPatch) -> None:
    compared = []
    module = importlib.import_module("roadlang.diagnostics.nearest")

    def counted(a: str, b: str, most: int) -> int:
        compared.append(b)
        return edits(a, b, most)

    monkeypatch.setattr(module, "edits", counted)
    for word in ("a_parametre_of_the_road_with_a_name_0420", "nothing_like_it", "name_00"):
        compared.clear()
        nearest(word, many_names(5000))
        assert len(compared) <= CHOSEN
    compared.clear()
    nearest("a_parametre", many_names(MANY))
    assert len(compared) == MANY
