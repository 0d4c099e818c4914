"""The corner of the box of parameters at which a formula is satisfied most easily."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import product

from .parameters import Parameter

Values = Mapping[str, float]


def corners(parameters: Sequence[Parameter]) -> list[Values]:
    """All ways to give each parameter one of its two bounds."""
    names = [parameter.name for parameter in parameters]
    bounds = product(*((parameter.low, parameter.high) for parameter in parameters))
    return [dict(zip(names, values, strict=True)) for values in bounds]


def loosest_corner(
    parameters: Sequence[Parameter], holding: Sequence[Values], rho: Callable[[Values], float]
) -> Values:
    """Of the corners that are `holding` the one with the greatest robustness `rho`.

    Of `x < c or e < d` robustness does not depend on `d` where `c` is at its loosest: among equals
    each parameter has the bound that is the looser one at most other corners.
    """
    rhos = {tuple(values.values()): rho(values) for values in corners(parameters)}
    gains = [_gain(rhos, place, parameter) for place, parameter in enumerate(parameters)]

    def looseness(values: Values) -> tuple[float, int]:
        agreeing = sum(
            gain if values[parameter.name] == parameter.high else -gain
            for gain, parameter in zip(gains, parameters, strict=True)
        )
        return rhos[tuple(values.values())], agreeing

    return max(holding, key=looseness)


def _gain(rhos: Mapping[tuple[float, ...], float], place: int, parameter: Parameter) -> int:
    """At how many corners the upper bound of a parameter is looser, less those at which the lower
    one is."""
    gain = 0
    for corner, low in rhos.items():
        if corner[place] == parameter.low:
            high = rhos[(*corner[:place], parameter.high, *corner[place + 1 :])]
            gain += (high > low) - (high < low)
    return gain
