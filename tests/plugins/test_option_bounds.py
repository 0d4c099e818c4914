"""Bounds of options, and of what distributions state of options that are random themselves."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

import pytest

from roadlang.api import Distribution, Like, Number, Perturber, option
from roadlang.plugins.discovery import load_registry
from roadlang.plugins.entry_points import Origin
from roadlang.plugins.kind_checks import KindFault, check_kind
from roadlang.plugins.options import Constraints
from roadlang.plugins.registry import KindEntry
from roadlang.plugins.stated_bounds import OptionRange, stated_support


@pytest.mark.parametrize("limit", [0.3 * 0.3048, -0.3 * 0.3048, 5.0, -5.0])
def test_a_bound_in_other_units_may_differ_in_the_last_digit(limit: float) -> None:
    for number in (math.nextafter(limit, -math.inf), limit, math.nextafter(limit, math.inf)):
        assert Constraints(minimum=limit).allow(number)
        assert Constraints(maximum=limit).allow(number)
    assert not Constraints(minimum=limit).allow(limit - 1e-6)
    assert not Constraints(maximum=limit).allow(limit + 1e-6)


@pytest.mark.parametrize("limit", [0.0, 2.0])
def test_a_bound_may_exclude_its_own_value(limit: float) -> None:
    assert not Constraints(above=limit).allow(limit)
    assert not Constraints(below=limit).allow(limit)
    assert Constraints(above=limit, below=limit + 1).allow(limit + 0.5)


def kind_with(**bounds: float) -> type[Perturber]:
    @dataclass(frozen=True)
    class Sway(Perturber):
        """Sways."""

        name: ClassVar[str] = "sway"
        size: Number = option(1.0, **bounds)  # type: ignore[arg-type]

        def displacement(self, road: Any, random: Any) -> Any:
            return 0.0 * road.stations

    return Sway


def test_bounds_may_leave_a_single_value_but_not_none() -> None:
    assert check_kind(kind_with(minimum=1, maximum=1))
    with pytest.raises(KindFault, match="allows no value"):
        check_kind(kind_with(minimum=2, maximum=1))


@pytest.mark.parametrize(
    ("options", "support"),
    [
        ({"low": 1.0, "high": 3.0}, (1, 3)),
        ({"low": OptionRange(0, 1), "high": OptionRange(2, 5)}, (0, 5)),
        ({"low": OptionRange(-1, 1), "high": 2.0}, (-1, 2)),
        ({"low": OptionRange(0, math.inf), "high": 2.0}, (-math.inf, math.inf)),
    ],
)
def test_the_support_of_random_ends_holds_whatever_is_drawn_for_them(
    options: dict[str, Any], support: tuple[float, float]
) -> None:
    entry = load_registry().find("distribution", "uniform")
    assert stated_support(entry, entry.load(), options, None) == support


@dataclass(frozen=True)
class Around(Distribution):
    """States a support on both sides of zero, which falls on one side as the option rises."""

    name: ClassVar[str] = "around"
    width: Like

    def quantile(self, uniform: Any) -> Any:
        return self.width * (2 * uniform - 1)

    def support(self) -> tuple[float, float]:
        return -self.width, self.width


def test_the_support_of_a_random_option_spans_what_is_stated_at_its_ends() -> None:
    entry = KindEntry("distribution", "around", Origin("acme", "acme", "1"), Around)
    assert stated_support(entry, Around, {"width": OptionRange(1, 3)}, None) == (-3, 3)
