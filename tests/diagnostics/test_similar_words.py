"""Which of the known names a word is taken for, where several come near it."""

from __future__ import annotations

from functools import cache

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.diagnostics.nearest import MANY, KnownNames, edits, nearest
from roadlang.diagnostics.printable import one_line, printable, shown

words = st.text("abc", min_size=0, max_size=7)


def plain_edits(a: str, b: str) -> int:
    """The restricted Damerau-Levenshtein distance by its definition."""

    @cache
    def between(i: int, j: int) -> int:
        if i == 0 or j == 0:
            return max(i, j)
        found = min(
            between(i - 1, j) + 1,
            between(i, j - 1) + 1,
            between(i - 1, j - 1) + (a[i - 1] != b[j - 1]),
        )
        if i > 1 and j > 1 and a[i - 1] == b[j - 2] and a[i - 2] == b[j - 1]:
            found = min(found, between(i - 2, j - 2) + 1)
        return found

    return between(len(a), len(b))


@given(words, words, st.integers(0, 5))
def test_edits_are_counted_as_by_their_definition_up_to_the_most(a: str, b: str, most: int) -> None:
    assert edits(a, b, most) == min(plain_edits(a, b), most + 1)


@pytest.mark.parametrize(
    ("word", "known", "meant"),
    [
        # As many edits away: the one that is more alike, then the one with more letters before.
        ("tre", ["tire", "tree"], "tree"),
        ("loweer", ["lowest", "lower"], "lower"),
        ("lowar", ["lower", "loyar"], "lower"),
        # One edit in up to four letters, two from five on.
        ("ab", ["ba"], "ba"),
        ("ab", ["abcd"], None),
        ("abcd", ["abxy"], None),
        ("abcde", ["abxye"], "abxye"),
        ("abcde", ["axyze"], None),
        # The only name that begins with the word, or with which the word begins, of three letters.
        ("cur", ["curvature", "length"], "curvature"),
        ("cu", ["curvature", "length"], None),
        ("cur", ["curvature", "curve_of"], None),
        ("gapped_thing", ["gap", "length"], "gap"),
        ("gapped_thing", ["ga", "length"], None),
        # The only name that begins as the word does and ends otherwise.
        ("bended", ["bent", "lane"], "bent"),
        ("benders", ["bent"], None),
        ("turning", ["turns"], "turns"),
        ("walked", ["walks_x", "wall"], None),
        # Upper and lower case and the sort of dash do not count; of two names the last in order.
        ("A-b", ["a_B", "a_b"], "a_b"),
    ],
)
def test_the_rules_that_choose(word: str, known: list[str], meant: str | None) -> None:
    assert nearest(word, known) == meant
    assert nearest(word, list(reversed(known))) == meant


def test_of_many_names_those_that_share_most_trigrams_come_first() -> None:
    names = KnownNames([f"x{n:03}" for n in range(MANY)] + ["curve_width", "curve", "wide"])
    assert names.like("curve_widht")[:2] == ["curve_width", "curve"]
    assert names.like("qqqqqq") == []
    few = KnownNames(["b", "a", "b"])
    assert few.like("qqqqqq") == ["a", "b"]


@pytest.mark.parametrize(
    ("text", "line"),
    [("a\nb", "a b"), ("a\tb\rc", "a b c"), ("a\n\nb", "a  b"), ("a\x1bb", "aU+001Bb")],
)
def test_a_text_on_one_line_has_blanks_for_its_breaks(text: str, line: str) -> None:
    assert one_line(text) == line


def test_characters_to_keep_stay() -> None:
    assert printable("a\n\x07b", keep="\n") == "a\nU+0007b"
    assert printable("a\nb") == "aU+000Ab"


@pytest.mark.parametrize(
    ("char", "as_shown"),
    [(" ", " "), ("a", "a"), ("\u00a0", "\u00a0"), ("\u00ad", "U+00AD"), ("\U000e0001", "U+E0001")],
)
def test_a_blank_of_another_sort_is_no_control_character(char: str, as_shown: str) -> None:
    assert shown(char) == as_shown
