"""The controllers of all agents of a world, called in batches at every step."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..geometry.arrays import Booleans, Floats, Integers, inverse_index
from ..ir.control import ControlBatch
from ..plugins.kinds import Controller
from ..plugins.registry import KindEntry
from .controllers import Driver, GuardedController
from .decision import Decision
from .line_steering import line_steering
from .observing import Surroundings, View
from .poses import Poses
from .single_agents import OthersSeen, observations
from .triggers import PlacedCall, Triggers
from .world import World


@dataclass
class Group:
    """Agents whose controller at one place of their list is of one kind."""

    place: int
    controller: GuardedController
    rows: Integers
    columns: dict[str, Any]
    state: Any
    singles: list[GuardedController]
    """one for each agent, where the kind decides for one alone"""
    since: Floats
    """when each decided last"""
    held: Floats
    """(2, N) steering and acceleration then"""
    built: Controller | None = None
    """the controller with the options of all its agents, once there is one"""

    @property
    def of_all(self) -> Controller:
        """The controller with the options of all its agents."""
        if self.built is None:
            self.built = self.controller.built(self.columns)
        return self.built

    def restart(self, agents: Integers) -> None:
        """Controllers of some agents remember nothing."""
        if self.state is None and not self.singles:
            return
        again = np.flatnonzero(np.isin(self.rows, agents))
        if self.state is not None:
            first = self.controller.first_state(self.of_all, len(self.rows))
            self.state[again] = first[again]
        for row in again if self.singles else ():
            self.singles[row] = self.singles[row].anew()

    def take(self, place: Integers) -> None:
        """Agents are at other places of the world now; at -1, no more."""
        remaining = np.flatnonzero(place[self.rows] >= 0)
        self.rows = place[self.rows[remaining]]
        self.columns, self.built = _part(self.columns, remaining), None
        self.state = None if self.state is None else self.state[remaining]
        self.singles = [self.singles[row] for row in remaining] if self.singles else []
        self.since, self.held = self.since[remaining], self.held[:, remaining]


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
        self._groups, calls = _grouped(world, controllers)
        self._triggers = Triggers(world, calls, signals_of(controllers))
        self._in_charge = np.zeros(0, dtype=np.int64)
        self._chosen: list[Integers] = []
        """of each group who is in charge, by the last `in_charge`"""

    def view(self, world: World, poses: Poses) -> View:
        """What the agents see."""
        return View(world, poses, self._step, self._surroundings)

    def decide(self, world: World, poses: Poses) -> Decision:
        """What all agents are to do until the next step. Moves the lines that they follow."""
        view = self.view(world, poses)
        in_charge = self._triggers.in_charge(world, poses)
        out = Decision.open(in_charge >= 0)
        if in_charge is not self._in_charge:
            self._in_charge = in_charge
            self._chosen = [np.flatnonzero(in_charge[g.rows] == g.place) for g in self._groups]
        for group, chosen in zip(self._groups, self._chosen, strict=True):
            if len(chosen):
                found = _decided(group, chosen, view)
                out.put(group.rows[chosen], found)
                if found.line_offset is not None:
                    _move_lines(world, group.rows[chosen], found)
        if out.is_open.any():
            self._ask_earlier(in_charge, view, out)
            _keep_to_lines(world, view, out)
            out.close()
        return out

    def restart(self, agents: Integers) -> None:
        """Some agents are back at the start. Conditions are not: none of theirs may have any."""
        for group in self._groups:
            group.restart(agents)

    def take(self, agents: Integers, count: int) -> None:
        """From now on the world has these of its `count` agents alone."""
        place = inverse_index(agents, count)
        for group in self._groups:
            group.take(place)
        self._triggers.take(place, agents)
        self._surroundings.take(agents, count, self._slots)

    def _ask_earlier(self, in_charge: Integers, view: View, out: Decision) -> None:
        """A controller that does not steer, or does not accelerate, leaves that to the last one
        before it that does."""
        for group in reversed(self._groups):
            open_ = out.is_open[group.rows] & (in_charge[group.rows] > group.place)
            chosen = np.flatnonzero(open_)
            if len(chosen):
                rows = group.rows[chosen]
                accelerates = np.isnan(out.acceleration[rows])
                out.fill(rows, _decided(group, chosen, view, accelerates))


def _keep_to_lines(world: World, view: View, out: Decision) -> None:
    """Vehicles on a road whose controllers leave the steering open follow their lines."""
    rows = np.flatnonzero(np.isnan(out.steering) & world.has_road & ~world.bodies.walks)
    if len(rows):
        out.steering[rows] = line_steering(view.of(rows))


def signals_of(controllers: Sequence[Mapping[str, Controller]]) -> dict[str, KindEntry]:
    """The drive signals of all conditions and expectations, by the names that scenes have for
    them."""
    found: dict[str, KindEntry] = {}
    for each in controllers:
        for driver in each.values():
            found |= driver.signals if isinstance(driver, Driver) else {}
    return found


def _move_lines(world: World, rows: Integers, found: ControlBatch) -> None:
    assert found.line_offset is not None
    target = np.full(len(world.present), math.nan)
    time = np.zeros(len(world.present))
    target[rows] = found.line_offset
    if found.line_time is not None:
        time[rows] = found.line_time
    world.lateral.move(target, time)


def _decided(
    group: Group, chosen: Integers, view: View, lasting: Booleans | None = None
) -> ControlBatch:
    """What the controllers of some agents of a group decide. `lasting`: whose state goes on,
    by default that of all."""
    if group.singles:
        return _decided_singly(group, chosen, view)
    interval = group.controller.kind.interval
    if interval > view.step:
        return _held(group, chosen, view, interval)
    return _decided_now(group, chosen, view, lasting)


def _held(group: Group, chosen: Integers, view: View, interval: float) -> ControlBatch:
    """What some agents decided at most `interval` seconds ago."""
    time = view.world.time
    old = chosen[time - group.since[chosen] > interval - 0.5 * view.world.dt]
    if len(old):
        found = _decided_now(group, old, view)
        group.since[old] = time
        group.held[0, old], group.held[1, old] = found.steering, found.acceleration
    return ControlBatch(group.held[0, chosen], group.held[1, chosen])


def _decided_now(
    group: Group, chosen: Integers, view: View, lasting: Booleans | None = None
) -> ControlBatch:
    rows = group.rows[chosen]
    guarded = group.controller
    everyone = len(chosen) == len(group.rows)
    built = group.of_all if everyone else guarded.built(_part(group.columns, chosen))
    state = None if group.state is None else group.state[chosen]
    decided = guarded.decide(built, view.of(rows), state)
    if state is not None:
        last = slice(None) if lasting is None else np.flatnonzero(lasting)
        group.state[chosen[last]] = state[last]
    return decided


def _decided_singly(group: Group, chosen: Integers, view: View) -> ControlBatch:
    """Loop over agents whose controllers decide for one alone."""
    slots = view.world.slots
    rows = group.rows[chosen]
    scenes = rows // slots
    found = []
    for scene in dict.fromkeys(scenes.tolist()):  # the rows are in the order of the scenes
        of_scene = scenes == scene
        agents = enumerate(view.world.scenes[scene].agents, scene * slots)
        others = OthersSeen(view, {actor.name: at for at, actor in agents})
        seen = observations(view, rows[of_scene], others)
        found += [group.singles[index].control(observation)
                  for index, observation in zip(chosen[of_scene], seen, strict=True)]  # fmt: skip
    return ControlBatch.of(found)


def _grouped(
    world: World, controllers: Sequence[Mapping[str, Controller]]
) -> tuple[list[Group], list[PlacedCall]]:
    """Groups by place in the list, kind, and options that are no numbers; all calls."""
    members: dict[Any, list[tuple[int, GuardedController]]] = {}
    calls = []
    for row, actor in enumerate(world.actors):
        driver = controllers[row // world.slots].get(actor.name) if actor is not None else None
        for place, call in enumerate(actor.drive if actor is not None else ()):
            controller = driver.each[place] if isinstance(driver, Driver) else None
            if controller is None:
                engine = "the embedded engine"
                found = diagnose(Code.UNSUPPORTED_CONTROLLER, kind=call.kind, engine=engine)
                raise DiagnosticError(found)
            calls.append((place, row, call))
            key = (place, controller.kind, _words(controller.options))
            members.setdefault(key, []).append((row, controller))
    groups = [_group(place, found) for (place, *_), found in members.items()]
    return sorted(groups, key=lambda group: group.place), calls


def _group(place: int, members: list[tuple[int, GuardedController]]) -> Group:
    rows = np.array([row for row, _ in members], dtype=np.int64)
    first = members[0][1]
    if not first.in_batches:
        singles = [controller for _, controller in members]
        return Group(place, first, rows, {}, None, singles, *_never_decided(len(rows)))
    columns = {
        name: value
        if _shape(value) is None
        else np.array([controller.options[name] for _, controller in members], dtype=np.float64)
        for name, value in first.options.items()
    }
    state = first.first_state(first.built(columns), len(rows))
    return Group(place, first, rows, columns, state, [], *_never_decided(len(rows)))


def _never_decided(count: int) -> tuple[Floats, Floats]:
    return np.full(count, -math.inf), np.zeros((2, count))


def _words(options: Mapping[str, Any]) -> str:
    """The options that are not numbers, as one text; of numbers their shape."""
    shapes = {name: _shape(value) for name, value in options.items()}
    words = {
        name: options[name] if shape is None else shape
        for name, shape in shapes.items()
        if shape != ()
    }
    return json.dumps(words, sort_keys=True) if words else ""


def _shape(value: Any) -> tuple[int, ...] | None:
    """() of a number, (2,) of a pair, (3, 2) of three pairs; None of what is not numbers alone."""
    if isinstance(value, list | tuple):
        parts = {_shape(item) for item in value}
        part = parts.pop() if len(parts) == 1 else None
        return None if part is None else (len(value), *part)
    return () if isinstance(value, int | float) and not isinstance(value, bool) else None


def _part(columns: Mapping[str, Any], rows: Integers) -> dict[str, Any]:
    return {
        name: value[rows] if isinstance(value, np.ndarray) else value
        for name, value in columns.items()
    }
