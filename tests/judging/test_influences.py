"""What decides a requirement: the roads behind what it names, and whether a draw has a say."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roadlang.evaluate.dependencies import Dependencies
from roadlang.judging.acceptance import Acceptance
from roadlang.judging.requirement import Requirement
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

ROADS = STRAIGHT + "road bent from main { perturb with harmonics { amplitude: 0m..2m } }\n"


def named(found: Acceptance, name: str) -> Requirement:
    return next(each for each in found.requirements if each.name == name)


def test_draws_and_roads_come_through_all_those_that_an_agent_is_placed_by(
    acceptance: Callable[[str], Acceptance],
) -> None:
    found = acceptance(
        ROADS
        + "agent still is car on main at 10m\n"
        + "agent first is car on main at 20m..30m\n"
        + "agent second is car on main at first.start + 20m\n"
        + "agent third is car on bent at second.start + 20m\n"
        + "agent last is car on main at third.start + 20m\n"
    )
    randomness = {r.name: r.is_random for r in found.requirements}
    assert randomness == {
        "still": False, "first": True, "second": True, "third": True, "last": True, "bent": True
    }  # fmt: skip
    assert named(found, "second").names == {"main"}
    assert named(found, "last").names == {"main", "bent"}


def test_a_group_that_may_be_empty_may_stand_where_nothing_can(
    sample: Callable[..., SamplingResult],
) -> None:
    text = STRAIGHT + "object box is box on main at 2 * length(main) { count: integer(0, 1) }\n"
    scenes = sample(text, 3).scenes
    assert [scene.draws["box/count"] for scene in scenes] == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("is_reversed", [False, True])
def test_the_work_for_agents_in_a_row_grows_with_their_number(
    acceptance: Callable[[str], Acceptance], is_reversed: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    count = 100
    lines = ["agent a0 is car on main at 1m\n"]
    lines += [f"agent a{i} is car on main at a{i - 1}.start + 1m\n" for i in range(1, count)]
    looked_at = 0
    entities = Dependencies.entities

    def counted(*arguments: object) -> object:
        nonlocal looked_at
        looked_at += 1
        return entities(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(Dependencies, "entities", counted)
    found = acceptance(STRAIGHT + "".join(reversed(lines) if is_reversed else lines))
    assert len(found.requirements) == 2 * count  # each begins on its road, each has room
    assert looked_at < 10 * count
