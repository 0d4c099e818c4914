"""Diagnostics that a kind raises itself: they stand where the kind says, or where it is used."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import pytest

from roadlang import testing
from roadlang.api import (
    AgentName,
    Code,
    Controller,
    DiagnosticError,
    DriveSignal,
    Kind,
    Perturber,
    Searcher,
    diagnose,
    option,
)
from roadlang.diagnostics import Source

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }
road bent from main { perturb with picky }
"""
ELSEWHERE = Source("table.csv", "x,y\n0,zero\n")


@dataclass(frozen=True)
class Picky(Perturber):
    """Refuses every road, by a diagnostic of its own."""

    name: ClassVar[str] = "picky"
    has_place: ClassVar[bool] = False

    def displacement(self, road: Any, random: Any) -> Any:
        span = ELSEWHERE.span(6, 10) if self.has_place else None
        raise DiagnosticError(diagnose(Code.DEGENERATE_ROAD, span, name="bent"))


@dataclass(frozen=True)
class PickyElsewhere(Picky):
    """The same, with a place in another file."""

    has_place: ClassVar[bool] = True


@pytest.mark.parametrize(
    ("kind", "path", "marked"),
    [(Picky, "scene.rl", "perturb with picky"), (PickyElsewhere, "table.csv", "zero")],
)
def test_a_diagnostic_of_a_kind_keeps_its_place_or_has_that_of_its_use(
    kind: type[Picky], path: str, marked: str
) -> None:
    with pytest.raises(DiagnosticError) as error:
        testing.sample(TEXT, kinds=[kind])
    (found,) = error.value.diagnostics
    assert found.span is not None
    assert (found.span.source.path, found.span.text) == (path, marked)


DRIVES = """
road main { draw with waypoints { points: [(0m, 0m), (200m, 0m)] }, width: 8m }
agent ego is car on main at 0m..5m
agent lead is car on main at 60m { drive with brake, DRIVE }
expect slow: always (ego.speed < 9m/s)
falsify with lost { evaluations: 3 }
"""


@dataclass(frozen=True)
class Broken(DriveSignal):
    """Cannot be measured."""

    name: ClassVar[str] = "broken"
    looks_back: ClassVar[float] = 0
    agent: AgentName = option(help="the agent")

    def values(self) -> Any:
        raise RuntimeError("no idea")


@dataclass(frozen=True)
class Stuck(Controller):
    """Does not know what to do."""

    name: ClassVar[str] = "stuck"

    def control(self, observation: Any) -> Any:
        raise RuntimeError("no idea")


@dataclass(frozen=True)
class Lost(Searcher):
    """Does not know where to begin."""

    name: ClassVar[str] = "lost"

    def start(self, axes: Any, seed: int) -> Any:
        raise RuntimeError("no idea")


KINDS: tuple[type[Kind], ...] = (Broken, Stuck, Lost)
CONDITION = "drive with lane_follow { speed: 5m/s, when: lead.broken > 1 }"


def loaded(drive: str) -> Any:
    return testing.scenario(DRIVES.replace("DRIVE", drive), kinds=KINDS)


def marked(error: DiagnosticError) -> str:
    (found,) = error.diagnostics
    assert found.code == Code.PLUGIN_FAILED
    assert found.span is not None
    return found.span.text


def test_a_fault_of_a_condition_is_shown_at_its_controller() -> None:
    with pytest.raises(DiagnosticError) as error:
        loaded(CONDITION).sample(1)[0].run("builtin", duration=1.0)
    assert marked(error.value) == CONDITION


def test_a_fault_of_a_searcher_is_shown_at_the_search() -> None:
    with pytest.raises(DiagnosticError) as error:
        loaded("drive with brake").falsify()
    assert marked(error.value) == "falsify with lost { evaluations: 3 }"


@pytest.mark.parametrize("drive", [CONDITION, "drive with stuck"])
@pytest.mark.parametrize("in_scenes", [False, True])
def test_a_fault_in_an_environment_is_shown_at_the_controller(drive: str, in_scenes: bool) -> None:
    envs = pytest.importorskip("roadlang.envs")
    source = loaded(drive)
    env = envs.SceneEnv(source.sample(2) if in_scenes else source, scenes=2, agent="ego")
    env.reset(seed=1)
    with pytest.raises(DiagnosticError) as error:
        env.step(env.action_space.sample())
    assert marked(error.value) == drive


def test_what_godot_drives_while_a_file_is_watched_knows_its_place() -> None:
    from roadlang_godot.editing.compiled_edit import compiled

    driver: Any = compiled(loaded("drive with stuck"), 0).controllers["lead"]
    assert [driver.each[place].span.text for place in (0, 1)] == [
        "drive with brake",
        "drive with stuck",
    ]
