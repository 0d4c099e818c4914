"""Small pictures of drives: one frame for all, everything in its place."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from roadlang.drive.robustness_colors import robustness_color
from roadlang.ir.scene import Verdict
from roadlang.ir.trace import AgentTrace, Trace
from roadlang.judging.deciding_moment import DecidingMoment
from roadlang.report.drive_records import DriveView, Judged
from roadlang.report.pictures import Frame, box_of, frame_of, gallery, picture
from roadlang.report.results import ShownDrive
from tests.backends.handmade_scenes import actor, bend, road

TIME = np.arange(5.0)


def moving(name: str, x: Any, y: float) -> AgentTrace:
    standing = AgentTrace.standing(actor(name, "car", 0.0, y), TIME)
    return replace(standing, x=np.asarray(x, dtype=float))


def seen(*agents: AgentTrace, roads: int = 1, series: Any = None, **changes: Any) -> DriveView:
    """Roads of 160 m beside one another, 10 m apart; `series` of the first agent."""
    lines = tuple(
        replace(road(f"r{n}", lambda x, n=n: 10.0 * n, 160.0), derived=True)  # type: ignore[misc]
        for n in range(roads)
    )
    scene = replace(bend(), roads=lines, agents=(), objects=(), networks=())
    trace = Trace(TIME, {agent.name: agent for agent in agents})
    verdict = Verdict("apart", "", "drive", -2.5, False)
    drive = ShownDrive("one", "No. 1", 0, scene, trace, (verdict,), True)
    worst = None if series is None else Judged(verdict, "m", np.asarray(series, dtype=float))
    return replace(DriveView(drive, (), worst, None, agents[0].name if agents else ""), **changes)


def drawn(view: DriveView, frame: Frame) -> ElementTree.Element:
    return ElementTree.fromstring(picture(view, frame))


def points(part: ElementTree.Element) -> list[tuple[float, float]]:
    return [
        (float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", part.get("d", ""))
    ]


def test_a_few_roads_are_shown_whole_and_many_only_near_the_paths() -> None:
    ego = moving("ego", [20, 30, 40, 50, 60], 5.0)
    assert box_of(seen(ego)).tolist() == [[0.0, 0.0], [160.0, 5.0]]
    assert box_of(seen(ego, roads=3)).tolist() == [[0.0, 0.0], [160.0, 20.0]]
    assert box_of(seen(ego, roads=4)).tolist() == [[20.0, 5.0], [60.0, 5.0]]
    assert box_of(seen(roads=4)).tolist() == [[0.0, 0.0], [160.0, 30.0]]


def test_places_that_are_not_known_are_nowhere() -> None:
    lost = moving("ego", [20, np.nan, 40, np.inf, 300], 5.0)
    assert box_of(seen(lost, roads=4)).tolist() == [[20.0, 5.0], [300.0, 5.0]]


@pytest.mark.parametrize(
    ("boxes", "wide", "tall"),
    [
        # 12 m more on each side; at least 0.45 times as tall as wide,
        ([(160.0, 0.0)], 184.0, 82.8),
        ([(160.0, 76.0)], 184.0, 100.0),
        # at most 1.1 times; the widest and the tallest of all drives.
        ([(10.0, 196.0)], 200.0, 220.0),
        ([(160.0, 10.0), (10.0, 116.0)], 184.0, 140.0),
    ],
)
def test_all_drives_fit_in_one_frame(
    boxes: list[tuple[float, float]], wide: float, tall: float
) -> None:
    views = []
    for right, up in boxes:
        one, other = moving("a", [0, 0, 0, 0, 0], 0.0), moving("b", [right] * 5, up)
        views.append(seen(one, other, roads=4))
    frame = frame_of(views)
    assert (frame.wide, frame.tall) == pytest.approx((wide, tall))
    assert frame.scale == pytest.approx(160.0 / wide)


FRAME = Frame(160.0, 80.0)
"""A pixel is a meter; the middle of a road of 160 m along y = 0 is at (80, 40)."""


def test_roads_and_paths_lie_where_they_are_with_y_up() -> None:
    picture_ = drawn(seen(moving("ego", [0, 40, 80, 120, 160], 3.0)), FRAME)
    assert picture_.get("viewBox") == "0 0 160 80"
    surface, path = picture_.findall("path")
    # The middle of all that is shown is 1.5 m above that of the road.
    assert points(surface) == [(0.0, 38.0), (160.0, 38.0), (160.0, 45.0), (0.0, 45.0)]
    assert (path.get("class"), points(path)) == ("other path", [(0.0, 38.5), (160.0, 38.5)])


def test_roads_outside_the_frame_are_left_out() -> None:
    near = moving("ego", [70, 75, 80, 85, 90], 0.0)
    assert len(drawn(seen(near, roads=12), FRAME).findall("path[@class='surface']")) == 5
    assert len(drawn(seen(near, roads=4), Frame(40.0, 8.0)).findall("path[@class='surface']")) == 1


def test_the_path_that_is_judged_has_the_colors_of_its_robustness() -> None:
    ego, other = moving("ego", [0, 40, 80, 120, 160], 0.0), moving("other", [0, 1, 2, 3, 4], 2.0)
    view = seen(ego, other, series=[4.0, 4.0, -4.0, -4.0, 0.0])
    parts = drawn(view, FRAME).findall("path")[1:]
    assert [part.get("stroke") for part in parts] == [
        robustness_color(1.0), robustness_color(-1.0), robustness_color(0.0), None,
    ]  # fmt: skip
    assert [[x for x, _ in points(part)] for part in parts[:3]] == [
        [0.0, 80.0], [80.0, 160.0], [160.0],
    ]  # fmt: skip


@pytest.mark.parametrize("has_failed", [True, False])
def test_a_ring_is_where_a_failing_drive_goes_wrong(has_failed: bool) -> None:
    ego = moving("ego", [0, 40, 80, 120, 160], 0.0)
    moment: Any = DecidingMoment(3, (ego,))
    view = seen(ego, series=[1.0, 1.0, 1.0, -1.0, -1.0], moment=moment)
    view = replace(view, drive=replace(view.drive, has_failed=has_failed))
    rings = [(ring.get("cx"), ring.get("cy")) for ring in drawn(view, FRAME).findall("circle")]
    assert rings == [("120.0", "40.0")] * has_failed


def test_captions_name_the_drive_and_what_is_violated_by_how_much() -> None:
    ego = moving("ego", [0, 40, 80, 120, 160], 0.0)
    page = gallery([seen(ego, series=[1.0] * 5), seen(ego)], FRAME, [4, 9])
    items = ElementTree.fromstring(page).findall("li/a")
    assert [item.get("href") for item in items] == ["#drive-4", "#drive-9"]
    assert [item.get("data-drive") for item in items] == ["4", "9"]
    said = [[part.text for part in item if part.tag != "svg"] for item in items]
    assert said == [["No. 1", "apart \N{MINUS SIGN}2.5\N{NO-BREAK SPACE}m"], ["No. 1"]]
