"""Options of kinds: one candidate of a batch, plain numbers, and bounds of what was drawn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang.api import (
    DiagnosticError,
    Length,
    LengthInterval,
    Like,
    ListOf,
    Perturber,
    Point,
    option,
)
from roadlang.diagnostics import Source, Span
from roadlang.evaluate.kind_instance import row_of_kind, scalar
from roadlang.evaluate.option_bounds import check_bounds
from roadlang.ir.read_only import FrozenDict
from roadlang.ir.values import PassCall
from roadlang.plugins.options import schema_of


@dataclass(frozen=True)
class Inner(Perturber):
    """Inside another."""

    name: ClassVar[str] = "inner"
    by: Any = option(1.0, help="how far")


@dataclass(frozen=True)
class Outer(Perturber):
    """With options of all sorts."""

    name: ClassVar[str] = "outer"
    by: Any = option(1.0, help="how far")
    pair: Any = option((0.0, 0.0), help="two of them")
    named: Any = option(None, help="by name")
    inner: Any = option(None, help="a kind")
    word: Any = option("left", help="a side")


def test_the_kind_of_one_candidate_has_plain_numbers_wherever_there_were_columns() -> None:
    column = np.array([[1.0], [2.0], [3.0]])
    whole = np.array([[4], [5], [6]])
    words = np.array([["a"], ["b"], ["c"]], dtype=object)
    batch = Outer(column, (column, 7.0), {"x": whole, "y": words}, Inner(column), "right")
    second = row_of_kind(batch, 1)
    assert second == Outer(2.0, (2.0, 7.0), {"x": 5, "y": "b"}, Inner(2.0), "right")
    assert (type(second.by), type(second.named["x"])) == (float, int)


def test_a_column_of_one_row_is_shared_by_all_candidates() -> None:
    assert row_of_kind(Outer(np.array([[2.5]])), 4).by == 2.5


@pytest.mark.parametrize(
    ("value", "plain"),
    [
        (np.array([[2.5]]), 2.5),
        (np.array([[3]]), 3),
        (np.array([["word"]]), "word"),
        (np.array([[None]], dtype=object), None),
        (np.float64(1.5), 1.5),
        ([np.array([[1.0]]), "a"], (1.0, "a")),
        ({"a": (np.int64(2),)}, {"a": (2,)}),
        ("text", "text"),
    ],
)
def test_the_value_of_a_single_candidate_is_plain(value: Any, plain: Any) -> None:
    found = scalar(value)
    assert found == plain
    assert type(found) is type(plain)


@dataclass(frozen=True)
class Bounded(Perturber):
    """With bounds of both sorts."""

    name: ClassVar[str] = "bounded"
    closed: Length = option(1.0, help="ends included", minimum=0.0, maximum=2.0)
    open: Length = option(1.0, help="ends excluded", above=0.0, below=2.0)
    many: ListOf[Length] = option((), help="a list", minimum=0.0)
    named: dict[str, Length] = option(None, help="a map", minimum=0.0)
    span: LengthInterval = option(None, help="an interval", minimum=0.0)
    place: Point = option(None, help="a point, whose numbers have no bounds", minimum=0.0)
    either: Length | ListOf[Length] = option(1.0, help="one or a list", minimum=0.0)
    like: ListOf[Like] = option((), help="a list in the unit of something else", minimum=0.0)
    mixed: ListOf[ListOf[Length]] = option((), help="a list of lists", minimum=0.0)


PLACE = Span(Source("scene.rl", "bounded { closed: 3m }"), 10, 16)
CALL = PassCall(
    "perturb",
    "tested.bounded",
    FrozenDict(),
    "bent/perturb 1",
    option_spans=FrozenDict({"closed": PLACE}),
)
OPTIONS = {schema.name: schema for schema in schema_of(Bounded)}


@pytest.mark.parametrize(
    ("name", "value", "allowed"),
    [
        ("closed", 0.0, True), ("closed", 2.0, True), ("closed", -0.1, False),
        ("closed", 2.1, False), ("closed", np.array([[1.0], [2.5]]), False), ("closed", 2, True),
        ("open", 0.0, False), ("open", 2.0, False), ("open", 1e-9, True), ("open", 3, False),
        ("open", np.array([[0.5], [1.5]]), True), ("open", np.nan, False), ("open", True, True),
        ("open", "word", True), ("open", np.array([["word"]]), True), ("open", (9.0,), True),
        ("many", (1.0, np.array([[3.0]])), True), ("many", (1.0, np.array([[-3.0]])), False),
        ("many", (1.0, -1.0), False), ("many", (), True), ("many", 1.0, True),
        ("named", {"a": 1.0, "b": 2}, True), ("named", {"a": 1.0, "b": -2}, False),
        ("span", (0.0, np.inf), True), ("span", (-1.0, 4.0), False),
        ("either", 1.0, True), ("either", -1.0, False), ("either", (1.0, 2.0), True),
        ("either", (1.0, -1.0), False), ("like", (1.0, 0.0), True), ("like", (-1.0,), False),
        ("place", (-1.0, -1.0), True), ("mixed", ((1.0,), (2.0, -2.0)), False),
        ("mixed", ((1.0,), (2.0, np.array([[1.0], [0.0]]))), True),
    ],
)  # fmt: skip
def test_bounds_of_options_hold_for_what_was_drawn(name: str, value: Any, allowed: bool) -> None:
    if allowed:
        check_bounds(OPTIONS[name], value, CALL)
    else:
        with pytest.raises(DiagnosticError, match="RL473"):
            check_bounds(OPTIONS[name], value, CALL)


def test_the_error_names_the_first_value_that_is_out_of_bounds_at_its_option() -> None:
    with pytest.raises(DiagnosticError) as caught:
        check_bounds(OPTIONS["closed"], np.array([[1.0], [-2.5], [7.0]]), CALL)
    (found,) = caught.value.diagnostics
    assert found.span == PLACE
    for part in ("-2.5", "closed", "bounded"):
        assert part in found.message
    assert "tested." not in found.message
