"""A perturbation of an interval begins and ends abruptly: what taper the warning proposes."""

from __future__ import annotations

import pytest

from roadlang import testing

TEXT = """
road main {{ draw with waypoints {{ points: [(0m, 0m), (100m, 0m)] }} }}
road bent from main {{ perturb with sine {{ amplitude: 1m, wavelength: 50m, over: {} }} }}
"""


@pytest.mark.parametrize(
    ("interval", "taper"),
    [
        ("[0m, 80m]", "10m"), ("[10m, 50m]", "10m"), ("[10m, 49m]", "9.75m"), ("[10m, 30m]", "5m"),
        ("[10m, 12m]", "0.5m"), ("[10m, 10m]", "10m"), ("[0m, 20m..30m]", "10m"),
    ],
)  # fmt: skip
def test_a_taper_is_10_m_or_a_quarter_of_a_short_interval(interval: str, taper: str) -> None:
    warnings = [found for found in testing.check(TEXT.format(interval)) if found.fixes]
    written = [fix.replacement for found in warnings for fix in found.fixes]
    assert written == [f"over: {interval}, taper: {taper}"]


def test_with_a_taper_there_is_no_warning() -> None:
    assert testing.check(TEXT.format("[10m, 30m], taper: 2m")) == ()
