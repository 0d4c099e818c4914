"""Options that several controllers have, with one meaning, default and limits."""

from __future__ import annotations

from typing import Any

from roadlang.api import option


def target_speed_option() -> Any:
    """`speed`: None where nothing is stated, so that the speed limit counts."""
    return option(
        None,
        minimum=0,
        maximum=120,
        help="target speed; by default the speed limit, or 50 km/h without one",
        example="40km/h",
    )


def lateral_acceleration_option() -> Any:
    """`lateral_acceleration`: how fast bends are taken."""
    return option(
        4.5, above=0, maximum=100, help="maximum lateral acceleration; it slows down before bends"
    )
