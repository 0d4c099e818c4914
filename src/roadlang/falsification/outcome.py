"""What came of a candidate: plain numbers, which travel between processes and into the journal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from ..ir.controller_failure import ControllerFailure


@dataclass(frozen=True, slots=True)
class Moment:
    """The moment at which a violated expectation goes wrong."""

    expectation: str
    time: float
    """seconds"""
    agent: str
    x: float
    """meters east"""
    y: float
    """meters north"""
    station: float | None = None
    """arc length along the road of the agent, meters"""
    speed: float | None = None
    """of the agent, m/s"""
    partner: str = ""
    """the other agent or object that the expectation is about; empty where there is none"""
    partner_kind: str = ""
    closing: float | None = None
    """speed with which the partner comes closer, m/s"""
    place: str = ""
    """the road or junction of a network; empty where the agent is in none"""


@dataclass(frozen=True, slots=True)
class Outcome:
    """One evaluated candidate. Robustness is None where it is infinite or was not evaluated."""

    index: int
    """number of the evaluation, from 0"""
    point: tuple[float, ...]
    """its coordinates in the unit cube, one for each axis"""
    is_random: bool
    """whether it was drawn at random, and so counts for the failure rate"""
    violation: float | None
    """how far the requirements are violated, in usual violations; None where they all hold"""
    requirements: Mapping[str, float | None] = field(default_factory=dict)
    """robustness of each requirement"""
    expectations: Mapping[str, float | None] = field(default_factory=dict)
    """robustness of each expectation of the search, the most important first"""
    violated: tuple[str, ...] = ()
    """names of the expectations that the drive violates"""
    draws: Mapping[str, Any] = field(default_factory=dict)
    """params and draws of the scene"""
    measures: Mapping[str, float | None] = field(default_factory=dict)
    """what coverage is counted of"""
    descriptor: tuple[float, ...] = ()
    """what the drive was like: further apart than 1 is distinct"""
    moment: Moment | None = None
    """of a violated expectation, the most important first"""
    controller_failures: tuple[ControllerFailure, ...] = ()
    """controllers that failed while the drive went on"""

    @property
    def is_valid(self) -> bool:
        """Whether the requirements hold, so that the scene was driven."""
        return self.violation is None

    @property
    def is_failure(self) -> bool:
        """Whether an expectation of the search is violated."""
        return bool(self.violated)

    @property
    def cause(self) -> str:
        """What failed, against whom and where in a network: failures of different causes are
        distinct."""
        moment, failed = self.moment, (failure.agent for failure in self.controller_failures)
        if moment is None:
            return " ".join(("", *failed))
        parts = (moment.expectation, moment.partner_kind, moment.place)
        return " ".join((*filter(None, parts), *failed))
