"""Units and dimensions: exact factors, and arithmetic as quantities have it."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.ir.dimension import ACCELERATION, CURVATURE, FORCE, PURE, SPEED, Dimension
from roadlang.ir.units import UNITS, TwoSlashes, UnknownUnit, parse_unit

exponents = st.integers(-4, 4).map(float)
dimensions = st.builds(Dimension, exponents, exponents, exponents, exponents, exponents)


@pytest.mark.parametrize(
    ("text", "factor", "dimension"),
    [
        ("", 1.0, PURE),
        ("%", 0.01, PURE),
        ("km/h", 1000 / 3600, SPEED),
        ("mph", 0.44704, SPEED),
        ("m/s^2", 1.0, ACCELERATION),
        ("/m", 1.0, CURVATURE),
        ("1/m", 1.0, CURVATURE),
        ("kg*m/s^2", 1.0, FORCE),
        ("N", 1.0, FORCE),
        ("deg", math.pi / 180, Dimension(angle=1)),
        ("m^1.5", 1.0, Dimension(length=1.5)),
        ("mm/h", 1e-3 / 3600, SPEED),
    ],
)
def test_factor_and_dimension(text: str, factor: float, dimension: Dimension) -> None:
    unit = parse_unit(text)
    assert unit.factor == pytest.approx(factor, rel=1e-12)
    assert unit.dimension == dimension


def test_an_unknown_part_is_named() -> None:
    with pytest.raises(UnknownUnit) as caught:
        parse_unit("m/sec")
    assert caught.value.word == "sec"


def test_one_slash_at_most() -> None:
    with pytest.raises(TwoSlashes):
        parse_unit("m/s/s")


@given(dimensions, dimensions)
def test_division_undoes_multiplication(a: Dimension, b: Dimension) -> None:
    assert a * b / b == a


@given(dimensions, st.integers(1, 3))
def test_a_power_is_repeated_multiplication(a: Dimension, n: int) -> None:
    product = PURE
    for _ in range(n):
        product = product * a
    assert a**n == product


@given(dimensions)
def test_the_unit_of_a_dimension_reads_back_as_the_dimension(a: Dimension) -> None:
    assert parse_unit(a.unit).dimension == a


def test_every_unit_is_itself() -> None:
    for name, unit in UNITS.items():
        assert parse_unit(name) == unit


@pytest.mark.parametrize(
    ("dimension", "unit", "name"),
    [
        (PURE, "", "a dimensionless number"),
        (SPEED, "m/s", "a speed"),
        (ACCELERATION, "m/s^2", "an acceleration"),
        (CURVATURE, "1/m", "a curvature"),
        (FORCE, "m*kg/s^2", "a force"),
        (Dimension(length=1.5), "m^1.5", "a quantity in m^1.5"),
        (Dimension(time=-1, angle=1), "rad/s", "an angular velocity"),
    ],
)
def test_a_dimension_has_a_unit_and_a_name(dimension: Dimension, unit: str, name: str) -> None:
    assert (dimension.unit, str(dimension)) == (unit, name)


@pytest.mark.parametrize(("text", "factor"), [("cm^2", 1e-4), ("km^2", 1e6), ("m/min^2", 1 / 3600)])
def test_a_power_of_a_unit_is_that_of_its_factor(text: str, factor: float) -> None:
    assert parse_unit(text).factor == pytest.approx(factor, rel=1e-12)
