"""Backends and simulators say what they cannot express, and `check` reports it at its place."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import pytest

from roadlang import testing
from roadlang.api import Backend, Length, ScenarioContents, Scene, Simulator, Trace, option

TEXT = """\
road main { draw with waypoints { points: [(0m, 0m), (100m, 0m)] } }
agent ego is car on main at 5m { drive with pure_pursuit { speed: 5m/s } }
agent other is choice(truck, pedestrian) on main at 50m {}
object oak is tree on main at 20m
world { rain: 1mm/h }
expect slow: always (ego.speed < 9m/s)
simulate with tunnel
emit map { size: 3m }
"""


@dataclass(frozen=True)
class Map(Backend):
    """A map."""

    name: ClassVar[str] = "map"
    size: Length = option(help="size of a tile")

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        for name, kinds in contents.agents.items():
            if "pedestrian" in kinds and self.size > 1:
                yield f"`{name}` may be a pedestrian"

    def files(self, scene: Scene) -> dict[str, str]:
        return {"txt": ""}


@dataclass(frozen=True)
class Tunnel(Simulator):
    """A simulator without weather."""

    name: ClassVar[str] = "tunnel"

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        return [f"it has {name}" for name in contents.world]

    def drive(self, scene: Scene, controllers: Mapping[str, Any]) -> Trace:
        raise NotImplementedError


def test_each_reason_is_reported_at_its_statement() -> None:
    found = testing.check(TEXT, kinds=[Map, Tunnel])
    assert [(d.code, d.span and d.span.text[:4], d.message) for d in found] == [
        ("RL243", "simu", "`simulate tested.tunnel` does not support this scenario: it has rain"),
        (
            "RL243",
            "emit",
            "`emit tested.map` does not support this scenario: `other` may be a pedestrian",
        ),
    ]


def test_a_kind_may_decide_by_its_options() -> None:
    text = TEXT.replace("simulate with tunnel\n", "").replace("3m", "0.5m")
    assert not testing.check(text, kinds=[Map])


def test_the_contents_list_what_is_in_the_scenario() -> None:
    seen: list[ScenarioContents] = []

    @dataclass(frozen=True)
    class Curious(Backend):
        """Looks."""

        name: ClassVar[str] = "map"

        def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
            seen.append(contents)
            return ()

        def files(self, scene: Scene) -> dict[str, str]:
            return {"txt": ""}

    text = TEXT.replace("simulate with tunnel\n", "").replace("{ size: 3m }", "")
    assert not testing.check(text, kinds=[Curious])
    assert seen == [
        ScenarioContents(
            roads=("main",),
            agents={"ego": ("car",), "other": ("truck", "pedestrian")},
            objects={"oak": ("tree",)},
            controllers={"ego": ("pure_pursuit",)},
            world=("rain",),
            expectations=("slow",),
        )
    ]


@pytest.mark.parametrize(
    ("result", "code"), [("a reason", "RL243"), ([1], "RL474"), (None, "RL470"), (1 / 3, "RL470")]
)
def test_a_single_reason_is_taken_and_anything_else_is_a_fault_of_the_plugin(
    result: Any, code: str
) -> None:
    @dataclass(frozen=True)
    class Wrong(Backend):
        """Wrong."""

        name: ClassVar[str] = "map"

        def unsupported(self, contents: ScenarioContents) -> Any:
            return result

        def files(self, scene: Scene) -> dict[str, str]:
            return {"txt": ""}

    text = TEXT.replace("simulate with tunnel\n", "").replace("{ size: 3m }", "")
    (found,) = testing.check(text, kinds=[Wrong])
    assert found.code == code


@pytest.mark.parametrize(
    ("emit", "reason"),
    [
        ("param far = 9m\nemit sbft", "it has no road"),
        ('param far = 9m\nemit sbft { road: "mian" }', "it has no road"),
        (
            f'{TEXT.splitlines()[0]}\nemit sbft {{ road: "mian" }}',
            "it has no road `mian`; did you mean `main`?",
        ),
        (f'{TEXT.splitlines()[0]}\nemit sbft {{ road: "main" }}', None),
        (f"{TEXT.splitlines()[0]}\nemit sbft", None),
    ],
)
def test_road_points_need_their_road(emit: str, reason: str | None) -> None:
    found = [(d.code, d.message) for d in testing.check(emit)]
    message = f"`emit sbft` does not support this scenario: {reason}"
    assert found == ([] if reason is None else [("RL243", message)])
