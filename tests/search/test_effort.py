"""How many candidates are judged at once, and how many are tried before a scene is given up."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from roadlang.judging.acceptance import Acceptance
from roadlang.search.effort import (
    batch_size,
    count_or_none,
    default_attempts,
    later_batch_size,
    quicker_share,
)

Requirements = Callable[[str], Acceptance]


def straight(name: str, length: str, spacing: str = "1m") -> str:
    points = f"[(0m, 0m), ({length}, 0m)]"
    return (
        f"road {name} {{ draw with waypoints {{ points: {points} }} station_spacing: {spacing} }}\n"
    )


@pytest.mark.parametrize(
    ("length", "spacing", "first", "later"),
    [
        ("60m", "1m", 512, 4096),
        ("199m", "1m", 512, 1280),
        ("2000m", "1m", 512, 512),
        ("3999m", "1m", 256, 256),
        ("1999.9m", "0.1m", 51, 51),
    ],
)
def test_as_many_are_judged_at_once_as_fit_the_cache(
    acceptance: Requirements, length: str, spacing: str, first: int, later: int
) -> None:
    text = straight("main", length, spacing) + "require fit: length(main) > 1m\n"
    found = acceptance(text)
    assert (batch_size(found), later_batch_size(found)) == (first, later)


def test_the_longest_road_that_is_looked_at_counts(acceptance: Requirements) -> None:
    roads = straight("short", "50m") + straight("long", "3999m") + straight("unused", "9000m")
    both = "require fit: length(short) < length(long)\n"
    assert batch_size(acceptance(roads + both)) == 256
    assert batch_size(acceptance(roads + "require fit: length(short) > 1m\n")) == 512
    assert batch_size(acceptance(roads)) == 512


def test_candidates_whose_stations_differ_are_judged_one_by_one(acceptance: Requirements) -> None:
    drawn = "param end = 90m..200m\n" + straight("main", "end")
    found = acceptance(drawn + "require fit: length(main) > 1m\n")
    assert (batch_size(found), later_batch_size(found), default_attempts(found)) == (1, 1, 1000)


@pytest.mark.parametrize(
    ("rule", "work"),
    [
        ("length(main) > 1m", 5.0 * 200),
        ("always (distance(main, far) > 1m)", (3.0 * 4000.0 + 4.0) * 200),
        ("always (distance(main, long) > 1m)", (3.0 * 4000.0 + 4.0) * 4000),
    ],
)
def test_attempts_follow_from_the_work_for_a_candidate(
    acceptance: Requirements, rule: str, work: float
) -> None:
    roads = straight("main", "199m") + straight("far", "10m") + straight("long", "3999m")
    found = acceptance(roads + f"require this: {rule}\n")
    assert default_attempts(found) == int(np.clip(5e8 / work, 100, 10_000))
    assert quicker_share(found) == pytest.approx(1.0 / (40 + 1.3e5 / (300 + work)))


def test_few_are_tried_where_each_needs_a_picture_of_its_own(
    acceptance: Requirements, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    cv2.imwrite("plan.png", np.zeros((40, 40), np.uint8))
    text = (
        'image plan from "plan.png" { scale: 1m/px, adjust with brightness { factor: 0.5..1 } }\n'
    )
    text += "network town from plan\nroad main from town\nrequire fit: length(main) > 1m\n"
    assert default_attempts(acceptance(text)) == 20


@pytest.mark.parametrize(("value", "count"), [(None, None), (0, 0), (7, 7), (np.int64(3), 3)])
def test_a_count_of_a_kind_is_a_whole_number_or_none(value: object, count: int | None) -> None:
    assert count_or_none(value, "limit") == count


def test_a_count_of_a_kind_is_not_below_zero() -> None:
    with pytest.raises(ValueError, match="its limit is -1"):
        count_or_none(-1, "limit")
    with pytest.raises(TypeError):
        count_or_none(1.5, "limit")
