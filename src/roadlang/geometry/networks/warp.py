"""A smooth deformation of the plane that moves given places together with their surroundings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..arrays import Floats
from ..curves.curve import Curve
from ..errors import GeometryError
from .network import Edge, Node, RoadNetwork

_STEP = 1.0
"""Meters between the points through which a moved road is drawn again, at most."""
_CLOSE = 1e-9
"""Meters by which the origin of a point may be off."""
_GRID = 41
"""Points across the surroundings of a place at which it is looked whether the plane folds."""
_STEEPEST = 1.72
"""Greatest slope of (1 - r^2)^3: the plane folds where a move is longer than the radius by it."""

RADIUS = 80.0
"""Meters around a place that move with it, where nothing is said."""


@dataclass(frozen=True)
class Warp:
    """Places (n, 2) that are moved by (n, 2) meters, with all around within `radius` meters: by
    (1 - r^2)^3 of the move at a share r of the radius. Moves add up.

    Raises GeometryError where the numbers of places and moves differ, or the plane would fold.
    """

    at: Floats
    by: Floats
    radius: float

    @classmethod
    def of(
        cls,
        at: Sequence[tuple[float, float]],
        by: Sequence[tuple[float, float]],
        radius: float | None = None,
    ) -> Warp:
        """Of points as tuples; without a radius, with `RADIUS`."""
        radius = RADIUS if radius is None else radius
        if len(at) != len(by):
            raise GeometryError(f"there are {len(at)} places, but {len(by)} displacements")
        moves = np.array(by, dtype=np.float64).reshape(-1, 2)
        if len(moves) and np.hypot(*moves.T).max() > radius / _STEEPEST:
            most = radius / _STEEPEST
            raise GeometryError(
                f"with a radius of {radius:g} m, a place can move by at most {most:.3g} m"
            )
        warp = cls(np.array(at, dtype=np.float64).reshape(-1, 2), moves, radius)
        if len(moves) > 1 and warp._folds():
            raise GeometryError(
                f"places closer together than {2 * radius:g} m are moved too far: their "
                f"displacements add up, and roads would fold over"
            )
        return warp

    def moved(self, points: Floats) -> Floats:
        """(..., 2) where points come to lie."""
        result = np.array(points, dtype=np.float64)
        for place, move in zip(self.at, self.by, strict=True):
            share, _ = self._share(points - place)
            result += share[..., None] * move
        return result

    def turned(self, points: Floats, tangents: Floats) -> Floats:
        """(..., 2) what becomes of tangents at points."""
        result = np.array(tangents, dtype=np.float64)
        for place, move in zip(self.at, self.by, strict=True):
            _, slope = self._share(points - place)
            along = (slope * tangents).sum(axis=-1)
            result += along[..., None] * move
        return result

    def origin_of(self, point: tuple[float, float]) -> tuple[float, float]:
        """The point that comes to lie at `point`, found by iteration."""
        found = self.origins_of(np.array([point], dtype=np.float64))[0]
        return float(found[0]), float(found[1])

    def origins_of(self, points: Floats) -> Floats:
        """(n, 2) the points that come to lie at (n, 2) `points`."""
        found = points
        for _ in range(60):
            away = points - self.moved(found)
            found = found + away
            if np.abs(away).max(initial=0.0) < _CLOSE:
                break
        return found

    def touches(self, points: Floats) -> bool:
        """Whether any of (n, 2) points is moved."""
        away = np.hypot(*(points[:, None] - self.at).T) if len(self.at) else np.ones(0)
        return bool((away < self.radius).any())

    def network(self, network: RoadNetwork) -> RoadNetwork:
        """The network with its nodes and roads where they come to lie."""
        places = self.moved(np.array([node.position for node in network.nodes], dtype=np.float64))
        nodes = [
            Node(node.id, (float(x), float(y)))
            for node, (x, y) in zip(network.nodes, places, strict=True)
        ]
        positions = {node.id: node.position for node in nodes}
        edges = [self._edge(edge, positions) for edge in network.edges]
        return replace(network, nodes=tuple(nodes), edges=tuple(edges))

    def _edge(self, edge: Edge, positions: dict[int, tuple[float, float]]) -> Edge:
        curve = edge.curve
        count = max(3, int(np.ceil(curve.length / _STEP)) + 1)
        s = np.linspace(0.0, curve.length, count, endpoint=not curve.closed)
        points, headings = curve.at(s), curve.heading(s)
        if not self.touches(points):
            return edge
        tangents = np.stack([np.cos(headings), np.sin(headings)], axis=-1)
        turned = self.turned(points, tangents)
        moved = self.moved(points)
        moved[0] = positions[edge.start]
        if not curve.closed:
            moved[-1] = positions[edge.end]
        angles = np.arctan2(turned[:, 1], turned[:, 0])
        return edge.transformed(Curve.hermite(moved, angles, curve.closed), 1.0, False)

    def _folds(self) -> bool:
        """Whether the plane is turned over anywhere, looked at on a grid around each place."""
        across = np.linspace(-self.radius, self.radius, _GRID)
        grid = np.stack(np.meshgrid(across, across), axis=-1)
        points = self.at[:, None, None] + grid
        x, y = (self.turned(points, np.broadcast_to(axis, points.shape)) for axis in np.eye(2))
        return bool((x[..., 0] * y[..., 1] - x[..., 1] * y[..., 0] <= 0.0).any())

    def _share(self, away: Floats) -> tuple[Floats, Floats]:
        """(...) shares of a move at (..., 2) distances from its place, and their slopes."""
        square = (away**2).sum(axis=-1) / self.radius**2
        rest = np.clip(1.0 - square, 0.0, None)
        return rest**3, (-6.0 * rest**2 / self.radius**2)[..., None] * away
