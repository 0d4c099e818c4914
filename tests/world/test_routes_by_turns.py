"""`route: left`, `route: [straight, choice(left, right)]`: turns at the junctions on the way."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.ir.scene import Scene
from roadlang.scenes.sampling import SamplingResult
from tests.route_geometry import faults_of

Sample = Callable[..., SamplingResult]
TOWN = '''
image plan from """
....#.......#....
#################
....#.......#....
....#.......#....
#################
....#............
""" { scale: 15m/px, legend: { "#": road } }
network town from plan { extract with pixels, lanes: 2 }
'''
WEST_END = "at (20m, 22m)"
"""On the lower of the two long roads, in the lane to the east; the second junction ahead of it is a
T from which roads lead to the left and straight on."""


def sampled(sample: Sample, agent: str, n: int = 1, seed: int = 0) -> tuple[Scene, ...]:
    return sample(f"{TOWN}agent ego is car on town {agent}\n", n=n, seed=seed).scenes


def turns_of(scene: Scene, copy: int = 0) -> list[str]:
    """The turns on the route of an agent, at junctions alone."""
    route = scene.agents[copy].route
    assert route is not None
    assert not faults_of(scene, route)
    (network,) = scene.networks
    places = {junction.id: junction for junction in network.junctions}
    taken = [step.turn for step in route.steps if step.turn is not None]
    found: list[str] = []
    for turn in taken:
        junction = places[turn.junction]
        if junction.kind != "joint":
            found.append(next(c for c in junction.connections if c.id == turn.connection).turn)
    return found


@pytest.mark.parametrize(
    ("route", "turns"),
    [
        ("left", ["left"]),
        ("right", ["right"]),
        ("[straight, left]", ["straight", "left"]),
        ("[straight, straight]", ["straight", "straight"]),
        ("[left, right]", ["left", "right"]),
        ("[(100m, 22m), left]", ["straight", "left"]),
    ],
)
def test_a_route_turns_as_it_says_and_then_goes_straight_on(
    sample: Sample, route: str, turns: list[str]
) -> None:
    (scene,) = sampled(sample, f"{WEST_END} {{ route: {route} }}")
    found = turns_of(scene)
    assert found[: len(turns)] == turns
    assert set(found[len(turns) :]) <= {"straight"}


def test_without_a_place_it_begins_where_it_can_turn(sample: Sample) -> None:
    for scene in sampled(sample, "{ count: 4, route: [left, left] }", n=6, seed=3):
        for copy in range(4):
            assert turns_of(scene, copy)[:2] == ["left", "left"]


def test_a_turn_may_be_drawn(sample: Sample) -> None:
    scenes = sampled(sample, f"{WEST_END} {{ route: [choice(left, right)] }}", n=12, seed=1)
    firsts = [turns_of(scene)[0] for scene in scenes]
    assert set(firsts) == {"left", "right"}
    again = sampled(sample, f"{WEST_END} {{ route: [choice(left, right)] }}", n=12, seed=1)
    assert [turns_of(scene)[0] for scene in again] == firsts
    assert [list(scene.draws.values()) for scene in scenes] == [[word] for word in firsts]


def test_each_copy_draws_its_own_turn(sample: Sample) -> None:
    (scene,) = sampled(sample, "at random { count: 12, route: choice(left, right) }", seed=5)
    assert {turns_of(scene, copy)[0] for copy in range(12)} == {"left", "right"}


def test_it_turns_around_where_the_network_lets_it(sample: Sample) -> None:
    text = TOWN.replace("lanes: 2 }", "lanes: 2, u_turns: true }")
    text += f"agent ego is car on town {WEST_END} {{ route: turn_around }}\n"
    (scene,) = sample(text).scenes
    assert turns_of(scene)[0] == "u"


@pytest.mark.parametrize(
    ("agent", "code", "underlined", "help_"),
    [
        (
            f"{WEST_END} {{ route: turn_around }}",
            "RL618",
            "turn_around",
            "`left`, `straight`, `right`",
        ),
        (f"{WEST_END} {{ route: [straight, right] }}", "RL618", "right", "`left`, `straight`"),
        (f"{WEST_END} {{ route: [left, right, left, left] }}", "RL618", "left", "no junction"),
        (f"{WEST_END} {{ route: [random, left] }}", "RL206", "[random, left]", "stands alone"),
        (
            f"{WEST_END} {{ route: choice(random, left) }}",
            "RL206",
            "choice(random, left)",
            "stands alone",
        ),
        (f"{WEST_END} {{ route: [left, up] }}", "RL223", "up", "the words are"),
        (
            f"{WEST_END} {{ route: left, route_length: 90m }}",
            "RL252",
            "route_length: 90m",
            "random",
        ),
    ],
)
def test_a_turn_that_is_not_there_is_underlined(
    sample: Sample, agent: str, code: str, underlined: str, help_: str
) -> None:
    with pytest.raises(DiagnosticError) as caught:
        sampled(sample, agent)
    (found,) = [item for item in caught.value.diagnostics if item.is_error]
    assert (found.code, found.span.text if found.span else None) == (code, underlined)
    assert help_ in "\n".join(found.help)
