"""Cars keep to the middle of their lane on roads with waves, at the speeds of country roads."""

from __future__ import annotations

import numpy as np
import pytest

from .driven_roads import driven


@pytest.mark.parametrize("kind", ["traffic", "lane_follow", "car_follow"])
def test_they_steer_as_much_more_as_their_tires_slip(kind: str) -> None:
    ego = driven(f"""
    road plain {{ draw with segments {{ pieces: [straight(400m)] }}, lanes: 2 }}
    road waves from plain {{ perturb with sine {{ amplitude: 1m, wavelength: 80m }} }}
    agent ego is car on waves at 10m {{ drive with {kind} {{ speed: 90km/h }} }}
    """, duration=14)  # fmt: skip
    steady = (ego.time > 4.0) & (ego.present > 0.0)
    assert ego.speed[steady].min() > 22.0
    assert np.abs(ego.lane_offset[steady]).max() < 0.15
