"""Phases of signals: groups of connections that may have green together."""

from __future__ import annotations

from itertools import combinations

from ..arrays import wrapped_angle
from ..networks.junction_model import End, Junction
from .axes import OPPOSITE, axis_order, heading_of

_Key = tuple[int, End]


def signal_phases(junction: Junction) -> tuple[tuple[int, ...], ...]:
    """The ids of the connections of each phase; that of the roads that run east and west first.

    Two arms that face each other share a phase, the straightest pair first, every other arm has
    its own. So within a phase the only conflicts are between what comes from opposite arms, where
    who turns across the other yields. The phases of a mirrored drawing with traffic on the other
    side are the mirrored phases.
    """
    sources: dict[_Key, list[int]] = {}
    for connection in junction.connections:
        source = connection.source.edge, connection.source.end
        sources.setdefault(source, []).append(connection.id)
    groups = _groups(junction, sorted(sources))
    return tuple(tuple(sorted(id for key in group for id in sources[key])) for group in groups)


def _groups(junction: Junction, keys: list[_Key]) -> list[tuple[_Key, ...]]:
    """Pairs of arms that face each other, and single ones, in the order of their axes."""
    arms = {(arm.edge, arm.end): arm for arm in junction.arms}
    headings = {key: heading_of(junction, arms[key]) for key in keys}

    def order(group: tuple[_Key, ...]) -> tuple[float, float]:
        return axis_order((headings[key] for key in group), left_hand=junction.left_hand)

    turned = {
        (first, second): abs(wrapped_angle(headings[second] - headings[first]))
        for first, second in combinations(keys, 2)
    }
    facing = [pair for pair, angle in turned.items() if angle > OPPOSITE]
    facing.sort(key=lambda pair: (-round(turned[pair], 6), order(pair), pair))
    groups: list[tuple[_Key, ...]] = []
    left = set(keys)
    for pair in facing:
        if left.issuperset(pair):
            left.difference_update(pair)
            groups.append(pair)
    groups += [(key,) for key in left]
    return sorted(groups, key=lambda group: (order(group), group))
