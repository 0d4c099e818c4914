"""What faults of actuators get: the controls that controllers have decided on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..geometry.arrays import Booleans, Floats
    from .batch import BatchRandom


@dataclass(frozen=True, slots=True)
class ActuationBatch:
    """The controls of N agents until the next step. Columns are (N,)."""

    steering: Floats
    """angle of the front wheels, left positive"""
    acceleration: Floats
    """m/s^2, braking negative"""
    active: Booleans
    """whether the fault is active: `when:` and `while:` hold"""
    step: float
    """seconds between decisions"""
    random: BatchRandom
    """random numbers for each agent, others at each step: a function of the seed, the scene, the
    agent, the place of the fault among the controllers, and the step"""
