"""What agents do, as events: actions of OpenSCENARIO and when they begin."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from . import actions
from .controllers import TRANSLATED, DrivenAgent
from .entities import rear_axle
from .positions import Place, Roads
from .triggers import Groups, NotExpressibleError, SceneTriggers, at_time

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor, Trace

_STANDING = 1e-6
"""Meters: who is farther away at some time does not stand."""


@dataclass(frozen=True)
class Event:
    """Actions of an agent that begin with a trigger."""

    name: str
    actions: tuple[actions.Action, ...]
    groups: Groups = ()
    deletes: str = ""
    """the entity that it removes"""


@dataclass(frozen=True)
class Maneuvers:
    """Of one agent: its events, and the kinds of controllers that cannot be expressed."""

    actor: SceneActor
    events: tuple[Event, ...] = ()
    unexpressed: tuple[str, ...] = ()


def maneuvers_of(scene: Scene, roads: Roads, actor: SceneActor) -> Maneuvers:
    """What an agent does as far as OpenSCENARIO has it: entities hold their lane and their speed
    unless an action says otherwise."""
    agent = DrivenAgent(scene, roads, actor)
    triggers = SceneTriggers(scene)
    events: list[Event] = []
    unexpressed: list[str] = []
    for number, call in enumerate(actor.drive, 1):
        translate = TRANSLATED.get(call.kind)
        try:
            if translate is None or call.during is not None:
                raise NotExpressibleError
            groups = () if call.when is None else triggers.groups(call.when)
            for name, found, more in translate(agent, call):
                both = [[*group, *more] for group in groups or ((),)] if more else groups
                events.append(Event(f"{number} {name}", found, both))
        except NotExpressibleError:
            unexpressed.append(call.kind)
    return Maneuvers(actor, tuple(events), tuple(unexpressed))


def driven(scene: Scene, trace: Trace, actor: SceneActor) -> Maneuvers:
    """What an agent did in a drive: it is where it was, and gone when it has left."""
    found = trace.agents.get(actor.name)
    if found is None:
        return Maneuvers(actor)
    count = found.samples_there
    path = zip(found.x[:count].tolist(), found.y[:count].tolist(), found.heading[:count].tolist(),
               strict=True)  # fmt: skip
    poses = np.array([rear_axle(actor, *pose) for pose in path])
    times = np.asarray(found.time[:count])
    events: list[Event] = []
    if count > 1 and np.ptp(poses, axis=0).max() > _STANDING:
        follow = actions.follow_trajectory(f"{actor.name} drive", times, poses, absolute=True)
        events.append(Event("drive", (follow,)))
    if count < len(found.time):
        events.append(Event("leave", (), [[at_time(float(found.time[count]))]], actor.name))
    return Maneuvers(actor, tuple(events))


def start_of(actor: SceneActor, roads: Roads) -> Place:
    """Where its reference point is at the start."""
    return roads.place(*rear_axle(actor, actor.x, actor.y, actor.heading), actor.road)
