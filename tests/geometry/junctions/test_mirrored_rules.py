"""Signals and minor roads of a mirrored drawing, with traffic on the other side, are mirrored."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from roadlang.geometry.junctions.phases import signal_phases
from roadlang.geometry.junctions.plan import PlanOptions, plan_junctions
from roadlang.geometry.junctions.priority import minor_roads, yields
from roadlang.geometry.networks.junction_model import Junction
from tests.geometry.junctions.crossings_of_roads import only, sections_of, star

Mirror = Callable[[float], float]
MIRRORS: dict[str, Mirror] = {"east_west": lambda d: 180.0 - d, "north_south": lambda d: -d}
STARS = [
    (0, 90, 180, 270), (45, 135, 225, 315), (0, 140, 220), (90, 230, 310), (0, 180, 90),
    (30, 150, 270), (0, 72, 144, 216, 288), (0, 60, 120, 180, 240, 300),
]  # fmt: skip


@cache
def junction_of(degrees: tuple[float, ...], left_hand: bool) -> Junction:
    network = star(*degrees)
    sections = sections_of(network)
    if left_hand:
        sections = {edge: section.mirrored() for edge, section in sections.items()}
    return only(plan_junctions(network, sections, PlanOptions(left_hand)))


def both(degrees: list[float], mirror: Mirror, order: list[int]) -> tuple[Junction, Junction]:
    """The junction, and the mirrored one, whose roads are drawn in another order."""
    image = [mirror(degrees[place]) for place in order]
    return junction_of(tuple(degrees), False), junction_of(tuple(image), True)


def roads(junction: Junction, ids: tuple[int, ...], order: list[int] | None) -> set[int]:
    """The places in the list of degrees of the roads that connections leave."""
    found = {one.source.edge - 1 for one in junction.connections if one.id in ids}
    return found if order is None else {order[place] for place in found}


def check_mirrored(degrees: list[float], mirror: Mirror, order: list[int]) -> None:
    right, left = both(degrees, mirror, order)
    assert [roads(right, ids, None) for ids in signal_phases(right)] == [
        roads(left, ids, order) for ids in signal_phases(left)
    ]
    for clearly in (True, False):
        minor = {edge - 1 for edge in minor_roads(right, clearly=clearly)}
        assert minor == {order[edge - 1] for edge in minor_roads(left, clearly=clearly)}


@pytest.mark.parametrize("mirror", MIRRORS)
@pytest.mark.parametrize("degrees", STARS, ids=str)
def test_symmetric_junctions_have_mirrored_phases_and_minor_roads(
    degrees: tuple[float, ...], mirror: str
) -> None:
    for shift in range(len(degrees)):
        order = [(shift - place) % len(degrees) for place in range(len(degrees))]
        check_mirrored(list(degrees), MIRRORS[mirror], order)


@settings(max_examples=25, deadline=None)
@given(
    st.lists(st.integers(0, 71).map(lambda n: 5.0 * n), min_size=3, max_size=5, unique=True),
    st.sampled_from(sorted(MIRRORS)),
    st.randoms(use_true_random=False),
)
def test_any_junction_has_mirrored_phases_and_minor_roads(
    degrees: list[float], mirror: str, random: object
) -> None:
    around = sorted(degrees)
    gaps = [(b - a) % 360 for a, b in zip(around, around[1:] + around[:1], strict=True)]
    assume(min(gaps) >= 35.0)
    order = list(range(len(degrees)))
    random.shuffle(order)  # type: ignore[attr-defined]
    check_mirrored(degrees, MIRRORS[mirror], order)


def test_in_left_hand_traffic_right_turns_yield_to_oncoming_traffic() -> None:
    junction = junction_of((0, 90, 180, 270), True)
    found = yields(junction.connections, junction.conflicts, left_hand=junction.left_hand)
    assert found == junction.yields
    by_id = {one.id: one for one in junction.connections}
    oncoming = [
        (by_id[a].turn, by_id[b].turn)
        for a, b in found
        if math.cos(by_id[a].start[2] - by_id[b].start[2]) < -0.9
    ]
    assert {first for first, _ in oncoming} == {"right"}
