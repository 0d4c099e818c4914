"""What the embedded engine has to know of standard agents."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from roadlang.api import Body

TWO_WHEELS = Body(steering_rate=2.0, mass_height=0.0)
BODIES: Mapping[str, Body] = {
    "car": Body(),
    "van": Body(drag_area=1.35, power=42.0),
    "truck": Body(drag_area=5.2, power=21.0, rolling=0.008),
    "bus": Body(drag_area=4.8, power=16.0, rolling=0.008),
    "taxi": Body(),
    "police_car": Body(),
    "ambulance": Body(drag_area=1.6, power=40.0),
    "fire_truck": Body(drag_area=5.2, power=18.0, rolling=0.008),
    "tractor": Body(drag_area=4.0, power=15.0, rolling=0.02),
    "scooter": replace(TWO_WHEELS, drag_area=0.6, power=4.0, rolling=0.01),
    "motorcycle": replace(TWO_WHEELS, drag_area=0.45, power=180.0, rolling=0.015),
    "bicycle": replace(TWO_WHEELS, drag_area=0.45, power=4.0, rolling=0.006),
    "pedestrian": Body(walks=True),
    "animal": Body(walks=True),
    "child": Body(walks=True),
    "dog": Body(walks=True),
}
"""By the name of the kind: drag area in m^2, power in W for each kilogram; typical numbers, of no
maker in particular."""
