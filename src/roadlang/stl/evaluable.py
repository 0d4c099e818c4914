"""What every formula can be asked; the work is imported only when it is asked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .trace import FloatArray, Positions, Signals


class Evaluable:
    """Evaluation of a formula over sampled signals.

    `positions` has shape (S,), strictly increasing. A signal is a number, (S,), (V, S), or
    (V, 1) for one number per variant. With a two-dimensional signal results have a leading
    variant axis of length V; otherwise they have none. `wrap` is the length of a closed road,
    over whose start windows then reach. Bad input raises DiagnosticError (RL30x).
    """

    __slots__ = ()

    def rho(
        self, positions: Positions, signals: Signals, *, wrap: float | None = None
    ) -> FloatArray:
        """Robustness at the first sample, shape (V,) or (): only what it depends on is computed."""
        from .evaluation import rho

        return rho(self, positions, signals, wrap=wrap)
