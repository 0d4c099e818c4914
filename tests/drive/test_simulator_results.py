"""What simulators must give: a trace of each scene, with all of its agents; and in which parts they
are given scenes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import DiagnosticError, testing
from roadlang.api import Controller, Scene, Simulator, option
from roadlang.drive.batches import DriveTask
from roadlang.drive.simulators import (
    drive_scenes,
    embedded_engine,
    engine_settings,
    scenes_at_once,
    simulator_call,
)
from roadlang.plugins.entry_points import Origin
from roadlang.plugins.registry import BrokenPlugin, Registry
from roadlang.search.worker_pool import WorkerPool, Workers
from roadlang.session import drives_in_parts
from roadlang.session.finished_drives import DriveFinishing
from roadlang.simulation.vehicles import compiled

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


@pytest.mark.parametrize(
    ("scenes", "few", "first", "others"),
    [
        (9, 2, range(2), [range(2, 5), range(5, 8), range(8, 9)]),
        (9, 3, range(0), [range(3), range(3, 6), range(6, 9)]),  # as many as in one call
        (2, 2, range(0), [range(1), range(1, 2)]),
        (0, 2, range(0), []),
    ],
)
def test_the_first_scenes_are_a_part_where_the_simulator_drives_more_at_once(
    scenes: int, few: int, first: range, others: list[range]
) -> None:
    task = DriveTask(REGISTRY, "faulty")
    assert task.first_part([SCENE] * scenes, few) == first
    assert task.parts([SCENE] * scenes, 2, len(first)) == others


def test_the_first_simulator_drives_many_scenes_at_once() -> None:
    assert scenes_at_once(with_simulators("faulty"), None) == 3
    assert scenes_at_once(REGISTRY, "builtin") == 64


class Quick(Faulty):
    """Drive many in one call."""

    name: ClassVar[str] = "quick"
    at_once: ClassVar[int] = 64


@pytest.mark.parametrize(
    ("scenes", "calls"), [(127, [[64, 63]]), (130, [[8], [61, 61]]), (0, [[]]), (1, [[1]])]
)
def test_a_few_of_many_scenes_are_driven_before_processes_are_forked(
    scenes: int, calls: list[list[int]], monkeypatch: pytest.MonkeyPatch
) -> None:
    handed_out: list[list[int]] = []

    class Pool(WorkerPool[Any]):
        will_fork = True

        def map(self, work: Any, jobs: Any, fewest: int = 2) -> Iterator[Any]:
            handed_out.append([len(job) for job in jobs])
            yield from (work(self.state, job) for job in jobs)

    monkeypatch.setattr(drives_in_parts, "WorkerPool", Pool)
    monkeypatch.setattr(compiled, "expect", lambda times: None)
    finishing = DriveFinishing(DriveTask(testing.registry_with(Quick), "quick"))
    numbered: Any = [SimpleNamespace(record=replace(SCENE, index=n)) for n in range(scenes)]
    found = [
        drive
        for part in drives_in_parts.drive_in_parts(numbered, finishing, Workers(2))
        for drive in part
    ]
    assert [drive.line.scene for drive in found] == [*range(scenes)]
    assert handed_out == calls
