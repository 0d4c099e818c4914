"""Steps in which a decision holds and nothing happens but motion: several in one compiled call.

All that is done in them is done by the loops that do it in single steps elsewhere. Before a step in
which more may happen (somebody may touch another, have a wheel beside the road, or cross a stop
line with a signal) the loop ends, and that step is made as all others are.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from ..geometry.arrays import Booleans, Floats
from .calling.decision import Decision
from .recording.recording import Recorder
from .shallow_copies import shallow
from .state import arrivals, held_controls, settling
from .state.held_controls import loop_over_controls, tangents
from .state.settling import FLAGS, MOTION, ROWS, can_settle, loop_over_moved
from .state.world import World
from .surroundings import quiet_steps
from .surroundings.contacts import ContactDetector
from .surroundings.quiet_steps import are_apart, loop_over_places
from .vehicles import compiled, kernels
from .vehicles.motion import MOTION_COLUMNS

STEPS = 15_000
"""Steps of one agent by this process from which on the loop is used: about a minute of 20 agents.
It takes ten seconds to compile, once after an installation."""
_stepped = [0]


@dataclass(frozen=True)
class StepCounts:
    """Numbers of steps of the vehicles."""

    held: int
    """from one decision to the next"""
    sampled: int
    """from one sample to the next"""


def drive_quietly(
    world: World, decision: Decision, others: tuple[ContactDetector, Recorder], counts: StepCounts,
    times: int,
) -> bool:  # fmt: skip
    """Go on for at most so many times of a decision, and record samples, but for one at the end,
    which is left to be recorded. False where nothing was done: one step is to be made in another
    way."""
    contacts, recorder = others
    known = contacts.can_be_quiet()
    goes_by_road = decision.heading is None and decision.pose is None
    if known is None or not (goes_by_road and can_settle(world) and world.verges.patches.is_empty):
        return False
    _stepped[0] += len(world.present)
    if _stepped[0] <= STEPS:
        return False
    times = 1 if world.followed.lateral.moves else times
    found = _driven(world, decision, known, counts, times)
    if not found.done:
        return False
    begun = world.tick
    for number in range(found.samples):
        between = shallow(world)
        between.motion, between.followed = shallow(world.motion), world.followed.copied()
        tick = (begun // counts.sampled + 1 + number) * counts.sampled
        _put(between, found.sampled[number], found.flagged[number], tick)
        between.followed.advance(found.sampled[number, _SPEED], (tick - begun) * world.dt)
        recorder.record_later(between)
    _put(world, found.rows, found.flags, begun + found.done * counts.held)
    world.any_left = found.any_left
    world.followed.advance(found.rows[_SPEED], counts.held * world.dt)
    contacts.was_quiet(world, found.places, found.ways[: found.done].tolist())
    return True


_SPEED = ROWS - 1


@dataclass
class _Driven:
    """What the loop fills: (ROWS, N) and (FLAGS, N) at the end, and (K, ...) the same at each
    sample; (2, N) places, and (T,) ways."""

    rows: Floats
    flags: Booleans
    sampled: Floats
    flagged: Booleans
    places: Floats
    ways: Floats
    done: int = 0
    """how many times a decision has held"""
    samples: int = 0
    any_left: bool = False


def _driven(
    world: World, decision: Decision, known: tuple[Any, Any, Any], counts: StepCounts, times: int
) -> _Driven:
    (places, pairs, radius), bodies, track = known, world.bodies, world.track
    count, samples = len(world.present), times * counts.held // counts.sampled + 1
    out = _Driven(
        np.empty((ROWS, count)), np.empty((FLAGS, count), dtype=bool),
        np.empty((samples, ROWS, count)), np.empty((samples, FLAGS, count), dtype=bool),
        np.empty((2, count)), np.empty(times),
    )  # fmt: skip
    sides = 0.5 * bodies.length, 0.5 * bodies.width
    out.done, out.samples, out.any_left = _loop()(
        (world.motion.columns, world.traveled, world.at_end, world.present),
        (bodies.stacked, bodies.walks, tangents(bodies, decision.steering), decision.acceleration),
        (track.first, track.places, track.lines.table),
        ((decision.steering, (bodies.least_steering, bodies.max_steering, bodies.half_base)),
         world.verges.clear, world.halted),
        (world.filled, world.has_road, world.end, bodies.length, world.stop_lines.along),
        (places, (pairs, radius, *sides)),
        (world.any_left, world.tick, counts.held, counts.sampled, times, world.dt),
        (out.rows, out.flags, out.sampled, out.flagged, out.places, out.ways),
    )  # fmt: skip
    return out


def _put(world: World, rows: Floats, flags: Booleans, tick: int) -> None:
    """Agents are as the loop says, at a time."""
    motion = world.motion
    for name, row in zip(MOTION_COLUMNS, rows, strict=False):
        setattr(motion, name, row)
    along, left, world.traveled = rows[MOTION : MOTION + 3]
    at_end, _, world.present = flags
    world.pace, world.tick = (along, left), tick
    world.arrived = motion.along, world.traveled, at_end


def loop_over_steps(
    begun: Any, wanted: Any, track: Any, wishes: Any, agents: Any, contact: Any, clock: Any,
    out: Any,
) -> Any:  # fmt: skip
    """How many times the decision has held, how many samples were taken, and whether anybody has
    left; fill `out`, the members of `_Driven`. numba compiles it; Python never runs it."""
    halted, count = wishes[2], wanted[1].shape[0]
    any_left, tick, held, sampled, times, dt = clock
    rows, flags, samples, sample_flags, found, ways = out
    then, flags_then, control = np.empty_like(rows), np.empty_like(flags), np.empty((2, count))
    there = np.empty((2, count))
    begin(begun, rows, flags)
    fill(found, contact[0])
    done, taken = 0, 0
    while done < times:
        at, new = tick + done * held, taken
        if done > 0 and at % sampled == 0:
            fill(samples[new], rows)
            fill(sample_flags[new], flags)
            new += 1
        if loop_over_controls(
            (wishes[0][0], wanted[3]), wishes[0][1], (rows[1], rows[6], wishes[1]),
            (flags[0], halted), control,
        ):  # fmt: skip
            break
        crosses, has_left, new = move(
            (rows, flags), (*wanted[:3], control[1]), track, agents, (at, held, sampled, dt),
            any_left, (samples, sample_flags, new), (then, flags_then),
        )  # fmt: skip
        if crosses:
            break
        way = loop_over_places(
            (then[0], then[1], then[8], then[5], then[6]), track, found, contact[1],
            (flags_then[2], halted), there,
        )  # fmt: skip
        if way < 0.0:
            break
        ways[done], any_left, taken = way, has_left, new
        fill(rows, then)
        fill(flags, flags_then)
        fill(found, there)
        done += 1
    return done, taken, any_left


def move(
    before: Any, wanted: Any, track: Any, agents: Any, clock: Any, any_left: Any, sampling: Any,
    then: Any,
) -> Any:  # fmt: skip
    """Move on for as long as a decision holds, and fill `then`. Whether anybody crosses a stop
    line, whether anybody has left, and how many samples were taken."""
    (rows, flags), (car, walks, tangent, acceleration) = before, wanted
    (first, places, table), (filled, has_road, end, length, stops) = track, agents
    (begun, held, sampled, dt), (samples, sample_flags, taken) = clock, sampling
    who, lines = (filled, flags[2], has_road), (end, rows[MOTION + 2], length, stops)
    source, at, crosses = columns(rows), begun, False
    after = np.empty((MOTION, walks.shape[0]))
    while True:
        stop = min((at // sampled + 1) * sampled, begun + held)
        kernels.advanced(
            (source, after), car, walks, (tangent, acceleration), (first, places), table,
            stop - at, dt,
        )  # fmt: skip
        at, source = stop, columns(after)
        is_last = at == begun + held
        crossed, has_left = loop_over_moved(
            columns(rows), source, who, lines, any_left, (at - begun) * dt,
            then[0] if is_last else samples[taken], then[1] if is_last else sample_flags[taken],
        )  # fmt: skip
        crosses = crosses or crossed
        if is_last:
            return crosses, has_left, taken
        taken += 1


def begin(begun: Any, rows: Any, flags: Any) -> None:
    """Agents are as they are at the beginning."""
    motion, traveled, at_end, present = begun
    for i in range(rows.shape[1]):
        for k in range(MOTION):
            rows[k, i] = motion[k][i]
        rows[MOTION + 2, i], flags[0, i], flags[2, i] = traveled[i], at_end[i], present[i]


def fill(into: Any, values: Any) -> None:
    """Fill an array of two axes with another; numba compiles this in less time than a slice."""
    for k in range(into.shape[0]):
        for i in range(into.shape[1]):
            into[k, i] = values[k, i]


def columns(rows: Any) -> Any:
    """Those of a motion."""
    return (
        rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7], rows[8], rows[9],
    )  # fmt: skip


@cache
def _loop() -> Any:
    loops = (
        loop_over_controls,
        loop_over_moved,
        loop_over_places,
        are_apart,
        columns,
        move,
        fill,
        begin,
    )
    compiled.register((), (*loops, loop_over_steps))
    said = sys.modules[__name__], arrivals, held_controls, settling, quiet_steps
    return compiled.compile_loop(loop_over_steps, *said)
