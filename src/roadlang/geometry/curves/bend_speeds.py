"""How fast bends may be approached: the squared speeds from which braking in time suffices.

A bend of curvature k is driven with at most `v^2 = lateral / |k|`; a distance d before it,
`v^2 + 2 braking d` is as good. All speeds are squared, m^2/s^2.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Floats

STRAIGHT = 1e-6
"""1/m: less is no bend."""


def squares_in_bends(curvature: Floats, lateral: Floats | float) -> Floats:
    """The greatest squared speeds at curvatures, 1/m, with a `lateral` acceleration, m/s^2; arrays
    that broadcast together."""
    return np.asarray(lateral / np.maximum(np.abs(curvature), STRAIGHT))


def square_before(limits: Floats, ahead: Floats, braking: float) -> float:
    """The greatest squared speed before bends with `limits` (n,), each so many meters `ahead` (n,);
    infinite where there are none."""
    return float((limits + 2.0 * braking * ahead).min(initial=np.inf))


def squares_before(limits: Floats, gain: Floats) -> Floats:
    """(N, M) the same at every place of N rows of M equal steps. `limits`: (N, M) at the places;
    `gain`: (N,) how much the square may grow for each step backward, `2 braking step`."""
    ramp = gain[:, None] * np.arange(limits.shape[1])
    ahead = np.minimum.accumulate((limits + ramp)[:, ::-1], axis=1)[:, ::-1]
    return np.asarray(ahead - ramp)
