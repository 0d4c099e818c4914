"""Kinds of sensors of agents."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from .base import Kind


@dataclass(frozen=True)
class ReadingArray:
    """One array of the readings of a sensor."""

    shape: tuple[int, ...] = ()
    """of one reading; () of a number"""
    dtype: str = "float64"
    """of numpy"""
    low: float = float("-inf")
    """the least value"""
    high: float = float("inf")
    """the greatest value"""
    unit: str = ""
    """SI unit; empty of dimensionless numbers, colors and ids"""


class Sensor(Kind):
    """`sense with`: a sensor of an agent. Its readings reach the controllers of the agent."""

    verb: ClassVar[str] = "sense"

    def arrays(self) -> Mapping[str, ReadingArray]:
        """What a reading holds, by name: `{"distances": ReadingArray((72,), unit="m")}`."""
        return {}
