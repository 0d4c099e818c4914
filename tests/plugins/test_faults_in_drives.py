"""A plugin that fails while a scene is driven or judged is named, with exit code 5."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from roadlang.cli.main import run
from tests.plugins.installed import install

PLUGIN = """
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from roadlang.api import (
    AgentName, AgentTrace, Control, Controller, DriveSignal, Monitor, Observation, Simulator,
    Trace, hookimpl, option,
)

TIME = np.linspace(0.0, 1.0, 11)


@dataclass(frozen=True)
class Still(Simulator):
    '''Nobody moves.'''
    name: ClassVar[str] = "still"

    def drive(self, scene, controllers):
        for controller in controllers.values():
            seen = Observation(0, 0.1, "ego", 0, 0, 0, 0, 0, 0, 0, 0, 2.7, lambda d: (d, 0, 0, 0))
            controller.control(seen)
        zero = np.zeros_like(TIME)
        columns = ("x y heading speed acceleration steering station cross_track_error progress "
                   "contacts").split()
        ego = AgentTrace(name="ego", time=TIME, **{column: zero for column in columns})
        return Trace(TIME, {"ego": ego}, "still")


@dataclass(frozen=True)
class Stanley(Controller):
    '''Has the name of a standard kind.'''
    name: ClassVar[str] = "stanley"

    def control(self, seen):
        return Control(0.0, 0.0)


@dataclass(frozen=True)
class Speed(DriveSignal):
    '''Has the name of a standard kind, and is always 7.'''
    name: ClassVar[str] = "speed"
    member: ClassVar[bool] = False
    unit: ClassVar[str] = "m/s"
    agent: AgentName = option()

    def values(self):
        return 7.0 + 0.0 * self.agent[0].speed


@dataclass(frozen=True)
class Calm(Monitor):
    '''Never moved.'''
    name: ClassVar[str] = "calm"
    domain: ClassVar[str] = "drive"
    agent: AgentName = option()

    def judge(self, trace):
        return 1.0 - np.abs(self.agent.speed).max()


@hookimpl
def roadlang_kinds():
    return [Still, Stanley, Speed, Calm]
"""
SCENE = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } }
agent ego is car on main at 5m { drive with acme.stanley }
simulate with acme.still
expect fast: always (acme.speed(ego) > 6m/s)
expect calm with calm { agent: ego }
emit json
"""
FAULTS = {
    "controller that raises": ("return Control(0.0, 0.0)", "1 / 0", "RL470", "drive acme.stanley"),
    "controller that is undecided": (
        "return Control(0.0, 0.0)", "return None", "RL474", "gave a NoneType, not a Control",
    ),
    "controller without bounds": (
        "return Control(0.0, 0.0)", "return Control(0.0, np.nan)", "RL474", "which is not finite",
    ),
    "signal that raises": (
        "return 7.0 + 0.0 * self.agent[0].speed", "1 / 0", "RL470", "drive_signal acme.speed",
    ),
    "signal of another length": (
        "return 7.0 + 0.0 * self.agent[0].speed", "return [7.0]", "RL474", "not (11,)",
    ),
    "monitor that raises": (
        "return 1.0 - np.abs(self.agent.speed).max()", "1 / 0", "RL470", "monitor acme.calm",
    ),
    "monitor that gives no number": (
        "return 1.0 - np.abs(self.agent.speed).max()", "return np.nan", "RL474", "is not a number",
    ),
    "simulator that raises": (
        'return Trace(TIME, {"ego": ego}, "still")', "1 / 0", "RL470", "simulate acme.still",
    ),
    "simulator without a trace": (
        'return Trace(TIME, {"ego": ego}, "still")', "return 3", "RL474", "not a Trace",
    ),
    "simulator that forgets an agent": (
        'return Trace(TIME, {"ego": ego}, "still")', 'return Trace(TIME, {}, "still")',
        "RL474", "without the agent `ego`",
    ),
}  # fmt: skip


def drive(site: Path, plugin: str) -> int:
    install(site, "acme", plugin)
    (site / "scene.rl").write_text(SCENE)
    return run(["run", str(site / "scene.rl"), "-o", str(site / "out")])


def test_kinds_of_strangers_keep_their_whole_names_through_a_drive(site: Path) -> None:
    assert drive(site, PLUGIN) == 0
    verdicts = json.loads((site / "out" / "scene-0000.verdicts.json").read_text())
    rho = {each["name"]: each["robustness"] for each in verdicts["expectations"]}
    assert rho == {"fast": pytest.approx(1.0), "calm": pytest.approx(1.0)}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_in_a_drive_is_named_and_what_was_driven_is_kept(
    site: Path, capsys: pytest.CaptureFixture[str], fault: str
) -> None:
    good, bad, code, says = FAULTS[fault]
    assert good in PLUGIN
    assert drive(site, PLUGIN.replace(good, bad)) == 5
    said = capsys.readouterr().err
    assert code in said
    assert says in said
    assert "acme-plugin 1.2" in said
    while_driving = fault.startswith(("controller", "simulator"))
    assert (site / "out" / "scene-0000.trace.csv").exists() == (not while_driving)


def test_an_expectation_that_cannot_be_evaluated_is_named_with_its_place(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    install(site, "acme", PLUGIN)
    root = "expect ratio: always ((ego.station - 1000m) ^ 0.5 < 5m^0.5)"
    at_rest = "expect at_rest: always (ego.speed < 1m/s)"
    (site / "scene.rl").write_text(SCENE.replace("expect calm", f"{root}\n{at_rest}\nexpect calm"))
    assert run(["run", str(site / "scene.rl"), "-o", str(site / "out")]) == 1
    printed = capsys.readouterr()
    assert "error[RL307]: `^` gives no number" in printed.err
    assert "scene.rl:6:1" in printed.err
    assert "expectation `ratio` in scene 0" in printed.err
    assert "all expectations hold in 0 of 1 scene" in printed.out
    verdicts = json.loads((site / "out" / "scene-0000.verdicts.json").read_text())
    satisfied = {each["name"]: each["satisfied"] for each in verdicts["expectations"]}
    assert satisfied == {"fast": True, "ratio": None, "at_rest": True, "calm": True}
    assert (site / "out" / "scene-0000.trace.csv").exists()
