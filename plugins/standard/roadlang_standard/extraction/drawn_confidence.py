"""How sure the roads of a drawing are: what is drawn is there, but it may be letters or blots."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from roadlang.geometry import Floats

from .found_network import FoundNetwork, FoundRoad

_LONG, _SLENDER = 0.6, 3.0
"""Roads that hang together are believed if they are so long in all, in shorter sides of the
picture, and each so long in widths; the confidence of less is lowered in proportion."""
_MANY, _MOSTLY = 6, 0.7
"""So many parts that hang together are words unless at least this share of their length is in long
ones; the confidence of all is lowered in proportion, and leaving the picture excuses none."""
_RIM = 3.0
"""Pixels from the border at which a road leaves the picture: how long it is there is unknown."""


def with_doubts(found: FoundNetwork) -> FoundNetwork:
    """The same roads, those less sure that are short, alone, or hardly longer than wide."""
    side = min(found.mask.shape)
    factors: dict[int, float] = {}
    parts = connected_parts(found.roads)
    mostly = _share_in_long(parts, _LONG * side) if len(parts) >= _MANY else 1.0
    words = mostly < _MOSTLY
    for part in parts:
        lengths = np.array([road.length for road in part])
        widths = np.array([float(np.median(road.widths)) for road in part])
        total = max(float(lengths.sum()), 1e-9)
        slender = float((lengths**2).sum() / max(float(lengths @ widths), 1e-9))
        leaves = not words and any(_at_rim(road, found.mask.shape) for road in part)
        factor = min(1.0, slender / _SLENDER) * (1.0 if leaves else min(1.0, total / side / _LONG))
        factor *= min(1.0, mostly / _MOSTLY)
        factors.update((id(road), factor) for road in part)
    roads = tuple(road.less_sure(factors[id(road)]) for road in found.roads)
    return replace(found, roads=roads)


def _share_in_long(parts: list[list[FoundRoad]], least: float) -> float:
    """The share of the length that is in parts of at least so many pixels."""
    lengths = np.array([sum(road.length for road in part) for part in parts])
    return float(lengths[lengths >= least].sum() / max(float(lengths.sum()), 1e-9))


def connected_parts(roads: tuple[FoundRoad, ...]) -> list[list[FoundRoad]]:
    """The roads by the connected part of the network that they belong to."""
    starts, ends = ([getattr(road, end) for road in roads] for end in ("start", "end"))
    count = 1 + max([*starts, *ends], default=0)
    links = coo_array((np.ones(len(roads)), (starts, ends)), shape=(count, count))
    number, part = connected_components(links, directed=False)
    found: list[list[FoundRoad]] = [[] for _ in range(number)]
    for road in roads:
        found[part[road.start]].append(road)
    return [members for members in found if members]


def _at_rim(road: FoundRoad, shape: tuple[int, ...]) -> bool:
    """Whether a road has an end, less half its width, at the border of the picture (h, w)."""
    near = _RIM + 0.5 * float(np.median(road.widths))
    ends: Floats = road.points[[0, -1]]
    far = np.array(shape[::-1]) - 1 - near
    return bool(((ends <= near) | (ends >= far)).any())
