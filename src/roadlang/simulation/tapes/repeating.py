"""Drives in which nothing happens but the motion of each agent: many steps in one
compiled loop, or by the same calls of numpy for each."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ...geometry.arrays import Floats, Integers
from ..controlling.driving import DriverGroup
from ..recording.recording import Recorder
from ..recycled_memory import RECYCLED
from ..signals.derived_columns import KEPT, DerivedColumns
from ..signals.recorded_samples import RecordedSample
from ..state.arrivals import all_arrived
from ..state.step_times import seconds_at
from ..state.world import World
from ..surroundings.contacts import ContactDetector
from ..vehicles import compiled
from ..vehicles.motion import MOTION_COLUMNS
from . import compiled_tapes
from .carrying import RepeatedProgram
from .numpy_tapes import NumpyTape
from .tape import NotElementwiseError
from .tracing import STATE, period, traced_steps

AT_ONCE = 1.0
"""Seconds that are driven before it is asked which scenes are over."""
LARGE = 2**24
"""Bytes of samples for which memory is asked together, if they are many: then it is in large pages,
and is used again."""


@dataclass
class Repetition:
    """What a world does in one period of its samples and decisions."""

    program: RepeatedProgram
    period: int
    """steps"""
    sampled: int
    is_over: bool = False
    """whether it did not come to its end once: then every step is made by itself"""
    _numpy: tuple[NumpyTape, NumpyTape] | None = None
    _derived: DerivedColumns | None = None
    _free: Floats = field(default_factory=lambda: np.empty((0, 0, 0)))
    """room for samples"""

    @classmethod
    def of(
        cls, world: World, drivers: DriverGroup, contacts: ContactDetector, held: int, sampled: int
    ) -> Repetition | None:
        """None where more happens than the motion of each agent by itself."""
        controller = drivers.elementwise_controller(len(world.present))
        if controller is None or not contacts.is_idle:
            return None
        try:
            program = traced_steps(world, drivers, controller, held, sampled)
        except NotElementwiseError:
            return None
        return cls(program, period(held, sampled), sampled)

    def take(self, agents: Integers) -> None:
        """From now on the world has these of its agents alone."""
        self.program, self._numpy, self._derived = self.program.take(agents), None, None

    def drive(self, world: World, recorder: Recorder, last: int) -> bool:
        """Go on by some periods, to the step `last` at most, and record all samples. False where
        it cannot go on like this now."""
        if self.is_over or world.tick % self.period:
            return False
        seconds = self.period * world.dt
        times = min((last - world.tick) // self.period, max(1, round(AT_ONCE / seconds)))
        if times < 1:
            return False
        went_on, out, samples = self._repeated(world, times)
        if went_on < times:  # a number is infinite: go on until there, where it is said what is
            self.is_over = True
            if not went_on:
                return False
            _, out, samples = self._repeated(world, went_on)
        self._record(world, recorder, samples)
        _go_on(world, out, len(samples) * self.sampled)
        return True

    def _repeated(self, world: World, times: int) -> tuple[int, Floats, Floats]:
        columns = [getattr(world.motion, name) for name in MOTION_COLUMNS]
        state = np.stack([*columns, world.traveled, world.present])
        each = self.period // self.sampled
        first, program = self.program.first, self.program.each
        begin = np.empty((len(first.gives), len(world.present)))
        out = np.empty((len(program.gives), len(world.present)))
        samples = self._room(times * each, len(world.present))
        if world.advance is compiled.advance:
            track = world.track
            lines = track.first, track.lines.table, world.bodies.walks.astype(np.float64)
            loop = compiled_tapes.repeated()
            loop(state, first.arguments, lines, 1, world.dt, samples[:0], begin)
            went_on = loop(begin, program.arguments, lines, times, world.dt, samples, out)
        else:
            walks = world.bodies.walks.astype(np.float64)
            once, tape = self._bound(world)
            once.repeated(state, walks, 1, samples[:0], begin)
            went_on = tape.repeated(begin, walks, times, samples, out)
        return int(went_on), out, samples

    def _room(self, count: int, agents: int) -> Floats:
        """(count, Q, N) for samples."""
        each = 8 * len(KEPT) * agents
        if count * each < LARGE // 8:
            return np.empty((count, len(KEPT), agents))
        if len(self._free) < count or self._free.shape[2] != agents:
            self._free = RECYCLED.empty(max(count, LARGE // each), len(KEPT), agents)
        found, self._free = self._free[:count], self._free[count:]
        return found

    def _bound(self, world: World) -> tuple[NumpyTape, NumpyTape]:
        """The two parts of the program for the agents of the world, without a compiled loop."""
        if self._numpy is None:
            lines, walks = (world.track.lines.table, world.track.first), world.bodies.walks
            any_walks, first = bool(walks.any()), self.program.first
            self._numpy = (
                NumpyTape(first, len(STATE), lines, any_walks, world.dt),
                NumpyTape(self.program.each, len(first.gives), lines, any_walks, world.dt),
            )
        return self._numpy

    def _record(self, world: World, recorder: Recorder, samples: Floats) -> None:
        if self._derived is None:
            self._derived = DerivedColumns.of(world)
        derived = self._derived
        along, traveled = (samples[:, KEPT.index(name)] for name in ("along", "route_progress"))
        arrived = derived.at_end(along, traveled)
        finished = all_arrived(arrived, world.has_road, world.filled, world.slots)
        times = [
            seconds_at(world.tick + number * self.sampled, world.dt)
            for number in range(1, len(samples) + 1)
        ]
        found = [RecordedSample(sample, derived) for sample in samples]
        recorder.add_all(times, found, finished)


def _go_on(world: World, columns: Floats, steps: int) -> None:
    """The world is as `columns` say, some steps on."""
    for name, column in zip(MOTION_COLUMNS, columns, strict=False):
        setattr(world.motion, name, column)
    traveled, present = columns[len(MOTION_COLUMNS) : len(STATE)]
    world.traveled, world.present, world.pace = traveled, present > 0.5, (columns[-2], columns[-1])
    world.any_left = bool((world.filled & ~world.present).any())
    world.tick += steps
