"""Chains of lines as fair curves: fitted to what was seen, then through the nodes they meet at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from roadlang.geometry import Floats

from ..curves.edges import normals
from ..curves.even_points import even_points, even_points_of
from ..curves.fair_fitting import COVERED, Fit, Layer, Traced, Unfitted, fitted_fairly
from ..curves.fairing import AGAIN, FULLY, ROUGHLY
from ..curves.junction_points import at_stations, extended, foot_station
from ..curves.smoothing import resample, smooth, stations
from ..graphs.chains import LineChain

_FITS = (ROUGHLY, FULLY)
_SHRUNK = 0.75
_FADE = 12.0
"""Pixels over which a curve that is not fair leaves the line to meet a node."""


@dataclass(frozen=True)
class Run:
    """The curve (n, 2) of a chain, a point about each pixel; a closed one repeats its first point.

    It was fitted beside what was `traced`. `reached` are lengths along it of the chain's nodes,
    about; those of a closed run are its parts' starts. A `tiny` ring has no room for the tightest
    bend and stays as it was traced: smoothed, it would shrink to a point.
    """

    chain: LineChain
    curve: Floats
    traced: Traced
    reached: tuple[float, ...] = ()
    tiny: bool = False

    @property
    def nodes(self) -> list[int]:
        """The chain's nodes; of a closed one the first is not repeated."""
        return self.chain.nodes[:-1] if self.chain.closed else self.chain.nodes

    def is_end(self, place: int) -> bool:
        """Whether the run ends at its node of this index."""
        return not self.chain.closed and place in (0, len(self.nodes) - 1)

    def is_fair(self, fit: Fit) -> bool:
        """Whether lines and arcs are sought for its curve."""
        return fit.fair and not self.tiny


def fitted(
    chains: Sequence[LineChain],
    nodes: Mapping[int, Floats],
    free: Sequence[tuple[bool, bool]],
    surface: Layer,
    fit: Fit,
) -> list[Run]:
    """The fair curve of each chain between `nodes`, its ends wherever they fall; `free` ones are
    dead ends."""
    runs = [_rough(*each, nodes, fit) for each in zip(chains, free, strict=True)]
    curves = [run.curve for run in runs]
    fair = [index for index, run in enumerate(runs) if run.is_fair(fit)]
    for pace in _FITS:
        lines = [Unfitted(curves[i], runs[i].traced, runs[i].chain.closed) for i in fair]
        found = fitted_fairly(lines, surface, fit, pace)
        opened = [index for index, line in enumerate(lines) if not line.closed]
        even = even_points_of([found[index] for index in opened], [1.0] * len(opened))
        for index, curve in zip(opened, even, strict=True):
            curves[fair[index]] = curve
        for index, line in enumerate(lines):
            if line.closed:
                curves[fair[index]] = even_points(found[index], True)
    return [_with_curve(*each) for each in zip(runs, curves, strict=True)]


def _has_shrunk(curve: Floats, traced: Floats) -> bool:
    """Whether a ring has lost a good part of its length to its smoothness."""
    return bool(stations(curve)[-1] < _SHRUNK * stations(traced)[-1])


def _rough(chain: LineChain, free: tuple[bool, bool], nodes: Mapping[int, Floats], fit: Fit) -> Run:
    """The chain as it was traced, rid of waves."""
    pieces = [line.points if forward else line.points[::-1] for line, forward in chain.parts]
    traced = resample(np.vstack([pieces[0], *[piece[1:] for piece in pieces[1:]]]))
    inner = [piece[0] for piece in pieces[1:]]
    alone = Traced(traced, np.zeros((0, 2)))
    curve = _without_waves(traced, inner, chain.closed, free, fit)
    if chain.closed and (
        stations(traced)[-1] < 2 * np.pi * fit.tightest or _has_shrunk(curve, traced)
    ):
        return Run(chain, traced, alone, tiny=True)
    if not fit.fair:
        return Run(chain, curve, alone)
    ends = [free[0] and not chain.closed, *[False] * len(inner), free[1] or chain.closed]
    places = [nodes[node] for node, end in zip(chain.nodes, ends, strict=True) if not end]
    junctions = np.array(places).reshape(-1, 2)
    return Run(chain, even_points(curve, chain.closed), Traced(traced, junctions))


def _with_curve(run: Run, curve: Floats) -> Run:
    """The run with another curve, and how far along it the nodes are reached."""
    traced = run.traced.line
    if run.chain.closed and _has_shrunk(curve, traced):
        run, curve = replace(run, tiny=True), traced
    shares = np.cumsum([0.0, *[line.length for line, _ in run.chain.parts]])
    reached = shares / shares[-1] * stations(curve)[-1]
    return replace(run, curve=curve, reached=tuple(reached[:-1] if run.chain.closed else reached))


