"""By how much candidates violate the requirements, as one number that a search can lower."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..geometry.arrays import Floats
from ..judging.acceptance import Acceptance, Measurements

_PILOT, _PILOT_SIZE = -2, 64
"""Candidates that the usual size of violations is learned from."""


class Violations:
    """Each violation counts relative to its typical size, which random candidates tell."""

    def __init__(self, acceptance: Acceptance, seed: int) -> None:
        self._acceptance = acceptance
        self._seed = seed

    def of(self, measured: Measurements) -> Floats:
        """(V,) over the violated requirements the sum of their violations, each relative
        to its typical size and below 1."""
        rho = np.nan_to_num(measured.rho, nan=0.0, posinf=0.0, neginf=-np.inf)
        lack = np.maximum(-rho, 0.0) / self._typical
        size = np.where(np.isfinite(lack), lack / (1.0 + lack), 1.0)
        return np.asarray(np.where(measured.satisfied, 0.0, 0.01 + size).sum(axis=0))

    @cached_property
    def _typical(self) -> Floats:
        """(R, 1) the typical size of a violation of each requirement."""
        attempts = np.arange(_PILOT_SIZE)
        pilot = CandidateBatch(
            self._acceptance.scenario, self._seed, np.full(_PILOT_SIZE, _PILOT), attempts
        )
        rho = self._acceptance.measure(pilot).rho
        lack = np.where(np.isfinite(rho) & (rho < 0.0), -rho, 0.0)
        mean = lack.sum(axis=1) / np.maximum((lack > 0.0).sum(axis=1), 1)
        return np.where(mean > 0.0, mean, 1.0)[:, None]
