"""The controllers of all agents of a world, called in batches at every step."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np

from ...diagnostics import Span
from ...geometry.arrays import Booleans, Integers, inverse_index
from ...ir.control import ControlBatch
from ...plugins.kinds import Controller
from ...plugins.registry import KindEntry
from ..building.carried_state import Continued
from ..calling.controllers import Driver
from ..calling.decision import Decision
from ..observing.observing import View
from ..observing.sensing import Sensing
from ..observing.surroundings import Surroundings
from ..signals.triggers import PlacedCall, Triggers
from ..state.step_times import seconds_at
from ..state.world import World
from ..vehicles.line_steering import line_steering
from ..vehicles.poses import Poses
from .actuators import Actuators
from .controller_groups import Group, elementwise_controller, grouped
from .deciding import Lasting, decided


class DriverGroup:
    """What drives the agents of a world. `controllers`: of each scene, by agent."""

    def __init__(
        self,
        world: World,
        controllers: Sequence[Mapping[str, Controller]],
        step: float,
    ) -> None:
        self._step = step
        self._surroundings = Surroundings(world)
        self._slots = world.slots
        self.sensing = Sensing.of(world, controllers, step)
        layouts = {} if self.sensing is None else self.sensing.layouts
        self._groups, calls = grouped(world, controllers, layouts)
        faults = [group for group in self._groups if group.controller.alters]
        self._actuators = Actuators(faults, step)
        placed = [(group.place, group.rows) for group in faults]
        spans = _spans_of(world, controllers, calls)
        self._triggers = Triggers(world, calls, signals_of(controllers), placed, spans)
        self._in_charge = np.zeros(0, dtype=np.int64)
        self._chosen: list[tuple[Group, Integers, Integers]] = []
        """groups, and who of each is in charge, in its order and in that of the world, by the last
        `in_charge`"""
        self._open = Decision.open(self._in_charge >= 0)
        """what is decided before any controller is called, by the last `in_charge`"""
        self._held: Decision | None = None
        """the last decision, if it is the same until a controller decides anew"""
        self._lasting: list[Lasting] = []
        """for how long, by groups"""

    def view(self, world: World, poses: Poses) -> View:
        """What the agents see, with what they sensed last."""
        return View(world, poses, self._step, self._surroundings, self.sensing)

    def sense(self, world: World, poses: Poses) -> None:
        """Measure what is due, unless that has been done at this time."""
        if self.sensing is not None:
            self.sensing.sense(self.truth(world, poses))

    def truth(self, world: World, poses: Poses) -> View:
        """What sensors measure."""
        return View(world, poses, self._step, self._surroundings)

    def held(self, world: World) -> Decision | None:
        """What was decided, where it still holds and nothing has to be looked at to know that."""
        looks = self.sensing is not None or not self._triggers.is_empty
        if looks or any(each.is_over(world.time) for each in self._lasting):
            return None
        return self._held

    def holds(self, world: World, held: int, most: int) -> int:
        """For how many times `held` steps the last decision holds, from now on: at most so many,
        and no more than one where it may change before a controller decides anew."""
        times = min(most, 1)
        if self._held is None or self.sensing is not None or not self._triggers.is_empty:
            return times
        while times < most and not any(
            each.is_over(seconds_at(world.tick + times * held, world.dt)) for each in self._lasting
        ):
            times += 1
        return times

    def decide(self, world: World, poses: Poses) -> Decision:
        """What all agents are to do until the next step. Moves the lines that they follow."""
        self.sense(world, poses)
        in_charge = self._triggers.in_charge(world, poses)
        if in_charge is not self._in_charge:
            self._in_charge = in_charge
            self._chosen = _in_charge_of(self._groups, in_charge)
            self._open = Decision.open(in_charge >= 0)
            self._held = None
        if self._held is not None and not any(each.is_over(world.time) for each in self._lasting):
            return self._held.copy()
        view = self.view(world, poses)
        out = self._open.copy()
        moved: list[Integers] = []
        for group, chosen, rows in self._chosen:
            found = decided(group, chosen, view)
            out.put(rows, found)
            if found.line_offset is not None:
                moved.append(rows)
                _move_lines(view, rows, found)
        if out.has_open:
            own_line = np.ones(len(in_charge), dtype=bool)
            for rows in moved:
                own_line[rows] = False
            self._ask_earlier(world, in_charge, own_line, view, out)
            _keep_to_lines(world, view, out)
            out.close()
        elif not moved and out.is_plain and self._all_hold:
            self._held = out.copy()
            self._lasting = [Lasting.of(*each[:2], world.dt) for each in self._chosen]
        self._actuators.alter(world, self._triggers.active, out)
        return out

    @property
    def _all_hold(self) -> bool:
        """Whether all that decide do so from time to time, and nothing changes it in between."""
        kinds = [(group.controller.kind.interval, group.singles) for group, *_ in self._chosen]
        hold = all(interval > self._step and not singles for interval, singles in kinds)
        return hold and not self._actuators.faults

    def elementwise_controller(self, agents: int) -> Controller | None:
        """The controller of all, where nothing else decides: no condition, sensor or fault."""
        if self.sensing is not None or not self._triggers.is_empty:
            return None
        return elementwise_controller(self._groups, agents)

    def restart(self, agents: Integers) -> None:
        """Some agents are back at the start. Conditions are not: none of theirs may have any."""
        self._held = None
        for group in self._groups:
            group.restart(agents)
        if self.sensing is not None:
            self.sensing.restart(agents)

    def carry_on(self, before: DriverGroup, rows: Continued, same_network: bool) -> None:
        """Controllers and conditions of the agents that go on after an edit remember what they did
        before it. Of several of a kind, the first goes on as the first."""
        self._held = None
        column = dict(zip(rows.after.tolist(), rows.before.tolist(), strict=True))
        known = before._members()
        places: dict[tuple[int, int], tuple[int, int]] = {}
        for (row, kind, number), (group, agent) in self._members().items():
            key = (column.get(row, -1), kind, number)
            if key in known:
                earlier, at = known[key]
                group.carry_on(agent, earlier, at)
                places[row, group.place] = key[0], earlier.place
        self._triggers.carry_on(before._triggers, places, rows.is_everyone)
        if self.sensing is not None and before.sensing is not None:
            self.sensing.carry_on(before.sensing, column)
        if same_network:
            self._surroundings.carry_on(before._surroundings)

    def _members(self) -> dict[tuple[int, type[Controller], int], tuple[Group, int]]:
        """By agent, kind of controller, and how many of the kind the agent has before: its group,
        and its place there."""
        found: dict[tuple[int, type[Controller], int], tuple[Group, int]] = {}
        counts: Counter[tuple[int, type[Controller]]] = Counter()
        for group in self._groups:
            for agent, row in enumerate(group.rows.tolist()):
                kind = group.controller.kind
                found[row, kind, counts[row, kind]] = group, agent
                counts[row, kind] += 1
        return found

    def take(self, agents: Integers, count: int) -> None:
        """From now on the world has these of its `count` agents alone."""
        self._held = None
        place = inverse_index(agents, count)
        for group in self._groups:
            group.take(place)
        self._triggers.take(place, agents)
        if self.sensing is not None:
            self.sensing.take(agents, count, self._slots)
        self._surroundings.take(agents, count, self._slots)

    def _ask_earlier(
        self, world: World, in_charge: Integers, own_line: Booleans, view: View, out: Decision
    ) -> None:
        """A controller that does not steer, or does not accelerate, leaves that to the last one
        before it that does, of those whose conditions hold. `own_line`: the agents whose line is
        left, with the steering, to the last one before it that moves lines."""
        active = self._triggers.active
        for group in reversed(self._groups):
            open_ = out.is_open[group.rows] & (in_charge[group.rows] > group.place)
            open_ &= active[group.place, group.rows] & (not group.controller.alters)
            chosen = np.flatnonzero(open_)
            if len(chosen):
                rows = group.rows[chosen]
                accelerates = np.isnan(out.acceleration[rows])
                moves = own_line[rows] & np.isnan(out.steering[rows])
                found = decided(group, chosen, view, accelerates, moves)
                if found.line_offset is not None and moves.any():
                    own_line[rows[moves]] = False
                    _move_lines(view, rows, found, moves)
                out.fill(rows, found)


def _in_charge_of(
    groups: Sequence[Group], in_charge: Integers
) -> list[tuple[Group, Integers, Integers]]:
    """Groups of which any agents are in charge, with these in the order of the group and in that
    of the world."""
    chosen = [(group, np.flatnonzero(in_charge[group.rows] == group.place)) for group in groups]
    return [(group, rows, group.rows[rows]) for group, rows in chosen if len(rows)]


def _keep_to_lines(world: World, view: View, out: Decision) -> None:
    """Vehicles on a road whose controllers leave the steering open follow their lines."""
    rows = np.flatnonzero(np.isnan(out.steering) & world.has_road & ~world.bodies.walks)
    if len(rows):
        out.steering[rows] = line_steering(view.of(rows))


def _spans_of(
    world: World, controllers: Sequence[Mapping[str, Controller]], calls: Sequence[PlacedCall]
) -> dict[tuple[int, int], Span]:
    """Where controllers are written, by their places and the columns of their agents."""
    found = {}
    for place, row, _ in calls:
        scene, agent = divmod(row, world.slots)
        driver = controllers[scene].get(world.scenes[scene].agents[agent].name)
        span = driver.spans.get(place) if isinstance(driver, Driver) else None
        if span is not None:
            found[place, row] = span
    return found


def signals_of(controllers: Sequence[Mapping[str, Controller]]) -> dict[str, KindEntry]:
    """The drive signals of all conditions and expectations, by the names that scenes have for
    them."""
    found: dict[str, KindEntry] = {}
    for each in controllers:
        for driver in each.values():
            found |= driver.signals if isinstance(driver, Driver) else {}
    return found


def _move_lines(
    view: View, rows: Integers, found: ControlBatch, moves: Booleans | None = None
) -> None:
    """`moves`: whose line is moved, by default that of all."""
    assert found.line_offset is not None
    world = view.world
    target = np.full(len(world.present), math.nan)
    time = np.zeros(len(world.present))
    offset = found.line_offset
    target[rows] = offset if moves is None else np.where(moves, offset, math.nan)
    if found.line_time is not None:
        time[rows] = found.line_time
    if world.followed.move(target, time, world.motion.along, world.motion.speed):
        view.lines_moved()
