"""`control with`: who goes first at the junctions of a network."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roadlang.diagnostics import Diagnostic, DiagnosticError
from roadlang.ir.scene_junctions import SceneJunction
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]
PLAN = '''
image plan from """
...#........#...
################
...#........#...
...#............
""" { scale: 20m/px, legend: { "#": road } }
'''


def town(*passes: str) -> str:
    return PLAN + "network town from plan {\n" + "\n".join(passes) + "\n}\n"


def junctions(sample: Sample, *passes: str, n: int = 1) -> list[list[SceneJunction]]:
    scenes = sample(town(*passes), n=n).scenes
    return [list(scene.networks[0].junctions) for scene in scenes]


def fault(sample: Sample, *passes: str) -> Diagnostic:
    with pytest.raises(DiagnosticError) as caught:
        sample(town(*passes))
    (diagnostic,) = caught.value.diagnostics
    return diagnostic


def sources(junction: SceneJunction, ids: tuple[int, ...]) -> set[str]:
    return {c.source.road for c in junction.connections if c.id in ids}


def test_right_goes_first_where_nothing_is_said(sample: Sample) -> None:
    ((first, second),) = junctions(sample)
    ((stated, _),) = junctions(sample, "control with right_first")
    assert first.control.kind == second.control.kind == "right_first"
    assert stated == first
    assert first.yields


def test_minor_roads_stop_and_yield(sample: Sample) -> None:
    ((first, _),) = junctions(sample, "control with stop")
    assert first.control.kind == "stop"
    assert len(first.control.minor) == 2
    minor, across = set(first.control.minor), {c.id: c.source.road for c in first.connections}
    pairs = [(across[a], across[b]) for a, b in first.yields]
    mixed = [(a, b) for a, b in pairs if (a in minor) != (b in minor)]
    assert mixed
    assert all(a in minor and b not in minor for a, b in mixed)


def test_the_roads_that_yield_can_be_named(sample: Sample) -> None:
    ((first, second),) = junctions(sample, "control with yield { junctions: [1], roads: [3] }")
    assert first.control.minor == ("town/3",)
    assert second.control.kind == "right_first"


def test_at_an_all_way_stop_the_order_of_arrival_decides(sample: Sample) -> None:
    ((first, _),) = junctions(sample, "control with all_way_stop")
    assert first.yields == ()
    assert first.conflicts


def test_opposite_roads_have_green_together_and_left_turns_yield(sample: Sample) -> None:
    ((first, _),) = junctions(sample, "control with signals { green: 18s, yellow: 3s }")
    phases = first.control.phases
    assert [len(sources(first, phase.connections)) for phase in phases] == [2, 2]
    assert sorted(i for phase in phases for i in phase.connections) == list(range(12))
    assert {(phase.green, phase.yellow, phase.all_red) for phase in phases} == {(18.0, 3.0, 2.0)}
    turns = {c.id: c.turn for c in first.connections}
    assert first.yields
    for a, b in first.yields:
        assert turns[a] == "left"
        assert any({a, b} <= set(phase.connections) for phase in phases)


def test_offsets_are_drawn_for_each_junction_and_recorded(sample: Sample) -> None:
    result = sample(town("control with signals { offset: 0s..40s }"), n=2)
    drawn = [
        [junction.control.offset for junction in scene.networks[0].junctions]
        for scene in result.scenes
    ]
    assert len({offset for offsets in drawn for offset in offsets}) == 4
    recorded = {name: value for name, value in result.scenes[0].draws.items() if "control" in name}
    assert sorted(recorded.values()) == sorted(drawn[0])
    assert set(recorded) == {"town/control 1/offset[1]", "town/control 1/offset[3]"}
    assert {result.scenes[0].units[name] for name in recorded} == {"s"}


def test_signals_that_vary_leave_the_roads_what_they_are(sample: Sample) -> None:
    """The network is made once, so that its candidates can be perturbed together."""
    text = town("control with signals { offset: 0s..40s }")
    scenes = sample(text, n=2).scenes
    assert [road.x for road in scenes[0].roads] == [road.x for road in scenes[1].roads]


def test_the_last_pass_counts_and_that_of_a_network_before_one_made_from_it(
    sample: Sample,
) -> None:
    text = town("control with stop", "control with signals { junctions: [1] }")
    text += "network more from town { control with all_way_stop { junctions: [3] } }\n"
    before, after = (
        [junction.control.kind for junction in network.junctions]
        for network in sample(text).scenes[0].networks
    )
    assert before == ["signals", "stop"]
    assert after == ["signals", "all_way_stop"]


def test_a_junction_that_is_not_there_is_named_with_those_that_are(sample: Sample) -> None:
    found = fault(sample, "control with stop { junctions: [4] }")
    assert found.code == "RL429"
    assert found.span is not None
    assert found.span.text == "4"
    assert found.help == (
        "its junctions are 1 at (70m, 50m), 3 at (250m, 50m)",
        "did you mean `3`?",
    )


def test_a_road_that_does_not_end_at_the_junction_is_refused(sample: Sample) -> None:
    found = fault(sample, "control with stop { junctions: [1], roads: [6] }")
    assert (found.code, found.help) == ("RL430", ("the roads that end there are 1, 3, 4, 5",))
    found = fault(sample, "control with yield { roads: [1, 99] }")
    assert found.code == "RL411"
    assert found.span is not None
    assert found.span.text == "99"
