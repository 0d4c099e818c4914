"""What simulators must give: a trace of each scene, with all of its agents; and in which parts they
are given scenes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import DiagnosticError, testing
from roadlang.api import Controller, Scene, Simulator, option
from roadlang.drive.batches import DriveTask
from roadlang.drive.simulators import drive_scenes, embedded_engine, engine_settings, simulator_call
from roadlang.plugins.entry_points import Origin
from roadlang.plugins.registry import BrokenPlugin, Registry

SCENE = testing.sample("""
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } }
agent ego is car on main at 9m
""")[0].record


@dataclass(frozen=True)
class Faulty(Simulator):
    """Give what it is told to."""

    name: ClassVar[str] = "faulty"
    at_once: ClassVar[int] = 3
    gives: str = option("traces", help="what it gives")

    def drive_all(
        self, scenes: Sequence[Scene], controllers: Sequence[Mapping[str, Controller]]
    ) -> Iterator[Any]:
        for scene in scenes:
            names = [agent.name for agent in scene.agents]
            agents = [testing.agent_trace(name, time=[0.0, 1.0]) for name in names]
            yield {
                "words": "a word",
                "nobody": testing.trace(testing.agent_trace("x", time=[0.0])),
            }.get(self.gives, testing.trace(*agents))
        if self.gives == "more":
            yield testing.trace(testing.agent_trace("ego", time=[0.0]))


REGISTRY = testing.registry_with(Faulty)


def with_simulators(*names: str, broken: tuple[BrokenPlugin, ...] = ()) -> Registry:
    entries = (e for e in REGISTRY.entries if e.verb != "simulate" or e.name in names)
    return Registry(tuple(entries), broken)


def test_traces_come_in_the_order_of_their_scenes() -> None:
    other = replace(SCENE, name="other")
    driven = drive_scenes([SCENE, other], REGISTRY, "faulty", {})
    assert [each.scene.name for each in driven] == [SCENE.name, "other"]
    np.testing.assert_array_equal(driven[0].trace.time, [0.0, 1.0])
    assert driven[0].readings == ()


@pytest.mark.parametrize(
    ("gives", "fault"),
    [
        ("words", "gave a str, not a Trace"),
        ("more", "gave 2 traces of 1 scenes"),
        ("nobody", "without the agent `ego`"),
    ],
)
def test_anything_else_is_a_fault_of_the_simulator(gives: str, fault: str) -> None:
    with pytest.raises(DiagnosticError) as caught:
        drive_scenes([SCENE], REGISTRY, "faulty", {"gives": gives})
    (found,) = caught.value.diagnostics
    assert found.code == "RL474"
    assert fault in found.message
    assert "simulate tested.faulty" in found.message


def test_without_any_simulator_the_error_says_what_may_have_left_them_out() -> None:
    lame = BrokenPlugin(Origin("lame", "lame", "1.0"), "no wheels")
    for broken, help_ in [
        ((), ("`--no-plugin` may have left it out",)),
        ((lame,), (str(lame),)),
    ]:
        with pytest.raises(DiagnosticError) as caught:
            simulator_call(SCENE, with_simulators(broken=broken), None, {})
        (found,) = caught.value.diagnostics
        assert (found.code, found.help) == ("RL926", help_)


def test_a_scene_that_names_no_engine_gets_a_shipped_one() -> None:
    assert simulator_call(SCENE, REGISTRY, None, {}).kind != "tested.faulty"
    assert simulator_call(SCENE, with_simulators("faulty"), None, {}).kind == "tested.faulty"


def test_the_embedded_engine_is_found_by_its_settings() -> None:
    entry, simulator = embedded_engine(REGISTRY)
    assert entry.name == "builtin"
    assert engine_settings(REGISTRY) == simulator.settings  # type: ignore[attr-defined]
    with pytest.raises(DiagnosticError) as caught:
        engine_settings(with_simulators())
    assert caught.value.diagnostics[0].code == "RL926"


@pytest.mark.parametrize(
    ("scenes", "workers", "parts"),
    [
        (0, 2, []),
        (2, 1, [range(2)]),
        (3, 1, [range(3)]),
        (4, 1, [range(3), range(3, 4)]),
        (4, 2, [range(2), range(2, 4)]),
        (5, 2, [range(3), range(3, 5)]),
        (2, 8, [range(1), range(1, 2)]),
        (3, 0, [range(3)]),
    ],
)
def test_workers_share_scenes_evenly_but_take_no_more_than_the_simulator_does_at_once(
    scenes: int, workers: int, parts: list[range]
) -> None:
    assert DriveTask(REGISTRY, "faulty").parts([SCENE] * scenes, workers) == parts
