"""Roads in many variants: choosing variants keeps all that is known of each."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from roadlang.geometry import Curve, CurveFrame, DisplacedBatch
from roadlang.ir.batch import BatchRandom, RoadBatch

VARIANTS = 4
CURVE = Curve.through([(0.0, 0.0), (50.0, 10.0), (100.0, 0.0)])
FRAME = CurveFrame.of(CURVE, CURVE.stations(count=21))


@st.composite
def road_batches(draw: st.DrawFn, depth: int = 1) -> RoadBatch:
    """Roads of 4 variants in which each array has 4 rows, or one where all variants are alike."""

    def rows(columns: int) -> Any:
        count = draw(st.sampled_from([1, VARIANTS]))
        numbers = draw(st.lists(st.integers(-3, 3), min_size=count, max_size=count))
        return np.repeat(np.array(numbers, float)[:, None], columns, axis=1)

    displacement = rows(21)
    values = {
        "name": "wavy",
        "root": "main",
        "curves": DisplacedBatch(FRAME, displacement),
        "width": 8.0 + rows(1),
        "displacement": displacement,
        "confidence": draw(st.sampled_from([0.0, 0.25, 1.0])),
    }
    for field in fields(RoadBatch):
        if field.name == "others":
            values["others"] = tuple(draw(st.lists(road_batches(0), max_size=2)) if depth else ())
        elif field.name not in values:  # `over: [a, b]` of the pass
            low = draw(st.sampled_from([0.0, 10.0]))
            values[field.name] = draw(st.sampled_from([None, (low, 60.0), (rows(1), 60.0)]))
    return RoadBatch(**values)


def of_variant(value: Any, row: int) -> Any:
    """A field's value in one variant, as plain lists."""
    if isinstance(value, RoadBatch):
        return {f.name: of_variant(getattr(value, f.name), row) for f in fields(value)}
    if isinstance(value, DisplacedBatch):
        return of_variant(value.points, row)
    if isinstance(value, np.ndarray):
        return value[row if len(value) > 1 else 0].tolist()
    if isinstance(value, tuple):
        return [of_variant(item, row) for item in value]
    return value


@given(road_batches(), st.lists(st.integers(0, VARIANTS - 1), min_size=1, max_size=6))
def test_take_keeps_every_field_of_the_variants(road: RoadBatch, rows: list[int]) -> None:
    taken = road.take(np.array(rows))
    for place, row in enumerate(rows):
        assert of_variant(taken, place) == of_variant(road, row)


def test_normal_numbers_have_the_moments_of_the_standard_normal_distribution() -> None:
    numbers = BatchRandom(np.arange(200, dtype=np.uint64)).normal(1000).reshape(-1)
    assert abs(numbers.mean()) < 0.01
    assert abs(numbers.std() - 1.0) < 0.01
    assert abs((numbers**3).mean()) < 0.03
    assert abs((numbers**4).mean() - 3.0) < 0.06
    assert abs((np.abs(numbers) < 1.0).mean() - 0.6827) < 0.005


def test_streams_and_keys_give_other_numbers_and_the_same_ones_again() -> None:
    random = BatchRandom(np.array([1, 2], np.uint64))
    first = random.uniform(100)
    assert (first == random.uniform(100)).all()
    assert not np.isclose(first, random.uniform(100, stream=1)).any()
    assert not np.isclose(first[0], first[1]).any()
    assert ((first >= 0.0) & (first < 1.0)).all()
