"""Some steps of a world as a tape: the engine goes through them once with traced columns."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from ...geometry.arrays import Floats
from ...plugins.kinds import Controller
from ..controlling.driving import DriverGroup
from ..observing.observing import View
from ..shallow_copies import shallow
from ..signals.columns import COLUMNS
from ..signals.derived_columns import KEPT
from ..state.world import World
from ..vehicles.bodies import Bodies
from ..vehicles.motion import MOTION_COLUMNS, Motion, Track
from ..vehicles.poses import Poses
from . import operations as do
from .carrying import RepeatedProgram, repeated_program
from .tape import NotElementwiseError, Tape
from .traced import TracedColumn, value_of

STATE = (*MOTION_COLUMNS, "traveled", "present")
"""The columns of a world that change from one step to the next."""
LONGEST = 12
"""Decisions on a tape, at most."""


class TracedMotion(Motion):
    """The motion of agents, as traced columns."""

    def put(self, rows: Any, other: Motion) -> None:
        """The agents `rows`, truth values, move as they do in `other`."""
        for name in MOTION_COLUMNS:
            setattr(self, name, np.where(rows, getattr(other, name), getattr(self, name)))


class _AnyTime:
    """The number of a step on a tape, which is not known."""

    def __add__(self, _: int) -> _AnyTime:
        return self

    def __mul__(self, _: float) -> _AnyTime:
        raise NotElementwiseError("the time in a computation of columns")

    __sub__ = __mul__


def period(held: int, sampled: int) -> int:
    """Steps after which decisions and samples fall together again."""
    return math.lcm(held, sampled)


def traced_steps(
    world: World, drivers: DriverGroup, controller: Controller, held: int, sampled: int
) -> RepeatedProgram:
    """One period of a world in which nobody meets anybody, from a step that has a decision and was
    sampled. Raises NotElementwiseError where its columns alone do not say what happens."""
    if math.lcm(held, sampled) > LONGEST * held or not _is_calm(world):
        raise NotElementwiseError("more happens than the motion of each agent by itself")
    tape = Tape(len(world.present), len(STATE))
    one = _traced_world(world, tape)
    for start in range(0, period(held, sampled), held):
        controls = _decided(tape, controller, drivers.view(one, one.poses))
        stops = range(sampled - start % sampled, held, sampled)
        for between in one.step(*controls, None, held, stops):
            _record(tape, between, between.poses)
        if (start + held) % sampled == 0:
            _record(tape, one, one.poses)
    columns = [*(getattr(one.motion, name) for name in MOTION_COLUMNS), one.traveled, one.present]
    return repeated_program(tape, [value_of(tape, column) for column in (*columns, *one.pace)])


def _decided(tape: Tape, controller: Controller, view: View) -> tuple[Floats, Floats]:
    """Steering and acceleration, which are finite, or the tape ends."""
    tape.takes_every_way = False
    found = controller.controls(view.of(np.arange(tape.agents)), None)
    tape.takes_every_way = True
    others = found.heading, found.line_offset, found.pose, found.acceleration_limit, found.failures
    if any(column is not None for column in others):
        raise NotElementwiseError("a controller decides more than to steer and accelerate")
    for column in (found.steering, found.acceleration):
        tape.put(do.FINITE, [value_of(tape, column)], gives=0)
    return found.steering, found.acceleration


def _is_calm(world: World) -> bool:
    followed = world.followed
    return (
        world.stop_lines.is_empty
        and world.heights is None
        and world.placing is None
        and not followed.guided
        and not followed.lateral.moves
        and not world.has_route.any()
    )


def _traced_world(world: World, tape: Tape) -> World:
    one = shallow(world)
    columns = [TracedColumn(tape, number, name == "present") for number, name in enumerate(STATE)]
    given: Any = dict(zip(STATE, columns, strict=True))
    one.motion = TracedMotion(**{name: given[name] for name in MOTION_COLUMNS})
    one.traveled, one.present = given["traveled"], given["present"]
    one.any_left, tick = True, _AnyTime()
    verges: Any = world.verges.traced(world.bodies, world.motion, world.table)
    one.verges, one.tick, one.advance = verges, tick, _traced_advance  # type: ignore[assignment]
    return one


def _traced_advance(
    motion: Motion, car: Bodies, track: Track, wanted: tuple[Floats, Floats], steps: int, _: float
) -> None:
    """What `motion.advance` does."""
    tape = motion.along.tape  # type: ignore[attr-defined]
    before = [getattr(motion, name) for name in MOTION_COLUMNS]
    takes: Sequence[Any] = (*before, *car.in_order, *wanted, *track.places)
    found = tape.put(do.MOVE, [value_of(tape, column) for column in takes], 10, steps)
    for name, value in zip(MOTION_COLUMNS, found, strict=True):
        setattr(motion, name, TracedColumn(tape, value))


def _record(tape: Tape, world: World, poses: Poses) -> None:
    columns = [COLUMNS[name](world, poses) for name in KEPT]
    tape.put(do.RECORD, [value_of(tape, column) for column in columns], gives=0)
