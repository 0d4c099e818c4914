"""Where agents begin, and which line of their road they should follow."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans
from ...ir.category import ON_FOOT
from ...ir.scene import SceneActor, SceneRoad
from ...ir.scene_route import RouteStep
from ..lanes.road_forms import RoadForms
from ..vehicles.motion import Motion, Track
from ..vehicles.poses import foot_points


def start_of(
    actors: Sequence[SceneActor], track: Track, backward: Booleans, has_road: Booleans
) -> Motion:
    """The state at the start: each at the pose of its scene, at its speed."""
    pose = np.array([(actor.x, actor.y, actor.heading) for actor in actors], dtype=np.float64)
    station = np.array([actor.start or 0.0 for actor in actors], dtype=np.float64)
    length = track.lines.length[track.row]
    along = np.where(backward, length - station, station) * has_road
    for row, actor in enumerate(actors):
        if actor.route is not None:  # its line begins with its first step
            along[row] = abs(station[row] - actor.route.steps[0].start)
    # The station of the scene is nearly that of the foot point of the pose.
    along, offset, heading = foot_points(track, pose[:, 0], pose[:, 1], along)
    error = pose[:, 2] - heading
    zero = np.zeros(len(actors))
    return Motion(
        along, offset, np.array([start_speed(actor) for actor in actors]), zero, zero.copy(),
        np.cos(error), np.sin(error), zero.copy(), heading, zero.copy(),
    )  # fmt: skip


def start_speed(actor: SceneActor) -> float:
    """Speed at the start, m/s; 0 where the scene does not say."""
    return float(actor.start_speed or 0.0)


class LineOffsets:
    """How far left of its guide the line lies that an agent should follow; of an agent without a
    guide, of the center line of its road.

    The guide is the middle of its lane, if it has one and lanes change their widths. Else it is the
    middle of its lane where it starts, or where it has none where it stands; from beside the road,
    that of the nearest lane for its direction, on foot the middle of the road; with a route, that
    of its lanes. Cross-sections that many roads share are built once.
    """

    def __init__(self) -> None:
        self._forms = RoadForms()
        self._known: dict[Any, float] = {}

    def of(self, actor: SceneActor, road: SceneRoad | None, width: float, guide: int) -> float:
        """Of one agent; `width`: of the road where it starts."""
        if road is None or guide >= 0:
            return 0.0
        if actor.route is not None:
            return self._beside_route(actor.lane, actor.route.steps[0], road, actor.start or 0.0)
        if actor.lane is not None:
            center = self._lane_center(actor.lane, road, actor.start or 0.0)
            if center is not None:
                return center
        offset = actor.offset or 0.0
        if abs(offset) < width / 2:
            return offset
        if actor.category in ON_FOOT:
            return 0.0
        section, backward = road.cross_section(), actor.facing == "back"
        return section.entered_from(offset, actor.start or 0.0, backward=backward)

    def _beside_route(
        self, lane: int | None, step: RouteStep, road: SceneRoad, station: float
    ) -> float:
        """Of who begins in another lane than its route: on a sidewalk, or in a lane for bicycles.
        It keeps as far beside the lanes of the route, junctions included."""
        if lane in (None, 0, step.lane):
            return 0.0
        assert lane is not None
        own, middle = (self._lane_center(id, road, station) for id in (lane, step.lane))
        if own is None or middle is None:
            return 0.0
        return own - middle if step.stop >= step.start else middle - own

    def _lane_center(self, lane: int, road: SceneRoad, station: float) -> float | None:
        key = lane, self._forms.number(road)
        found = self._known.get(key)
        if found is None:
            section = road.cross_section()
            if lane not in section.ids:
                return None
            found = float(section.offset(lane, station))
            widths = [len(lane_.width) for lane_ in road.lane_list]
            if widths and max(widths) == 1 and len(road.center_offset) <= 1:  # everywhere
                self._known[key] = found
        return found
