"""Drives as small pictures, all at one scale."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..drive.robustness_colors import color_shares, robustness_color
from ..geometry.arrays import Floats
from ..geometry.curves.simplifying import simplified
from ..ir.trace import AgentTrace
from .decimation import samples_of
from .drive_records import DriveView
from .elements import drawing, element, text
from .numbers import quantity
from .outlines import surfaces

Place = Callable[[Floats], Floats]
WIDTH = 160.0
_FLATTEST, _TALLEST = 0.45, 1.1
"""The shape of a picture: height by width."""
_FEW_ROADS = 3
_MARGIN = 12.0
"""Meters around what is shown."""
_PIXEL = 0.7
_MOST_SAMPLES, _MOST_OF_OTHERS = 160, 40
"""Of the path of the agent that the picture is about, and of every other."""


@dataclass(frozen=True)
class Frame:
    """The part of the plane, in meters, that each picture shows around its own middle."""

    wide: float
    tall: float

    @property
    def scale(self) -> float:
        """Pixels of a meter."""
        return WIDTH / self.wide


def frame_of(views: Sequence[DriveView]) -> Frame:
    """The smallest frame in which each drive fits."""
    sizes = np.array([(box[1] - box[0]).tolist() for box in map(box_of, views)])
    wide, tall = (sizes.max(axis=0) + 2 * _MARGIN).tolist()
    tall = max(tall, _FLATTEST * wide)
    return Frame(max(wide, tall / _TALLEST), tall)


def box_of(view: DriveView) -> Floats:
    """(2, 2) the least and the greatest x and y of what matters: a road or few with all that moves
    there; of many roads what is near the paths."""
    scene, trace = view.drive.scene, view.drive.trace
    objects = {object_.name for object_ in scene.standing}
    paths = [_path(agent) for name, agent in trace.agents.items() if name not in objects]
    roads = [road for road in scene.roads if road.derived] or list(scene.roads)
    lines = [path for path in paths if len(path)]
    if len(roads) <= _FEW_ROADS or not lines:
        lines += [np.stack([road.x, road.y], axis=-1) for road in roads]
    points = np.concatenate(lines) if lines else np.zeros((1, 2))
    return np.stack([points.min(axis=0), points.max(axis=0)])


def picture(view: DriveView, frame: Frame) -> str:
    """An SVG element; the page has the words."""
    box = box_of(view)
    middle = box.mean(axis=0)
    scale, tall = frame.scale, frame.tall * frame.scale
    corner = middle + np.array([-frame.wide, frame.tall]) / 2.0

    def place(points: Floats) -> Floats:
        return np.asarray((points - corner) * np.array([scale, -scale]))

    parts = [*_roads(view, place, tall), *_paths(view, place)]
    return drawing(
        *parts,
        viewBox=f"0 0 {WIDTH:.0f} {tall:.0f}",
        aria_hidden="true",
        focusable="false",
    )


def _roads(view: DriveView, place: Place, tall: float) -> Iterator[str]:
    for surface in surfaces(view.drive.scene):
        ring = place(surface)
        low, high = ring.min(axis=0), ring.max(axis=0)
        if (high < 0.0).any() or low[0] > WIDTH or low[1] > tall:
            continue
        yield element("path", d=_data(ring) + "Z", class_="surface")


def _paths(view: DriveView, place: Place) -> Iterator[str]:
    objects = {object_.name for object_ in view.drive.scene.standing}
    series = None if view.worst is None else view.worst.series
    for name, agent in view.drive.trace.agents.items():
        line = _path(agent)
        if name in objects or not len(line):
            continue
        if name != view.agent or series is None:
            indices = samples_of(len(line), _MOST_OF_OTHERS, (), ())
            yield element("path", d=_data(place(line[indices])), class_="other path")
            continue
        finite = np.isfinite(agent.x) & np.isfinite(agent.y)
        indices = samples_of(len(line), _MOST_SAMPLES, [series[finite]], ())
        yield from _colored(place(line[indices]), color_shares(series)[finite][indices])
    if view.moment is not None and view.moment.actors and view.drive.has_failed:
        actor, at = view.moment.actors[0], view.moment.sample
        x, y = place(np.array([float(actor.x[at]), float(actor.y[at])])).tolist()
        yield element("circle", cx=f"{x:.1f}", cy=f"{y:.1f}", r="5", class_="moment")


def _colored(line: Floats, shares: Floats) -> Iterator[str]:
    """Runs of one color; each reaches to the next."""
    edges = np.flatnonzero(np.diff(shares)) + 1
    for run in np.split(np.arange(len(shares)), edges):
        part = line[run[0] : int(run[-1]) + 2]
        color = robustness_color(float(shares[run[0]]))
        yield element("path", d=_data(part), class_="path", stroke=color)


def _data(points: Floats) -> str:
    points = points[simplified(points, _PIXEL)] if len(points) > 2 else points
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points.tolist())


def _path(agent: AgentTrace) -> Floats:
    line = np.stack([agent.x, agent.y], axis=-1)
    return np.asarray(line[np.isfinite(line).all(axis=1)])


def gallery(views: Sequence[DriveView], frame: Frame, numbers: Sequence[int]) -> str:
    """A list of links, each a picture with its caption. `numbers`: of the drives on the page."""
    items = []
    for number, view in zip(numbers, views, strict=True):
        worst = view.worst
        words = [element("strong", text(view.drive.label))]
        if worst is not None and worst.verdict.robustness is not None:
            rho = quantity(worst.verdict.robustness, worst.unit)
            words += [element("span", text(f"{worst.verdict.name} {rho}"), class_="rho")]
        words += [element("span", text(view.place))] if view.place else []
        link = element(
            "a", picture(view, frame), *words, href=f"#drive-{number}", data_drive=number
        )
        items.append(element("li", link))
    return element("ul", *items, class_="gallery")
