"""Which roads of a scene are drawn in full, which as a route, a ghost or pale context."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneRoad

_NEAR = 1.5


@dataclass(frozen=True)
class Selection:
    """Names of roads, in the scene's order.

    `versions` are several derived roads of one root, which overlap; `routes` run on a network that
    is drawn in full.
    """

    full: tuple[str, ...]
    versions: tuple[str, ...]
    routes: tuple[str, ...]
    ghosts: tuple[str, ...]
    context: tuple[str, ...]

    @property
    def measured(self) -> tuple[str, ...]:
        """The roads that get marks of arc length: versions and routes share those of the first."""
        return (*self.full, *self.versions[:1], *self.routes[:1])


def select(scene: Scene) -> Selection:
    """Derived roads in full, the roots of what differs from them as ghosts, the rest as context."""
    roads = {road.name: road for road in scene.roads}
    built = {road.name for road in scene.roads if road.derived}
    shown = [road for road in scene.roads if road.derived or _runs_over(road, built)]
    shown = shown or list(scene.roads)
    streets = [road for road in shown if road.network is not None]
    singles = [road for road in shown if road.network is None]
    routes = [road for road in singles if _runs_on(road, streets)]
    versions = [
        road
        for road in singles
        if road not in routes and sum(other.root == road.root for other in singles) > 1
    ]
    full = [road for road in shown if road not in routes and road not in versions]
    names = {road.name for road in shown}
    ghosts = [
        roads[root]
        for root in dict.fromkeys(road.root for road in shown)
        if root in roads and root not in names
    ]
    ghosts = [ghost for ghost in ghosts if _was_changed(ghost, shown)]
    drawn = names | {ghost.name for ghost in ghosts}
    rest = [road for road in scene.roads if road.name not in drawn and road.network is not None]
    return Selection(
        full=tuple(road.name for road in full),
        versions=tuple(road.name for road in versions),
        routes=tuple(road.name for road in routes),
        ghosts=tuple(ghost.name for ghost in ghosts),
        context=tuple(road.name for road in rest if not _runs_on(road, [*ghosts, *shown])),
    )


def _runs_over(road: SceneRoad, built: set[str]) -> bool:
    """Whether a road only repeats roads that are built."""
    return bool(road.along) and built.issuperset(part.road for part in road.along)


def _was_changed(root: SceneRoad, shown: Iterable[SceneRoad]) -> bool:
    return any(road.root == root.name and (road.x, road.y) != (root.x, root.y) for road in shown)


def _runs_on(road: SceneRoad, others: Iterable[SceneRoad]) -> bool:
    """Whether the center line stays within a step of that of other roads."""
    import numpy as np

    lines = [(np.asarray(other.x), np.asarray(other.y)) for other in others]
    if not lines:
        return False
    x, y = map(np.concatenate, zip(*lines, strict=True))
    spacing = max(np.hypot(np.diff(x), np.diff(y)).max(initial=0.0) for x, y in lines)
    every = max(1, len(road.x) // 60)
    across = np.subtract.outer(road.x[::every], x)
    along = np.subtract.outer(road.y[::every], y)
    nearest = (across * across + along * along).min(axis=1)
    return bool((nearest < (_NEAR + spacing / 2) ** 2).all())
