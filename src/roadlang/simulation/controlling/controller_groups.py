"""Agents of a world whose controllers are of one kind, called together."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from operator import or_
from typing import Any

import numpy as np

from ...diagnostics import Code, DiagnosticError, diagnose
from ...geometry.arrays import Floats, Integers
from ...ir.control import ControlBatch
from ...ir.scene import Call, SceneActor
from ...plugins.kinds import Controller
from ..calling.controllers import Driver, GuardedController
from ..calling.option_columns import columns_of, options_of, words_of
from ..signals.triggers import PlacedCall
from ..state.world import World

HELD = (
    "steering", "acceleration", "heading", "line_offset", "line_time", "acceleration_limit",
)  # fmt: skip
"""Members of a decision that hold until the next; a pose is that of one step."""


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
    """(6, N) what each decided then, in the order of `HELD`; NaN where it said nothing"""
    built: Controller | None = None
    """the controller with the options of all its agents, once there is one"""
    said: Sequence[bool] = (True,) * len(HELD)
    """whether anybody may have said something, in the order of `HELD`"""

    @property
    def of_all(self) -> Controller:
        """The controller with the options of all its agents."""
        if self.built is None:
            self.built = self.controller.built(self.columns)
        return self.built

    def restart(self, agents: Integers) -> None:
        """Controllers of some agents remember nothing."""
        again = np.flatnonzero(np.isin(self.rows, agents))
        self.since[again], self.held[:, again] = -np.inf, np.nan
        if self.state is not None:
            first = self.controller.first_state(self.of_all, len(self.rows))
            self.state[again] = first[again]
        for row in again if self.singles else ():
            self.singles[row] = self.singles[row].anew()

    def carry_on(self, agent: int, before: Group, place: int) -> None:
        """One of the agents goes on with what one of another group of the kind remembers."""
        if self.state is not None and self.state.shape[1:] == before.state.shape[1:]:
            self.state[agent] = before.state[place]
        if self.singles and before.singles:
            self.singles[agent].carry_on(before.singles[place])
        self.since[agent], self.held[:, agent] = before.since[place], before.held[:, place]
        self.said = [True] * len(HELD)

    def hold(self, agents: Integers, decided: ControlBatch, time: float) -> None:
        """What some of the agents have decided, at a time, holds until they decide again."""
        self.since[agents] = time
        columns = [getattr(decided, name) for name in HELD]
        says = [column is not None for column in columns]
        for row, column in enumerate(columns):
            if says[row] or self.said[row]:
                self.held[row, agents] = column if says[row] else math.nan
        everyone = len(agents) == len(self.rows)
        self.said = says if everyone else [*map(or_, says, self.said)]

    def last_decided(self, agents: Integers) -> ControlBatch:
        """What some of the agents decided when they did last."""
        held = self.held if len(agents) == len(self.rows) else self.held[:, agents]
        steering, acceleration, *others = held
        said = {
            name: one
            for name, says, one in zip(HELD[2:], self.said[2:], others, strict=True)
            if says and not np.isnan(one).all()
        }
        return ControlBatch(steering, acceleration, **said)

    def take(self, place: Integers) -> None:
        """Agents are at other places of the world now; at -1, no more."""
        remaining = np.flatnonzero(place[self.rows] >= 0)
        self.rows = place[self.rows[remaining]]
        self.columns, self.built = options_of(self.columns, remaining), None
        self.state = None if self.state is None else self.state[remaining]
        self.singles = [self.singles[row] for row in remaining] if self.singles else []
        self.since, self.held = self.since[remaining], self.held[:, remaining]


def elementwise_controller(groups: Sequence[Group], agents: int) -> Controller | None:
    """The one that decides for all agents at every step, if it does so by computations of their
    columns alone."""
    if len(groups) != 1 or len(groups[0].rows) != agents:
        return None
    (group,) = groups
    kind = group.controller.kind
    holds = group.state is not None or kind.interval > 0.0 or group.singles
    return group.of_all if kind.is_elementwise and not holds else None


def grouped(
    world: World,
    controllers: Sequence[Mapping[str, Controller]],
    layouts: Mapping[int, Any],
) -> tuple[list[Group], list[PlacedCall]]:
    """Groups by place in the list, kind, options that are no numbers and the `layouts` of what
    agents sense; all calls."""
    members: dict[Any, list[tuple[int, GuardedController]]] = {}
    calls = []
    for row, actor in enumerate(world.actors):
        if actor is None:
            continue
        driver = controllers[row // world.slots].get(actor.name)
        for place, call in enumerate(actor.drive):
            controller = driver.each[place] if isinstance(driver, Driver) else None
            if controller is None:
                raise _not_written(call if driver else _deciding(actor), actor)
            calls.append((place, row, call))
            key = (place, controller.kind, words_of(controller.options), layouts.get(row))
            members.setdefault(key, []).append((row, controller))
    groups = [_group(place, found) for (place, *_), found in members.items()]
    return sorted(groups, key=lambda group: group.place), calls


def _deciding(actor: SceneActor) -> Call:
    """The controller that nothing ends: what an agent has no driver for."""
    steady = [call for call in actor.drive if call.when is None and call.during is None]
    return (steady or actor.drive)[-1]


def _not_written(call: Call, actor: SceneActor) -> DiagnosticError:
    help_ = f"`{actor.name}` uses it; another simulator may support it (`--engine`)"
    engine = "the embedded engine"
    return DiagnosticError(
        diagnose(Code.UNSUPPORTED_CONTROLLER, kind=call.kind, engine=engine, help=help_)
    )


def _group(place: int, members: list[tuple[int, GuardedController]]) -> Group:
    rows = np.array([row for row, _ in members], dtype=np.int64)
    first = members[0][1]
    if not first.in_batches and not first.alters:
        singles = [controller for _, controller in members]
        return Group(place, first, rows, {}, None, singles, *_never_decided(len(rows)))
    columns = columns_of([controller.options for _, controller in members])
    first = first.for_several([controller.span for _, controller in members])
    state = first.first_state(first.built(columns), len(rows))
    return Group(place, first, rows, columns, state, [], *_never_decided(len(rows)))


def _never_decided(count: int) -> tuple[Floats, Floats]:
    return np.full(count, -math.inf), np.full((len(HELD), count), math.nan)
