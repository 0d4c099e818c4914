"""Where two that come toward each other do not fit side by side: two straight lines, in all
directions."""

from __future__ import annotations

import math

import numpy as np
import pytest

from roadlang.geometry.curves.bend_room import PASSING_GAP
from roadlang.simulation.traffic.narrow_places import COARSE, WIDEST, narrow_places
from roadlang.simulation.traffic.sampled_ways import SPACING, SampledWays
from roadlang.simulation.vehicles import compiled

HALF, REACH, APART = 5.0, 40.0, 30.0
DIRECTIONS = [0.0, 0.5 * math.pi, 2.0, math.pi, -0.5 * math.pi, -2.5]
Found = list[list[list[float]]] | None


def found(
    direction: float, beside: float, turned: float = math.pi,
    left: tuple[float, float] = (1.5, 1.5), right: tuple[float, float] = (1.5, 1.5),
    apart: float = APART, reach: float = REACH,
) -> Found:  # fmt: skip
    """The places of one that heads in a direction, and of another 30 m ahead and `beside` meters to
    its left, which is turned, compiled too to the last bit. `left`, `right`: what each covers."""
    s = (np.arange(0.0, reach, SPACING) - HALF)[:, None] * np.ones(2)
    heading = np.array([direction, direction + turned])
    ahead, across = np.array([0.0, apart]), np.array([0.0, beside])
    x = ahead * math.cos(direction) - across * math.sin(direction) + s * np.cos(heading)
    y = ahead * math.sin(direction) + across * math.cos(direction) + s * np.sin(heading)
    cosine, sine = np.cos(heading) + 0.0 * s, np.sin(heading) + 0.0 * s
    to_left, to_right = np.array(left) + 0.0 * s, np.array(right) + 0.0 * s
    lines = SampledWays(np.arange(2), s, x, y, cosine, sine, to_left, to_right, s > math.inf)
    pairs = np.array([0]), np.array([1])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiled, "is_loaded", lambda: False)
        places = narrow_places(lines, *pairs)
        if compiled.is_installed():
            patch.setattr(compiled, "is_loaded", lambda: True)
            fast = narrow_places(lines, *pairs)
            assert (places is None) == (fast is None)
            if places is not None and fast is not None:
                meets = np.isfinite(places[0])
                for one, other in zip(places, fast, strict=True):
                    np.testing.assert_array_equal(other[meets], one[meets])
                np.testing.assert_array_equal(np.isfinite(fast[0]), meets)
    return None if places is None else [np.round(part, 6).tolist() for part in places]


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_two_that_are_too_wide_for_their_lanes_meet_where_their_lines_pass(
    direction: float,
) -> None:
    """Each sees the other on its left; their right sides do not count."""
    narrow = 3.0 + PASSING_GAP
    assert found(direction, narrow + 0.01, right=(3.0, 3.0)) is None
    both = found(direction, narrow - 0.2, right=(3.0, 3.0))
    assert both is not None
    enter = np.array(both)[0]
    np.testing.assert_allclose(enter[0], enter[1], err_msg="each is as far from it")
    assert both == found(0.0, narrow - 0.2)


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("left", [(2.5, 0.5), (0.5, 2.5)])
def test_the_sides_that_face_each_other_add_up(direction: float, left: tuple[float, float]) -> None:
    assert found(direction, 3.0 + PASSING_GAP - 0.2, left=left) is not None
    assert found(direction, 3.0 + PASSING_GAP + 0.01, left=left) is None
    assert found(direction, -3.0 - PASSING_GAP + 0.2, left=left) is not None, (
        "their right sides face"
    )
    assert found(direction, -3.0 - PASSING_GAP - 0.01, left=left) is None


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("turned", [0.0, 0.5 * math.pi, -0.5 * math.pi, 0.6 * math.pi])
def test_those_who_do_not_come_toward_each_other_do_not_count(
    direction: float, turned: float
) -> None:
    assert found(direction, 0.0, turned) is None


def test_lines_far_apart_have_room_for_anything() -> None:
    wide = (9.0, 9.0)
    assert found(0.0, WIDEST - 0.1, left=wide) is not None
    assert found(0.0, WIDEST + 0.1, left=wide) is None


def test_lines_that_come_close_at_their_very_ends_are_not_overlooked() -> None:
    """Where the last samples are beyond those that are looked at first."""
    samples = np.arange(0.0, REACH + SPACING, SPACING) - HALF
    assert (len(samples) - 1) % COARSE == COARSE - 1
    apart = 2.0 * samples[-1] + 7.5  # between the last samples
    meets, do_not = (
        found(0.0, 0.0, left=(9.0, 9.0), apart=away, reach=REACH + SPACING)
        for away in (apart, apart + 1.0)
    )
    assert meets is not None
    assert do_not is None
