"""`check` finds what stands in one place in every scene: cars of 4.5 m on a road of 160 m."""

from __future__ import annotations

import pytest

import roadlang
from roadlang import testing

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 0m)] }, lanes: 2 }\n"
WIDE = "road main { draw with segments { pieces: [straight(100m)] }, lanes: 4 }\n"


def overlaps(first: str, second: str, *, road: str = ROAD) -> list[str]:
    text = f"{road}agent a is car on main at {first}\nagent b is car on main at {second}\n"
    return [found.message for found in testing.check(text) if found.code == "RL616"]


ONE_PLACE = ["`b` overlaps `a`, or is too close to it"]


@pytest.mark.parametrize(
    ("first", "second", "said"),
    [
        ("20m", "20m", ONE_PLACE),
        ("20m", "24.9m", ONE_PLACE),                        # 0.4 m between bumpers: 0.5 are kept
        ("20m", "25.1m", []),
        ("24.9m", "20m", ONE_PLACE),
        ("20m { apart: 2m }", "26m", ONE_PLACE),            # 1.5 m between
        ("20m", "26m { apart: 2m }", ONE_PLACE),
        ("20m { apart: 1m }", "26m { apart: 1m }", []),
        ("20m { apart: 0m }", "24.6m { apart: 0m }", []),
        ("20m { overlap: true }", "20m", []),
        ("20m", "20m { overlap: true }", []),
        ("20m", "20m { overlap: false }", ONE_PLACE),
        ("20m { lane: 1 }", "20m", []),
        ("20m { lane: -1 }", "20m { lane: -1 }", ONE_PLACE),
        ("20m { facing: back }", "20m", []),
        ("20m { facing: back }", "20m { facing: back }", ONE_PLACE),
        ("20m { offset: 1m }", "20m", []),                  # only the same line is compared
        ("19m..21m", "20m", []),                            # a draw has a say
        ("20m { apart: 1m..2m }", "26m", []),
        ("20m { count: 1 }", "20m", []),
        ("10%", "16m", []),                                 # known when the road is built
    ],
)  # fmt: skip
def test_two_cars_at_fixed_places(first: str, second: str, said: list[str]) -> None:
    assert overlaps(first, second) == said


def test_a_kind_that_is_drawn_has_no_fixed_length() -> None:
    text = ROAD + "agent a is choice(car, truck) on main at 20m\nagent b is car on main at 20m\n"
    assert not [found for found in testing.check(text) if found.code == "RL616"]


def test_the_longer_thing_reaches_further() -> None:
    """A truck of 9 m at 20 m ends at 24.5 m, the car at 27.2 m begins at 24.95 m."""
    for place, count in ((27.2, 1), (27.3, 0)):
        text = f"{ROAD}agent a is truck on main at 20m\nagent b is car on main at {place}m\n"
        assert len([each for each in testing.check(text) if each.code == "RL616"]) == count


@pytest.mark.parametrize(
    ("place", "gap"), [("20m", "they overlap by 4.5m"), ("24.9m", "there are 0.4m between them")]
)
def test_the_help_says_how_much_room_there_is(place: str, gap: str) -> None:
    text = f"{ROAD}agent a is car on main at 20m\nagent b is car on main at {place}\n"
    (found,) = testing.check(text)
    assert found.help == (f"{gap}: leave more room, or write `overlap: true` if that is meant",)
    assert found.span is not None
    assert found.span.line == 3


def test_a_row_with_a_negative_spacing_leads_back_to_what_it_is_placed_by() -> None:
    row = "agent cars is car on main at behind(lead, 10m) { count: 2, spacing: -12m }\n"
    text = f"{ROAD}agent lead is car on main at 100m\n{row}"
    with pytest.raises(roadlang.DiagnosticError) as caught:
        roadlang.loads(text).sample(n=1)
    assert "leave out its sign" in str(caught.value)
    roadlang.loads(text.replace("-12m", "12m")).sample(n=1)


BEND = "road main { draw with segments { pieces: [arc(15m, 170deg)] }, lanes: 4 }\n"


@pytest.mark.parametrize(
    ("first", "second", "said"),
    [
        # 4.5 m along the road, and 6.2 m apart in the outer lane of the bend.
        ("10m { lane: -2 }", "14.5m { lane: -2 }", []),
        ("10m { lane: -2 }", "13.5m { lane: -2 }", ONE_PLACE),
        ("10m { lane: 1 }", "14.5m { lane: 1 }", ONE_PLACE),
    ],
)
def test_in_a_bend_the_room_is_that_in_the_lane(first: str, second: str, said: list[str]) -> None:
    assert overlaps(first, second, road=BEND) == said


@pytest.mark.parametrize("missing", [5e-6, 2e-5])
def test_what_is_rounding_when_scenes_are_made_is_no_fault_before(missing: float) -> None:
    said = overlaps("20m", f"{25.0 - missing:.7f}m")
    assert said == (ONE_PLACE if missing > 1e-5 else [])


def test_on_a_road_that_is_drawn_only_what_is_in_one_place_is_certain() -> None:
    sine = "perturb with sine { amplitude: 0m..3m, wavelength: 80m }"
    road = ROAD.replace("lanes: 2", f"lanes: 2, {sine}")
    assert overlaps("20m", "20m", road=road) == ONE_PLACE
    assert overlaps("20m", "24.9m", road=road) == []


@pytest.mark.parametrize(
    ("kind", "options", "spacing"),
    [
        ("pedestrian", "", "1m"),
        ("car", "", "5m"),
        ("bus", "", "13m"),
        ("car", ", apart: 2m", "7m"),
    ],
)
def test_copies_in_one_place_are_told_the_spacing_that_they_need(
    kind: str, options: str, spacing: str
) -> None:
    text = f"{ROAD}agent a is {kind} on main at 40m {{ count: 2{options} }}\n"
    with pytest.raises(roadlang.DiagnosticError) as caught:
        testing.sample(text)
    (found,) = caught.value.diagnostics
    row = f"put its copies in a row with `spacing: {spacing}`"
    assert found.help == (f"{row}, or anywhere with `at random`",)
    spaced = text.replace("count: 2", f"count: 2, spacing: {spacing}")
    assert len(testing.sample(spaced)[0].agents) == 2


@pytest.mark.parametrize(
    ("group", "is_found"),
    [
        ("at 50m { count: 2 }", True),
        ("at 50m { count: integer(1, 3) }", True),
        ("at 50m { count: integer(0, 2), lane: -1 }", True),
        ("at 50m { count: integer(0, 1) }", False),
        ("at 50m { count: 2, overlap: true }", False),
        ("at 30m { count: integer(1, 3), spacing: 8m }", False),
        ("at 10m..90m { count: integer(1, 3) }", False),
        ("at 50m { count: integer(1, 2), lane: choice(-1, -2) }", False),
        ("at 50m { count: integer(1, 2), facing: choice(forward, back) }", False),
    ],
)
def test_copies_in_one_place_are_found_before_only_single_ones_are_left(
    group: str, is_found: bool
) -> None:
    """A drawn count would lose all its values above 1, and no requirement says so."""
    text = f"{WIDE}agent crowd is car on main {group}\n"
    found = [each for each in roadlang.loads(text).check() if each.code == "RL616"]
    assert [each.help[-1] for each in found] == is_found * [
        "put its copies in a row with `spacing: 5m`, or anywhere with `at random`"
    ]
    if not is_found:
        assert len(roadlang.loads(text).sample(4)) == 4
