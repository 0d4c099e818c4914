"""Long vehicles steer around what stands beside a bend where they need more than their width.

Their lines are moved away from objects that only the ground that they cover beside their lines
would touch, by as much as it takes, and back again.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...geometry.arrays import Floats
from ...geometry.curves.bend_room import LONG
from ...ir.scene_actor import SceneActor
from ..bends.leaning import least_radius, moved_line
from ..bends.sweeps import swept_beside
from ..lines.lines import Lines
from ..lines.route_lines import RouteLine, eased
from ..surroundings.obstacles import MARGIN, things_beside
from ..surroundings.outlines import Outlines
from ..vehicles.bodies import vehicle_parameters

FARTHEST = 2.5
"""Meters that a line is moved: who would have to go farther stops."""
DEEPEST = 0.3
"""Meters by which a thing may stand in the way of the width of the vehicle alone."""
SPARE = 0.05
"""Meters more than it takes."""
EASED = 12.0
"""Meters before and after in which a line is moved and comes back."""
ROUNDS = 4
"""How often the line is moved: it covers other ground then."""
AVERAGED = 2.5
"""Meters over which the bends of a line are averaged."""
BEFORE = 6.0
"""Meters before a connection from which on the others at a junction have to know of it."""


def kept_clear(line: RouteLine, actor: SceneActor, things: Outlines) -> RouteLine:
    """The line of a long vehicle where only what it covers beside its line would touch some of the
    `things`: around them."""
    if actor.length <= LONG or not len(things.x):
        return line
    for _ in range(ROUNDS):
        left = _shift(line, actor, things)
        if not left.any():
            break
        moved = _moved(line, left, actor)
        if _tightest(moved) > max(_tightest(line), 1.0 / least_radius(actor)):
            break
        line = moved
    return line


def _tightest(line: RouteLine) -> float:
    """The greatest curvature of a line, 1/m, averaged over about `AVERAGED` meters."""
    source = line.source
    even = np.arange(0.0, source.length, AVERAGED)
    heading = np.interp(even, source.s, source.heading)
    return float(np.abs(np.diff(heading)).max(initial=0.0)) / AVERAGED


def _shift(line: RouteLine, actor: SceneActor, things: Outlines) -> Floats:
    """(n,) meters to the left by which the points of the line are moved."""
    source = line.source
    out = np.zeros(len(source.s))
    half_base = 0.5 * vehicle_parameters(actor).wheelbase
    lines = Lines.of([source], 1.0)
    swept = swept_beside(lines, 0, actor.length, actor.width, half_base)
    if swept is None:
        return out
    begin, left, half, _ = things_beside(lines, 0, things)
    spacing = float(lines.spacing[0])
    cell = np.clip(((begin - lines.origin[0]) / spacing).astype(np.int64), 0, int(lines.last[0]))
    beside = np.where(left > 0.0, swept[0, cell], swept[1, cell])
    alone = half + 0.5 * actor.width + MARGIN - np.abs(left)
    needed = alone + beside
    meets = (needed > 0.0) & (needed <= FARTHEST) & (alone <= DEEPEST) & (begin > 0.0)
    if not meets.any():
        return out
    flat = 0.5 * actor.length
    away = np.abs(source.s - begin[meets][:, None])
    share = eased(np.clip((flat + EASED - away) / EASED, 0.0, 1.0))
    moved = share * (needed[meets] + SPARE)[:, None]
    on_left = (left[meets] > 0.0)[:, None]
    to_left = np.where(on_left, 0.0, moved).max(axis=0)
    to_right = np.where(on_left, moved, 0.0).max(axis=0)
    return np.asarray(to_left - to_right)


def _moved(line: RouteLine, left: Floats, actor: SceneActor) -> RouteLine:
    """The line moved to the left by this much; at its junctions, others take the vehicle to be
    wider by as much."""
    s, aside = line.source.s, 0.0
    for leg in line.legs:
        if leg.turn is not None:
            near = s > leg.begin - BEFORE - 0.5 * actor.length
            near &= s < leg.along[-1] + actor.length
            aside = max(aside, float(np.abs(left[near]).max(initial=0.0)))
    return replace(moved_line(line, left), aside=line.aside + aside)
