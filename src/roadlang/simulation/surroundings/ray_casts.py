"""Distances along rays to agents, objects and the ground.

What stands is a box: its footprint, from the ground to its height. Distances are found by slabs
(Kay and Kajiya 1986): a ray is inside a box where it is between all three pairs of its sides. Only
+ - * / abs, min and max of elements besides sines and cosines: an agent gives the same bytes alone
and among others.
"""

from __future__ import annotations

import math
from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...geometry.areas.levels import are_apart
from ...geometry.arrays import Floats, Integers
from ...ir.sensed_batch import CastRays, SolidThings
from ..state.world import World
from ..vehicles.poses import Poses
from .levels import ground_heights, standing_heights
from .outlines import Outlines

_AT_ONCE = 500_000
"""Pairs of a ray and a box that are looked at together."""
_PARALLEL = 1e-300
"""In place of 0, so that a ray along a side divides by a number."""


class RayCaster:
    """Casts rays in a world; what stands still is gathered once."""

    def __init__(self, world: World) -> None:
        self._slots = world.slots
        self._heights = np.array(
            [0.0 if actor is None else actor.height for actor in world.actors], dtype=np.float64
        )
        objects = [object_ for scene in world.scenes for object_ in scene.objects]
        counts = np.array([len(scene.objects) for scene in world.scenes], dtype=np.int64)
        self._standing = Outlines.of(objects)
        level = world.heights is None
        self._elevations = np.zeros(0) if level else standing_heights(world.scenes)
        """of what stands, meters; none on level ground"""
        self._headings = np.array([o.heading for o in objects], dtype=np.float64)
        moving = ["" if actor is None else actor.category for actor in world.actors]
        self._categories = np.array([*moving, *(o.category for o in objects)], dtype=object)
        self._object_heights = np.array([o.height for o in objects], dtype=np.float64)
        self._first = np.cumsum(counts) - counts
        self._counts = counts

    def take(self, agents: Integers, slots: int) -> None:
        """From now on the world has these of its agents alone."""
        scenes = agents[::slots] // slots
        self._heights = self._heights[agents]
        self._first, self._counts = self._first[scenes], self._counts[scenes]
        objects = self._categories[len(self._categories) - len(self._headings) :]
        self._categories = np.concatenate([self._categories[agents], objects])

    def of(self, world: World, poses: Poses, rows: Integers) -> CastRays:
        """Rays from some agents."""
        return _Cast(self, world, poses, rows)

    def boxes(self, world: World, poses: Poses) -> tuple[Outlines, Floats]:
        """All agents and then all objects, and their heights."""
        moving, standing = Outlines.moving(world, poses), self._standing
        names = [field.name for field in fields(Outlines)]
        both = (np.concatenate([getattr(moving, n), getattr(standing, n)]) for n in names)
        return Outlines(*both), np.concatenate([self._heights, self._object_heights])

    def things(self, world: World, poses: Poses, rows: Integers) -> SolidThings:
        """What some agents have around them."""
        boxes, heights = self.boxes(world, poses)
        headings = np.concatenate([poses.heading, self._headings])
        place, box = self.candidates(world, poses, rows)
        counts = np.bincount(place, minlength=len(rows))
        there = np.arange(int(counts.max(initial=0))) < counts[:, None]

        def table(column: Any, nothing: Any) -> Any:
            out = np.full(there.shape, nothing, dtype=column.dtype)
            out[there] = column[box]
            return out

        numbers = (
            boxes.x, boxes.y, headings, 2.0 * boxes.half_length, 2.0 * boxes.half_width, heights
        )  # fmt: skip
        categories = table(self._categories, "")
        return SolidThings(there, categories, *(table(column, 0.0) for column in numbers))

    def candidates(self, world: World, poses: Poses, rows: Integers) -> tuple[Integers, Integers]:
        """Pairs (P,): a place in `rows`, ascending, and a box of the same scene that is there, and
        on no other level."""
        scenes = rows // self._slots
        width = self._slots + int(self._counts.max(initial=0))
        number = np.arange(width)
        box = np.where(
            number < self._slots,
            (scenes * self._slots)[:, None] + number,
            len(self._heights) + self._first[scenes][:, None] + number - self._slots,
        )
        there = number < self._slots + self._counts[scenes][:, None]
        present = np.concatenate([world.present, np.ones(len(self._object_heights), bool)])
        there &= box != rows[:, None]
        there &= present[np.where(there, box, 0)]
        place, column = np.nonzero(there)
        box = box[place, column]
        if world.heights is None:
            return place, box
        height = np.concatenate([ground_heights(world), self._elevations])
        boxes, agent = self.boxes(world, poses)[0], rows[place]
        away = np.hypot(boxes.x[box] - poses.x[agent], boxes.y[box] - poses.y[agent])
        seen = ~are_apart(height[box], height[agent], away)
        return place[seen], box[seen]


