"""Which of many candidates are evaluated together: those that should add most to what is known."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .failure_model import Prediction, squares_apart

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Integers = NDArray[np.int64]

_FAILS_BELOW = -0.05
"""The value between those of failures and of safe candidates."""
_DISTINCT, _STEP = 1.1, 0.75
"""How far from others a failure should be to be a new one (further than 1 is distinct), and to be a
step on the way to one."""
_STEP_WORTH = 0.3
"""What such a step is worth, in distinct failures."""
_ERROR = 0.15
"""Standard deviation of distances of descriptors."""
_ALMOST_1 = 0.999
_SHORTLIST = 6
"""Candidates looked at more closely for each that is chosen."""


class Unlike:
    """Log-probabilities (n,) that candidates, should they fail, are new: unlike the distinct
    failures, and far enough from all failures to be a step."""

    def __init__(self, new: Floats, step: Floats) -> None:
        self._new, self._step = new, step

    @classmethod
    def of(cls, candidates: Floats, distinct: Floats, failures: Floats) -> Unlike:
        """By descriptors: (n, D) of candidates, (m, D) of failures, maybe none."""
        import numpy as np
        from scipy.special import log_ndtr

        if not len(distinct):
            return cls(np.zeros(len(candidates)), np.zeros(len(candidates)))
        to_distinct, to_any = (
            np.sqrt(squares_apart(candidates, known).min(axis=1)) for known in (distinct, failures)
        )
        new = log_ndtr((to_distinct - _DISTINCT) / _ERROR)
        return cls(new, log_ndtr((to_any - _STEP) / _ERROR))

    @property
    def parts(self) -> tuple[Floats, Floats]:
        """Of being a distinct failure, and of being a step."""
        return self._new, self._step

    @property
    def worth(self) -> Floats:
        """(n,) logarithms of what the failures would be worth."""
        import numpy as np

        return np.asarray(np.logaddexp(self._new, np.log(_STEP_WORTH) + self._step))

    def rows(self, rows: Integers) -> Unlike:
        """The same of some of the candidates."""
        return Unlike(self._new[rows], self._step[rows])

    def beside(self, distances: Floats, probability: float) -> Unlike:
        """The same where a candidate that fails with this probability is at these distances."""
        import numpy as np
        from scipy.special import ndtr

        new, step = (
            part + np.log1p(-_ALMOST_1 * probability * ndtr((level - distances) / _ERROR))
            for part, level in ((self._new, _DISTINCT), (self._step, _STEP))
        )
        return Unlike(new, step)


def shortlist(prediction: Prediction, unlike: Unlike, count: int) -> Integers:
    """The rows of the candidates from which `count` are chosen: those that are likely to be
    distinct failures, and as many that are likely to be steps."""
    import numpy as np

    fails = _log_probability(prediction.mean, prediction.variance)
    most = _SHORTLIST * count // 2
    best = [np.argsort(-(fails + part), kind="stable")[:most] for part in unlike.parts]
    return np.unique(np.concatenate(best))


def chosen(prediction: Prediction, descriptors: Floats, unlike: Unlike, count: int) -> list[int]:
    """The rows of at most `count` candidates, one after the other that from which most distinct
    failures are expected. The variance of others shrinks with each (Desautels, Krause and Burdick
    2014: GP-BUCB), and what is like it is worth less."""
    import numpy as np

    mean, covariance = prediction.mean, prediction.covariance
    variance = prediction.variance
    least = prediction.least_variance
    barred = np.zeros(len(mean))
    factors = np.zeros((min(count, len(mean)), len(mean)))
    rows: list[int] = []
    for number in range(len(factors)):
        fails = _log_probability(mean, np.maximum(variance, least))
        best = int((fails + unlike.worth + barred).argmax())
        rows.append(best)
        barred[best] = -np.inf
        row = covariance[best] - factors[:number, best] @ factors[:number]
        factors[number] = row / np.sqrt(max(variance[best], least) + prediction.noise)
        variance = variance - factors[number] ** 2
        gaps = descriptors - descriptors[best]
        distances = np.sqrt((gaps * gaps).sum(axis=1))
        unlike = unlike.beside(distances, float(np.exp(fails[best])))
    return rows


def _log_probability(mean: Floats, variance: Floats) -> Floats:
    """(n,) logarithms of the probabilities of failing."""
    import numpy as np
    from scipy.special import log_ndtr

    return np.asarray(log_ndtr((_FAILS_BELOW - mean) / np.sqrt(variance)))
