"""What agents that leave their lines would touch on the way that they are about to go.

`Obstacles` looks along lines that stay where they are. Who pulls out, or comes back, follows a line
that moves, and from close behind something none at all: here its footprint is put on that way, and
compared with those of objects.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ..state.world import World
from ..vehicles.poses import Poses
from .first_contacts import first_contact
from .levels import apart_at, ground_heights, standing_heights
from .outlines import Outlines

SPACING, BEHIND, REACH = 0.5, 6.0, 16.0
"""Meters from one place of the footprint to the next, and how far back and ahead of an agent its
way is looked at."""
BESIDE, BEFORE = 0.12, 0.1
"""Meters by which the footprint is taken to be larger: to each side, and at each end."""
SETTLED = 8.0
"""Meters after which an agent that is off its line is back on it."""
NEAR = 1.0
"""Meters ahead that count for who creeps, beside those in which it stops with 3 m/s^2."""
CREEPING = 3.0

Path = Callable[[Floats], tuple[Floats, Floats]]
"""(K, R) x and y of the lines to follow, distances (K,) on."""


def touches_ahead(
    world: World, poses: Poses, rows: Integers, path: Path, creeps: Booleans,
    standing: Booleans | None = None,
) -> Floats:  # fmt: skip
    """(R,) meters until agents would touch an object, or an agent that is `standing` (N,), on the
    ways that they are about to go, infinite for none. Those that creep go on as they steer now,
    others along their lines."""
    out = np.full(len(rows), math.inf)
    things = _Things.of(world, poses, rows, standing)
    outlines = things.outlines
    agent, thing = np.nonzero(_are_near(world, poses, rows, things))
    if not len(agent):
        return out
    distance: Floats = np.arange(0.0, REACH + SPACING, SPACING, dtype=np.float64)
    x, y, heading = _places(world, poses, rows, path, distance)
    bent = _arcs(world, poses, rows, distance)
    x, y, heading = (
        np.where(creeps, arc, along) for arc, along in zip(bent, (x, y, heading), strict=True)
    )
    speed = world.motion.speed[rows]
    last = np.where(creeps, NEAR + speed * speed / (2.0 * CREEPING), REACH)
    places = len(distance)
    pair = np.tile(np.arange(len(agent)), places)
    at = np.repeat(np.arange(places), len(agent)), agent[pair]
    who = rows[at[1]]
    body = Outlines(
        x[at], y[at], np.cos(heading[at]), np.sin(heading[at]),
        0.5 * world.bodies.length[who] + BEFORE, 0.5 * world.bodies.width[who] + BESIDE,
    )  # fmt: skip
    still = np.zeros(len(pair))
    touch = first_contact(body, outlines.take(thing[pair]), (still, still)) == 0.0
    touch &= distance[at[0]] <= last[at[1]]
    np.minimum.at(out, at[1][touch], distance[at[0]][touch])
    return out


@dataclass(frozen=True)
class _Things:
    """What stands (O,): where, in which scenes, at which heights, and as which agents, -1 for
    objects."""

    outlines: Outlines
    scene: Integers
    height: Floats
    agent: Integers

    @classmethod
    def of(cls, world: World, poses: Poses, rows: Integers, standing: Booleans | None) -> _Things:
        """In the scenes of agents `rows`."""
        scenes = np.unique(rows // world.slots).tolist()
        actors = [actor for number in scenes for actor in world.scenes[number].objects]
        scene = np.repeat(scenes, [len(world.scenes[number].objects) for number in scenes])
        heights = np.full(len(actors), math.nan)
        if world.heights is not None:
            heights = standing_heights([world.scenes[number] for number in scenes])
        outlines, none = Outlines.of(actors), np.full(len(actors), -1)
        if standing is None:
            return cls(outlines, scene, heights, none)
        agents = np.flatnonzero(standing)
        both = zip(
            outlines.columns, Outlines.moving(world, poses).take(agents).columns, strict=True
        )
        return cls(
            Outlines(*(np.concatenate(pair) for pair in both)),
            np.concatenate([scene, agents // world.slots]),
            np.concatenate([heights, ground_heights(world)[agents]]),
            np.concatenate([none, agents]),
        )


def _are_near(world: World, poses: Poses, rows: Integers, things: _Things) -> Booleans:
    """(R, O) which agents may touch which things: of the same scene and level, and not too far."""
    outlines = things.outlines
    radius = np.hypot(outlines.half_length, outlines.half_width)
    own = np.hypot(world.bodies.length[rows], world.bodies.width[rows])
    away = np.hypot(outlines.x - poses.x[rows, None], outlines.y - poses.y[rows, None])
    near = away < radius + 0.5 * own[:, None] + REACH
    near &= ((rows // world.slots)[:, None] == things.scene) & (rows[:, None] != things.agent)
    if world.heights is not None and near.any():
        agent, thing = np.nonzero(near)
        along = world.motion.along[rows[agent]]
        near[agent, thing] = ~apart_at(world, rows[agent], along, things.height[thing])
    return np.asarray(near)


def _places(
    world: World, poses: Poses, rows: Integers, path: Path, distance: Floats
) -> tuple[Floats, Floats, Floats]:
    """(K, R) x, y and headings along the lines: the middle is on the line, and so is the rear axle.
    Who is off its line comes back to it."""
    behind = round(BEHIND / SPACING)
    ahead: Floats = np.arange(-behind, len(distance), dtype=np.float64) * SPACING
    x, y = path(ahead)
    back = np.maximum(np.round(world.bodies.half_base[rows] / SPACING), 1.0).astype(np.int64)
    middle = np.arange(behind, len(x))[:, None]
    axle = middle - np.minimum(back, behind)
    each = np.arange(len(rows))
    heading = np.arctan2(y[middle, each] - y[axle, each], x[middle, each] - x[axle, each])
    x, y = x[behind:], y[behind:]
    share = np.maximum(1.0 - distance / SETTLED, 0.0)[:, None]
    turned = poses.heading[rows] - heading[0]
    turned = turned - np.round(turned / math.tau) * math.tau
    return (
        x + share * (poses.x[rows] - x[0]),
        y + share * (poses.y[rows] - y[0]),
        heading + share * turned,
    )


def _arcs(
    world: World, poses: Poses, rows: Integers, distance: Floats
) -> tuple[Floats, Floats, Floats]:
    """(K, R) the same along the arcs that they steer now."""
    base = world.bodies.half_base[rows]
    bend = world.motion.tangent[rows] / world.bodies.wheelbase[rows]
    heading = poses.heading[rows]
    turned = distance[:, None] * bend
    chord = distance[:, None] * np.sinc(0.5 * turned / math.pi)
    toward, later = heading + 0.5 * turned, heading + turned
    x = poses.x[rows] + base * (np.cos(later) - np.cos(heading)) + chord * np.cos(toward)
    y = poses.y[rows] + base * (np.sin(later) - np.sin(heading)) + chord * np.sin(toward)
    return x, y, later