class _Cast:
    def __init__(self, caster: RayCaster, world: World, poses: Poses, rows: Integers) -> None:
        self._caster, self._world, self._poses, self._rows = caster, world, poses, rows

    def __call__(
        self, at: ArrayLike, angles: ArrayLike, elevations: ArrayLike, range: ArrayLike
    ) -> Floats:
        rows, poses = self._rows, self._poses
        count = len(rows)
        heading = poses.heading[rows]
        ahead, left, up = np.broadcast_to(np.asarray(at, dtype=np.float64), (count, 3)).T
        cosine, sine = np.cos(heading), np.sin(heading)
        origin = (
            poses.x[rows] + cosine * ahead - sine * left,
            poses.y[rows] + sine * ahead + cosine * left,
            up,
        )
        reach = np.broadcast_to(np.asarray(range, dtype=np.float64), (count,))
        azimuth = heading[:, None] + np.atleast_2d(np.asarray(angles, dtype=np.float64))
        rise = np.broadcast_to(np.asarray(elevations, dtype=np.float64), azimuth.shape)
        level = np.cos(rise)
        rays = (np.cos(azimuth) * level, np.sin(azimuth) * level, np.sin(rise))
        falling = rays[2] < 0.0
        out = np.where(falling, up[:, None] / np.where(falling, -rays[2], 1.0), math.inf)
        self._meet_boxes(out, origin, rays, reach)
        return np.where(out <= reach[:, None], out, math.inf)

    def _meet_boxes(
        self, out: Floats, origin: tuple[Floats, ...], rays: tuple[Floats, ...], reach: Floats
    ) -> None:
        """Shorten the rays that end at a box."""
        boxes, heights = self._caster.boxes(self._world, self._poses)
        place, box = self._caster.candidates(self._world, self._poses, self._rows)
        off_x, off_y = boxes.x[box] - origin[0][place], boxes.y[box] - origin[1][place]
        near = reach[place] + boxes.half_length[box] + boxes.half_width[box]
        close = off_x * off_x + off_y * off_y <= near * near
        place, box = place[close], box[close]
        at_once = max(1, _AT_ONCE // out.shape[1])
        starts = np.arange(0, len(place), at_once)
        for start in starts:
            part = slice(start, start + at_once)
            chosen, solid = place[part], boxes.take(box[part])
            found = _distances(
                tuple(value[chosen] for value in origin),
                tuple(value[chosen] for value in rays), solid, heights[box[part]],
            )  # fmt: skip
            firsts = np.flatnonzero(np.diff(chosen, prepend=-1))
            nearest = np.minimum.reduceat(found, firsts, axis=0)
            out[chosen[firsts]] = np.minimum(out[chosen[firsts]], nearest)


def _distances(
    origin: tuple[Floats, ...], rays: tuple[Floats, ...], boxes: Outlines, heights: Floats
) -> Floats:
    """(P, R) of pairs of an origin with its rays and a box; infinite where a ray passes it."""
    x, y = origin[0] - boxes.x, origin[1] - boxes.y
    cosine, sine = boxes.cosine, boxes.sine
    c, s = cosine[:, None], sine[:, None]
    half_height = 0.5 * heights
    slabs = (
        (cosine * x + sine * y, c * rays[0] + s * rays[1], boxes.half_length),
        (cosine * y - sine * x, c * rays[1] - s * rays[0], boxes.half_width),
        (origin[2] - half_height, rays[2], half_height),
    )
    enter: Any = 0.0
    leave: Any = math.inf
    for start, slope, half in slabs:
        safe = np.where(slope == 0.0, _PARALLEL, slope)
        first = (-half - start)[:, None] / safe
        second = (half - start)[:, None] / safe
        enter = np.maximum(enter, np.minimum(first, second))
        leave = np.minimum(leave, np.maximum(first, second))
    return np.where(enter <= leave, enter, math.inf)
