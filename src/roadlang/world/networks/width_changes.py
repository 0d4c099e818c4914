"""Stations at which lanes of maps change their width so quickly that even stations miss it."""

from __future__ import annotations

import numpy as np

from ...geometry import CrossSection
from ...geometry.arrays import Floats

_MISSED = 0.01
"""Meters that a border may be elsewhere than straight between stations would have it."""
_APART = 0.02
"""Meters in which a width steps; less would be no gap to take differences over."""
_ROUNDS = 12


def with_width_changes(stations: Floats, section: CrossSection) -> Floats:
    """(S,) with stations where the borders of lanes bend or step: there they are straight between
    stations only within 1 cm. The ends stay; a station within 2 cm of a new one gives way."""
    own = _steps_apart(section.stations)
    own = own[(own > stations[0] + _APART) & (own < stations[-1] - _APART)]
    borders = section.border_offsets(own)
    found = stations
    chosen = np.zeros(len(own), dtype=bool)
    for _ in range(_ROUNDS if len(own) else 0):
        shown = [np.interp(own, found, border) for border in section.border_offsets(found)]
        missed = np.where(chosen, 0.0, np.abs(borders - shown).max(axis=0))
        if not (missed > _MISSED).any():
            break
        gaps = np.searchsorted(found, own)
        worst = np.lexsort((-missed, gaps))
        first = worst[np.append(True, np.diff(gaps[worst]) > 0)]
        chosen[first[missed[first] > _MISSED]] = True
        found = _merged(stations, own[chosen])
    return found


def _steps_apart(own: Floats) -> Floats:
    """Stations of one step become two that are `_APART`; all others stay."""
    groups = np.split(own, np.flatnonzero(np.diff(own) > _APART) + 1)
    ends = [
        group
        if len(group) == 1
        else np.mean(group[[0, -1]]) + np.array([-0.5, 0.5]) * max(_APART, np.ptp(group))
        for group in groups
    ]
    return np.concatenate(ends)


def _merged(stations: Floats, new: Floats) -> Floats:
    after = np.searchsorted(new, stations)
    padded = np.concatenate(([-np.inf], new, [np.inf]))
    near = np.minimum(stations - padded[after], padded[after + 1] - stations)
    keep = near >= _APART
    keep[[0, -1]] = True
    return np.union1d(stations[keep], new)
