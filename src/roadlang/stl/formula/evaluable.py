"""The methods of every formula.

This is a facade, the one place of the room where imports go up: a method imports what does its
work when it is called. So `formula.rho(...)` reads well, and a formula that is only checked or
printed imports no numpy.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ..dense.grids import GridsOrSignals
    from ..evaluate.trace import FloatArray, Positions
    from ..evaluate.verdicts import Range, Verdict
    from ..explain.explanation import Explanation
    from .evaluation_options import Semantics
    from .formulas import Formula


class Evaluable:
    """Evaluation of a formula over sampled signals.

    `positions` has shape (S,), strictly increasing. A signal is a number, (S,), (V, S), or
    (V, 1) for one number per variant. With a two-dimensional signal results have a leading
    variant axis of length V; otherwise they have none. `wrap` is the length of a closed road,
    over whose start windows then reach. Bad input raises DiagnosticError (RL300 to RL307).
    """

    __slots__ = ()

    @property
    def _formula(self) -> Formula:
        return cast("Formula", self)

    def rho(
        self,
        positions: Positions,
        signals: GridsOrSignals,
        *,
        wrap: float | None = None,
        semantics: Semantics = "sampled",
    ) -> FloatArray:
        """Robustness at the first sample, (V,) or a scalar; computes no more than that needs.

        `semantics` says what signals are between samples; RL311 for what has no value there.
        """
        if semantics != "sampled":
            from ..dense.evaluation import dense_rho

            return dense_rho(self._formula, positions, signals, semantics, wrap)
        from ..evaluate.evaluation import rho

        return rho(self._formula, positions, signals, wrap=wrap)

    def robustness(
        self,
        positions: Positions,
        signals: GridsOrSignals,
        *,
        wrap: float | None = None,
        semantics: Semantics = "sampled",
    ) -> FloatArray:
        """Robustness at every sample, (V, S) or (S,).

        `semantics` says what signals are between samples; RL311 for what has no value there.
        """
        if semantics != "sampled":
            from ..dense.evaluation import dense_robustness

            return dense_robustness(self._formula, positions, signals, semantics, wrap)
        from ..evaluate.evaluation import robustness

        return robustness(self._formula, positions, signals, wrap=wrap)

    def satisfied(
        self,
        positions: Positions,
        signals: GridsOrSignals,
        *,
        wrap: float | None = None,
        semantics: Semantics = "sampled",
    ) -> NDArray[np.bool_]:
        """Boolean satisfaction at the first sample, (V,) or a scalar: `<` and `<=` differ here."""
        if semantics != "sampled":
            from ..dense.verdicts import dense_satisfied

            return dense_satisfied(self._formula, positions, signals, semantics, wrap)
        from ..evaluate.evaluation import satisfied

        return satisfied(self._formula, positions, signals, wrap=wrap)

    def truth(
        self,
        positions: Positions,
        signals: GridsOrSignals,
        *,
        wrap: float | None = None,
        semantics: Semantics = "sampled",
    ) -> NDArray[np.bool_]:
        """Boolean satisfaction at every sample, (V, S) or (S,)."""
        if semantics != "sampled":
            from ..dense.verdicts import dense_truth

            return dense_truth(self._formula, positions, signals, semantics, wrap)
        from ..evaluate.evaluation import truth

        return truth(self._formula, positions, signals, wrap=wrap)

    def range(
        self,
        positions: Positions,
        signals: GridsOrSignals,
        *,
        wrap: float | None = None,
        semantics: Semantics = "sampled",
    ) -> Range:
        """The least and the greatest `rho` over all continuations of the trace: (lo, hi)."""
        from ..evaluate.verdicts import Range, robustness_range

        if semantics != "sampled":
            from ..dense.verdicts import dense_range

            return Range(*dense_range(self._formula, positions, signals, semantics, wrap))
        return robustness_range(self._formula, positions, signals, wrap=wrap)

    def verdict(
        self,
        positions: Positions,
        signals: GridsOrSignals,
        *,
        wrap: float | None = None,
        semantics: Semantics = "sampled",
        finished: bool = False,
    ) -> NDArray[np.str_] | Verdict:
        """Satisfied, violated, unknown or vacuous: a word, or an array (V,) of them for a batch.

        A trace that is `finished` does not continue, and no verdict is unknown.
        """
        if semantics != "sampled":
            from ..dense.verdicts import dense_verdict

            return dense_verdict(self._formula, positions, signals, semantics, wrap, finished)
        from ..evaluate.verdicts import verdict

        return verdict(self._formula, positions, signals, wrap=wrap, finished=finished)

    def explain(
        self,
        positions: Positions,
        signals: GridsOrSignals,
        *,
        variant: int = 0,
        wrap: float | None = None,
        semantics: Semantics = "sampled",
        finished: bool = False,
    ) -> Explanation:
        """What decides the robustness at the start of one variant, and where the formula fails.

        `finished` is that of `verdict`; the range is over continuations all the same.
        """
        if semantics != "sampled":
            from ..explain.dense_explanation import explain_between_samples

            return explain_between_samples(
                self._formula, positions, signals, semantics,
                variant=variant, wrap=wrap, finished=finished,
            )  # fmt: skip
        from ..explain.explanation import explain

        return explain(
            self._formula, positions, signals, variant=variant, wrap=wrap, finished=finished
        )

    def __str__(self) -> str:
        from .printing import formula_text

        return formula_text(self._formula)

    def to_rtamt(self) -> str:
        """The formula in the syntax of RTAMT; DiagnosticError RL330 for what RTAMT cannot say."""
        from ..formats.rtamt import to_rtamt

        return to_rtamt(self._formula)

    def to_json(self) -> Any:
        """The formula as a JSON value; `roadlang.stl.from_json` reads it back."""
        from ..formats.json_form import to_json

        return to_json(self._formula)
