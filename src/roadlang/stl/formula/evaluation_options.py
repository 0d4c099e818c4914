"""How a formula is evaluated: what signals are between samples, and what robustness measures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from .formulas import Formula

Semantics: TypeAlias = Literal["sampled", "held", "linear"]
"""What a signal is between two samples: not looked at, that of the earlier one, or on the line."""

Measure: TypeAlias = Literal["space", "time", "time_left", "average"]
"""What robustness measures: by how much signals may change, by how much they may be shifted to
later or earlier times, or their margins averaged over windows."""


@dataclass(frozen=True, slots=True)
class EvaluationOptions:
    """`weights`: operands of `and` and `or` with what each of them weighs, 1 for the others.
    `strict`: a vacuous verdict, which depends on windows without samples, counts as violated.

    Whether a formula is satisfied depends on `semantics` and `strict` alone: the robustness of
    every measure is positive only where the formula holds, and negative only where it does not.
    """

    semantics: Semantics = "sampled"
    robustness: Measure = "space"
    weights: tuple[tuple[Formula, float], ...] = ()
    strict: bool = False

    @property
    def is_plain(self) -> bool:
        """Whether this is the robustness of `Formula.rho`, at the samples."""
        return self == PLAIN

    @property
    def is_shift(self) -> bool:
        """Whether robustness is a shift along the positions, in their unit."""
        return self.robustness in ("time", "time_left")

    @property
    def conflict(self) -> tuple[str, str] | None:
        """Two options that do not go together, if there are such."""
        chosen = [
            name
            for name, value in (
                ("semantics", self.semantics != "sampled"),
                ("robustness", self.robustness != "space"),
                ("weights", bool(self.weights)),
            )
            if value
        ]
        return (chosen[0], chosen[1]) if len(chosen) > 1 else None


PLAIN = EvaluationOptions()
