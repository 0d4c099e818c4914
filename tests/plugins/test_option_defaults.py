"""What an option may have as words, bounds and default, and as what its kind is listed."""

from __future__ import annotations

import math
from typing import Any

import pytest

from roadlang.ir.dimension import LENGTH, PURE, SPEED
from roadlang.plugins.kind_checks import _label
from roadlang.plugins.option_checks import option_fault
from roadlang.plugins.option_types import (
    FlagType,
    IntervalType,
    LikeType,
    ListType,
    NamesType,
    OptionType,
    PointType,
    QuantityType,
    TextType,
    UnionType,
    WordType,
)
from roadlang.plugins.options import Constraints, OptionSchema

METERS, WHOLE = QuantityType(LENGTH), QuantityType(PURE, is_integer=True)


def fault(type_: OptionType, default: Any, **constraints: Any) -> str | None:
    return option_fault(OptionSchema("one", type_, default, Constraints(**constraints)))


@pytest.mark.parametrize(
    ("type_", "fitting", "others"),
    [
        (METERS, [None, 1, 1.5, -2.0, math.inf], [True, "1m", (1.0,), math.nan]),
        (WHOLE, [3], [3.0, True]),
        (LikeType(), [1, 2.5], ["x", False]),
        (FlagType(), [True, False], [1, "true"]),
        (TextType(), ["", "a b"], [1, ("a",)]),
        (ListType(METERS), [(), (1, 2.5)], [1.0, (1, "x")]),
        (ListType(METERS, at_least=2), [(1, 2), (1, 2, 3)], [(), (1,)]),
        (IntervalType(METERS), [(1, 2), (1.0, 1.0), (0, math.inf)], [(2, 1), (1,), (1, 2, 3), 5]),
        (PointType(LENGTH), [(1, 2.5)], [(1,), (1, 2, 3), ("x", 1), 2.0]),
        (PointType(LENGTH, SPEED), [(1, 2)], [(1, True)]),
        (PointType(LENGTH, in_space=True), [(1, 2, 3)], [(1, 2)]),
        (ListType(PointType(LENGTH)), [((1, 2), (3, 4))], [(1, 2), ((1, 2), 3)]),
        (UnionType((FlagType(), METERS)), [True, 2.5], ["x", (1,)]),
        (NamesType(), [(), ("a", "b")], ["a", ("a", 1)]),
    ],
)
def test_a_default_is_what_a_scene_file_could_say(
    type_: OptionType, fitting: list[Any], others: list[Any]
) -> None:
    assert [fault(type_, value) for value in fitting] == [None] * len(fitting)
    for value in others:
        found = fault(type_, value)
        assert found is not None, value
        assert found.startswith(f"has the default {value!r}; expected: ")


@pytest.mark.parametrize(
    ("bounds", "inside", "outside"),
    [
        ({"minimum": 1.0}, [1.0, 5.0], [0.9]),
        ({"above": 1.0}, [1.1], [1.0, 0.5]),
        ({"maximum": 2.0}, [2.0, -3.0], [2.1]),
        ({"below": 2.0}, [1.9], [2.0]),
        ({"minimum": 0.0, "below": 2.0}, [0.0], [-0.1, 2.0]),
    ],
)
def test_a_default_is_within_its_bounds_each_number_of_it(
    bounds: dict[str, float], inside: list[float], outside: list[float]
) -> None:
    for type_, of in ((METERS, lambda x: x), (ListType(METERS), lambda x: (inside[0], x))):
        assert [fault(type_, of(value), **bounds) for value in inside] == [None] * len(inside)
        assert None not in [fault(type_, of(value), **bounds) for value in outside]


@pytest.mark.parametrize(
    ("bounds", "is_empty"),
    [
        ({"minimum": 2.0, "maximum": 1.0}, True), ({"above": 2.0, "below": 1.0}, True),
        ({"minimum": 0.0, "above": 2.0, "maximum": 1.0}, True),
        ({"minimum": 1.0, "maximum": 1.0}, False), ({"above": 1.0}, False),
    ],
)  # fmt: skip
def test_bounds_allow_something(bounds: dict[str, float], is_empty: bool) -> None:
    found = fault(METERS, None, **bounds)
    assert (found is not None and found.startswith("allows no value: ")) is is_empty


@pytest.mark.parametrize("word", ["left", "1.8", "two words", "é", "a-b"])
def test_words_are_what_can_be_written(word: str) -> None:
    assert fault(WordType(), word, words=("other", word)) is None
    assert fault(METERS, word, words=(word,)) is None
    assert fault(ListType(WordType()), (word,), words=(word,)) is None


@pytest.mark.parametrize("word", ["", " a", "a ", "a\nb", 'a"b', "a'b", "a`b", "a\\b", "a\x07b", 3])
def test_words_that_cannot_be_written_are_refused(word: Any) -> None:
    assert fault(WordType(), None, words=("fine", word)) == (
        f"has the word {word!r}, which cannot be written in a scene file"
    )


def test_a_word_is_one_of_the_words() -> None:
    assert str(fault(WordType(), None)).startswith("is a word, but has no words")
    assert fault(WordType(), "up", words=("left",)) is not None
    assert fault(ListType(WordType()), ("left", "up"), words=("left",)) is not None
    assert fault(ListType(WordType()), "left up", words=("left",)) is not None


@pytest.mark.parametrize(
    ("members", "label"),
    [
        ({"verb": "perturb", "name": "sway"}, "perturb sway"),
        ({"verb": "perturb"}, "Odd"), ({"name": "sway"}, "Odd"),
        ({"verb": "perturb", "name": ""}, "Odd"), ({"verb": "perturb", "name": 3}, "Odd"),
    ],
)  # fmt: skip
def test_a_kind_is_called_by_verb_and_name_where_it_has_both(
    members: dict[str, Any], label: str
) -> None:
    assert _label(type("Odd", (), members)) == label