def _without_waves(
    traced: Floats, inner: list[Floats], closed: bool, free: tuple[bool, bool], fit: Fit
) -> Floats:
    """The traced line smoothed; near junctions it says little."""
    tolerance = max(0.8, 0.1 * fit.width)
    if closed:
        ring = smooth(traced[:-1], fit.waves, tolerance, fit.tightest, closed=True)
        return np.vstack([ring, ring[:1]])
    weights = np.where(fit.is_covered(traced), COVERED, 1.0)
    for place in [traced[0], traced[-1], *inner]:
        near = np.hypot(*(traced - place).T) < 0.6 * fit.width
        if near.sum() < 0.5 * len(traced):
            weights[near] = 0.02
    return smooth(traced, fit.waves, tolerance, fit.tightest, weights, free=free)


def through(
    runs: Sequence[Run],
    placed: dict[int, Floats],
    free: Sequence[tuple[bool, bool]],
    surface: Layer,
    fit: Fit,
) -> list[list[Floats]]:
    """The curve of each run through its nodes where they were `placed`, cut there: a piece each
    part."""
    pinned = [_pinned(*each, placed, fit) for each in zip(runs, free, strict=True)]
    curves = [_faded(line) for line in pinned]
    fair = [index for index, run in enumerate(runs) if run.is_fair(fit)]
    again = fitted_fairly([pinned[index] for index in fair], surface, fit, AGAIN)
    for index, curve in zip(fair, again, strict=True):
        curves[index] = curve
    return [_cut(*each, placed) for each in zip(runs, pinned, curves, strict=True)]


def _pinned(run: Run, free: tuple[bool, bool], placed: dict[int, Floats], fit: Fit) -> Unfitted:
    """The run's curve from its first node to its last, with pins at all of them."""
    places = [placed[node] for node in run.nodes]
    curve, at = _between_ends(run, places, free, fit)
    along = stations(curve)
    index = [int(np.argmin(np.abs(along - station))) for station in at]
    index = _increasing(index, len(curve), run.chain.closed)
    normal = normals(curve, run.chain.closed)
    pins = tuple(
        (i, float((place - curve[i]) @ normal[i])) for i, place in zip(index, places, strict=True)
    )
    return Unfitted(curve, run.traced, run.chain.closed, pins)


def _cut(run: Run, pinned: Unfitted, curve: Floats, placed: dict[int, Floats]) -> list[Floats]:
    """The pieces of a curve between its pins, which are moved to where the nodes were placed."""
    index = [i for i, _ in pinned.pins]
    curve = curve.copy()
    curve[index] = [placed[node] for node in run.nodes]
    if run.chain.closed:
        curve[-1] = curve[0]
        index = [*index, len(curve) - 1]
    return [curve[a : b + 1] for a, b in pairwise(index)]


def _between_ends(
    run: Run, places: list[Floats], free: tuple[bool, bool], fit: Fit
) -> tuple[Floats, list[float]]:
    """The curve from its first node to its last, and the lengths along it of all nodes."""
    if run.chain.closed:
        ring = _rolled(run.curve, foot_station(run.curve, places[0], 0.0, 0.0))
        at = [0.0] + [
            foot_station(ring, place, expected, 0.05)
            for place, expected in zip(places[1:], run.reached[1:], strict=True)
        ]
        return ring, at
    beyond = 1.5 * fit.width + 6
    by = (0.0 if free[0] else beyond, 0.0 if free[1] else beyond)
    longer = extended(run.curve, by)
    added = float(np.ceil(by[0]))
    at = [
        foot_station(longer, place, expected + added, 0.05)
        for place, expected in zip(places, run.reached, strict=True)
    ]
    if at[-1] - at[0] < 2.0:
        straight = np.linspace(places[0], places[-1], max(2, len(places)))
        return straight, list(stations(straight))
    inner = np.linspace(at[0], at[-1], max(len(places), 2, round(at[-1] - at[0]) + 1))
    return at_stations(longer, inner), [station - at[0] for station in at]


def _rolled(ring: Floats, start: float) -> Floats:
    """A closed curve, begun and ended at this length along it."""
    along = stations(ring)
    at = (start + np.linspace(0.0, along[-1], len(ring))) % along[-1]
    at[-1] = at[0]
    return at_stations(ring, at)


def _increasing(index: list[int], count: int, closed: bool) -> list[int]:
    """Indices of nodes made to increase by at least one, from 0, to the last if not closed."""
    inner = index[1:] if closed else index[1:-1]
    for place, i in enumerate(inner):
        before = inner[place - 1] if place else 0
        inner[place] = int(np.clip(i, before + 1, count - 1 - (len(inner) - place)))
    return [0, *inner] if closed else [0, *inner, count - 1]


def _faded(line: Unfitted) -> Floats:
    """The curve moved so that it meets its pins, less and less away from each."""
    offset = np.zeros(len(line.curve))
    for index, value in line.pins:
        fade = np.clip(1 - np.abs(np.arange(len(offset)) - index) / _FADE, 0.0, 1.0)
        offset += value * fade
    return line.curve + offset[:, None] * normals(line.curve, line.closed)
