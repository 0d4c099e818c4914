"""A drive for the page: what its viewer draws, in few characters."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..diagnostics import DiagnosticError
from ..drive.robustness_colors import COLOR_STEPS, color_shares
from ..falsification.descriptors import protagonist
from ..geometry.arrays import Floats, Integers
from ..ir.scene import Verdict
from ..ir.trace import AgentTrace
from ..judging.badness import worst_of
from ..judging.deciding_moment import DecidingMoment, deciding_moment, first_violation
from ..judging.robustness_series import robustness_series
from ..plugins.registry import Registry
from .decimation import deltas, samples_of
from .numbers import quantity, shown_unit
from .outlines import CENTIMETERS, outlines
from .results import ShownDrive
from .units import robustness_unit

_SAMPLES_OF_ALL, _FEWEST, _MOST = 120_000, 40, 240
"""Samples of all agents of all drives together, and of a drive."""


@dataclass(frozen=True)
class Judged:
    """An expectation along a drive. `series` (T,) is None where it cannot be computed."""

    verdict: Verdict
    unit: str
    series: Floats | None


@dataclass(frozen=True)
class DriveView:
    """A drive with what is computed of it once. `worst` is None where nothing is judged."""

    drive: ShownDrive
    judged: tuple[Judged, ...]
    worst: Judged | None
    moment: DecidingMoment | None
    agent: str
    """the agent that plots along the road are about"""

    @property
    def place(self) -> str:
        """`7.4 s, s = 135 m`: when and where it goes wrong, or comes nearest to that."""
        if self.moment is None or not self.moment.actors:
            return ""
        at, actor = self.moment.sample, self.moment.actors[0]
        station = float(actor.station[at])
        time = f"{float(actor.time[at]):.1f}\N{NO-BREAK SPACE}s"
        return (
            time if np.isnan(station) else f"{time}, s\N{NO-BREAK SPACE}= {quantity(station, 'm')}"
        )


def view(drive: ShownDrive, registry: Registry) -> DriveView:
    """Judge a drive along its time."""
    judged = tuple(
        Judged(v, robustness_unit(v, registry), _series(v, drive, registry)) for v in drive.verdicts
    )
    verdict = worst_of(drive.verdicts, drive.expects)
    worst = next((each for each in judged if each.verdict is verdict), None)
    moment = None if worst is None else _moment(worst.verdict, drive, registry)
    agent = protagonist(drive.scene, [verdict.name for verdict in drive.verdicts])
    if moment is not None and moment.actors:
        agent = moment.actors[0].name
    return DriveView(drive, judged, worst, moment, agent)


def samples_per_drive(views: Sequence[DriveView]) -> int:
    """As many samples of each drive as keep the page small."""
    agents = sum(len(view.drive.trace.agents) for view in views)
    return int(np.clip(_SAMPLES_OF_ALL / max(agents, 1), _FEWEST, _MOST))


def drive_record(view: DriveView, roads: dict[str, int], samples: int) -> Any:
    """The members that the viewer reads. `roads`: all outlines of the page so far and their
    numbers, to which those of this drive are added."""
    drive, trace = view.drive, view.drive.trace
    series = [judged.series for judged in view.judged if judged.series is not None]
    at = [view.moment.sample] if view.moment is not None else []
    indices = samples_of(len(trace.time), samples, series, at)
    objects = {object_.name for object_ in drive.scene.standing}
    moving = [agent for agent in trace.agents.values() if agent.name not in objects]
    ego = trace.agents.get(view.agent)
    return {
        "name": drive.name,
        "label": drive.label,
        "row": drive.row,
        "failed": drive.has_failed,
        "roads": [_number(roads, outline.record()) for outline in outlines(drive.scene)],
        "objects": [
            [
                object_.name,
                object_.kind.rpartition(".")[2],
                *_rounded(object_.x, object_.y, object_.heading, object_.length, object_.width),
            ]
            for object_ in drive.scene.objects
        ],
        "time": deltas(trace.time[indices], 1000.0),
        "agents": [_agent(agent, indices) for agent in moving if np.isfinite(agent.x).any()],
        "agent": view.agent,
        **_of_protagonist(ego, indices),
        "verdicts": [_verdict(judged, indices) for judged in view.judged],
        "worst": None if view.worst is None else view.worst.verdict.name,
        "shades": _shades(view.worst, indices),
        "moment": None
        if view.moment is None
        else int(np.searchsorted(indices, view.moment.sample)),
        "place": view.place,
        "controllerFailures": [
            [failure.agent, failure.time, failure.reason] for failure in trace.controller_failures
        ],
        "shrunk": drive.shrunk,
        "explanation": drive.explanation,
    }


def _of_protagonist(agent: AgentTrace | None, samples: Integers) -> dict[str, list[int]]:
    """What is plotted of it. An agent on several roads, on each of which `station` begins anew,
    also has the meters driven along its route."""
    if agent is None:
        return {"speed": [], "station": [], "driven": []}
    roads = agent.road[np.isfinite(agent.road)]
    has_turned = len(roads) > 0 and bool(np.ptp(roads) > 0.0)
    is_known = has_turned and bool(np.isfinite(agent.route_progress).all())
    return {
        "speed": deltas(agent.speed[samples], CENTIMETERS),
        "station": deltas(agent.station[samples], CENTIMETERS),
        "driven": deltas(agent.route_progress[samples], CENTIMETERS) if is_known else [],
    }


def _agent(agent: Any, samples: Integers) -> dict[str, Any]:
    return {
        "name": agent.name,
        "size": _rounded(agent.length, agent.width),
        "x": deltas(agent.x[samples], CENTIMETERS),
        "y": deltas(agent.y[samples], CENTIMETERS),
        "heading": deltas(np.unwrap(np.nan_to_num(agent.heading))[samples], 1000.0),
        "until": _samples_until_gone(agent, samples),
    }


def _samples_until_gone(agent: Any, samples: Integers) -> int:
    """Number of samples before the agent leaves; all samples if it stays."""
    gone = agent.present[samples] == 0.0
    return int(gone.argmax()) if gone.any() else len(samples)


def _verdict(judged: Judged, samples: Integers) -> Mapping[str, Any]:
    verdict, (factor, unit) = judged.verdict, shown_unit(judged.unit)
    least = verdict.robustness
    series = None if judged.series is None else (factor * judged.series[samples]).tolist()
    return {
        "name": verdict.name,
        "text": verdict.text,
        "unit": unit,
        "robustness": None if least is None else least * factor,
        "satisfied": verdict.satisfied,
        "series": None if series is None else [_short(rho) for rho in series],
    }


def _shades(worst: Judged | None, samples: Integers) -> list[int]:
    """(K,) the color of the path at each sample: from 0, violated, over 8 to 16, safe."""
    if worst is None or worst.series is None:
        return []
    shades = color_shares(worst.series)[samples] * COLOR_STEPS + COLOR_STEPS
    found: list[int] = shades.astype(int).tolist()
    return found


def _series(verdict: Verdict, drive: ShownDrive, registry: Registry) -> Floats | None:
    try:
        return robustness_series(verdict, drive.trace, registry)
    except DiagnosticError:  # a plugin that is not installed here, or what was not recorded
        return None


def _moment(verdict: Verdict, drive: ShownDrive, registry: Registry) -> DecidingMoment | None:
    find = first_violation if verdict.satisfied is False else deciding_moment
    try:
        return find(verdict, drive.trace, registry)
    except DiagnosticError:
        return None


def _number(roads: dict[str, int], record: dict[str, Any]) -> int:
    text = json.dumps(record, separators=(",", ":"))
    return roads.setdefault(text, len(roads))


def _rounded(*values: float) -> list[float]:
    return [round(value, 3) for value in values]


def _short(value: float) -> float | None:
    return float(f"{value:.4g}") if np.isfinite(value) else None
