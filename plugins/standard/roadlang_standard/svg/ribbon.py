"""A road as shapes in the drawing: its surface, lines along it, stretches of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from roadlang.api import geometry, surface_stretches

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import Scene, SceneRoad, SurfaceStretch
    from roadlang.geometry import Floats

    from .viewport import Viewport


_CLOSEST_POINTS = 1.2
_NARROWEST = 3.5
_FINEST_TURN, _MOST_PARTS = 0.06, 8


@dataclass(frozen=True)
class Ribbon:
    """A road in pixels: `center` and `left` (unit vectors to the left) are (n, 2).

    `borders` (n, L + 1) are the lateral offsets of the borders of its `lanes`, both from left to
    right, left positive; `markings` the lines there; `half` (n,) half the width of the drivable
    ones. `stations` is arc length of the road and `reference` that of its root, in meters;
    `stretches`: what its lanes are covered by.
    """

    name: str
    center: Floats
    left: Floats
    half: Floats
    borders: Floats
    stations: Floats
    reference: Floats
    lanes: tuple[geometry.Lane, ...]
    markings: tuple[geometry.Marking, ...]
    closed: bool
    widened: bool
    stretches: tuple[SurfaceStretch, ...] = ()

    def outline(self, inset: float = 0.0) -> Floats:
        """The polygon of all lanes, `inset` pixels narrower on each side."""
        return self.band(0, len(self.lanes), inset)

    def band(self, first: int, last: int, inset: float = 0.0) -> Floats:
        """The polygon between two borders, by their places from the left, made narrower."""
        import numpy as np

        left, right = self.borders[:, first], self.borders[:, last]
        less = np.minimum(inset, (left - right) / 2.0 - 0.3) if inset else 0.0
        return np.concatenate([self.beside(left - less), self.beside(right + less)[::-1]])

    def beside(self, offset: Floats | float) -> Floats:
        """A line along the road, this many pixels to its left."""
        import numpy as np

        return self.center + np.broadcast_to(offset, self.half.shape)[:, None] * self.left

    def line(self, share: float, shift: float = 0.0) -> Floats:
        """A line along the road, at `share` (-1 right edge, 1 left edge) and `shift` pixels."""
        edge = self.borders[:, 0] if share > 0 else -self.borders[:, -1]
        return self.beside(edge * share + shift)

    @property
    def drivable(self) -> tuple[int, int]:
        """The borders, by their places from the left, between which the drivable lanes lie."""
        import numpy as np

        return geometry.drivable_borders(np.array([lane.drivable for lane in self.lanes]))

    def part(self, start: float, end: float, by_reference: bool = False) -> Ribbon:
        """From arc length `start` to `end` (of the root road's if `by_reference`)."""
        import numpy as np

        axis = self.reference if by_reference else self.stations
        inner = axis[(axis > start) & (axis < end)]
        return self.at(np.concatenate([[start], inner, [end]]), by_reference)

    def at(self, places: Floats, by_reference: bool = False) -> Ribbon:
        """Its cross-sections at arc lengths (of the root road's if `by_reference`)."""
        import numpy as np

        axis = self.reference if by_reference else self.stations
        places = np.clip(places, axis[0], axis[-1])
        # As `np.interp`, of all columns at once.
        before = np.minimum(np.searchsorted(axis, places, "right") - 1, len(axis) - 2)
        table = self._table
        slope = (table[before + 1] - table[before]) / np.diff(axis)[before, None]
        found = slope * (places - axis[before])[:, None] + table[before]
        found[places == axis[-1]] = table[-1]
        return Ribbon(
            name=self.name,
            center=found[:, 0:2],
            left=found[:, 2:4],
            half=found[:, 4],
            stations=found[:, 5],
            reference=found[:, 6],
            borders=found[:, 7:],
            lanes=self.lanes,
            markings=self.markings,
            closed=False,
            widened=self.widened,
            stretches=self.stretches,
        )

    @cached_property
    def _table(self) -> Floats:
        """(n, 8 + L): everything that is interpolated."""
        import numpy as np

        single = (self.half, self.stations, self.reference)
        return np.column_stack([self.center, self.left, *single, self.borders])


class Ribbons(Mapping[str, Ribbon]):
    """The roads of a scene by name, in pixels: each as soon as it is looked up."""

    def __init__(self, scene: Scene, viewport: Viewport) -> None:
        self._roads = {road.name: road for road in scene.roads}
        self._viewport = viewport
        self._made: dict[str, Ribbon] = {}

    def __getitem__(self, name: str) -> Ribbon:
        if name not in self._made:
            self._made[name] = ribbon_of(self._roads[name], self._viewport)
        return self._made[name]

    def __contains__(self, name: object) -> bool:
        return name in self._roads

    def __iter__(self) -> Iterator[str]:
        return iter(self._roads)

    def __len__(self) -> int:
        return len(self._roads)


def ribbon_of(road: SceneRoad, viewport: Viewport) -> Ribbon:
    """A road in pixels, with no more points than the eye can tell apart.

    A road too narrow to be seen at this scale is widened.
    """
    import numpy as np

    stations, points, heading = _finer(road)
    center = viewport.place(points)
    columns = np.column_stack([-np.sin(heading), -np.cos(heading)])
    half = np.interp(stations, road.stations, road.width) / 2 * viewport.pixels_per_meter
    section = road.cross_section()
    borders = section.border_offsets(stations).T * viewport.pixels_per_meter
    reference = np.interp(stations, road.stations, road.reference_stations)
    keep = _spaced(center)
    center, columns, half, borders = center[keep], columns[keep], half[keep], borders[keep]
    stations, reference = stations[keep], reference[keep]
    if road.closed:
        center, columns = np.vstack([center, center[:1]]), np.vstack([columns, columns[:1]])
        half, borders = np.append(half, half[0]), np.vstack([borders, borders[:1]])
        stations = np.append(stations, road.length)
        rest = road.length - road.stations[-1]
        reference = np.append(reference, road.reference_stations[-1] + rest)
    return Ribbon(
        name=road.name,
        center=center,
        left=columns,
        half=np.maximum(half, _NARROWEST / 2),
        borders=borders * np.maximum(_NARROWEST / 2 / half, 1.0)[:, None],
        stations=stations,
        reference=reference,
        lanes=section.lanes,
        markings=section.markings,
        closed=road.closed,
        widened=bool(half.max() < _NARROWEST / 2),
        stretches=surface_stretches(road, section.ids),
    )


def _finer(road: SceneRoad) -> tuple[Floats, Floats, Floats]:
    """Stations (n,), points (n, 2) and headings (n,) of a road, with more of them in tight bends:
    arcs between its own stations, so that no corner is seen."""
    import numpy as np

    s, heading = np.asarray(road.stations), np.unwrap(road.heading)
    points = np.column_stack([road.x, road.y])
    turn, chord = np.diff(heading), np.diff(points, axis=0)
    parts = np.clip(np.ceil(np.abs(turn) / _FINEST_TURN), 1, _MOST_PARTS).astype(int)
    if not len(turn) or parts.max() == 1:
        return s, points, heading
    step = np.append(np.repeat(np.arange(len(parts)), parts), len(parts) - 1)
    place = np.arange(len(step)) - np.append(0, np.cumsum(parts))[step]
    share = place / parts[step]
    # The chord of a part of an arc, turned back from that of the whole and as much shorter.
    half = turn[step] / 2.0
    length = share * np.sinc(share * half / np.pi) / np.sinc(half / np.pi)
    angle = (share - 1.0) * half
    along = chord[step]
    across = np.column_stack([-along[:, 1], along[:, 0]])
    moved = np.cos(angle)[:, None] * along + np.sin(angle)[:, None] * across
    return (
        s[step] + share * np.diff(s)[step],
        points[step] + length[:, None] * moved,
        heading[step] + share * turn[step],
    )


def _spaced(points: Floats) -> NDArray[np.intp]:
    import numpy as np

    steps = np.hypot(*np.diff(points, axis=0).T)
    traveled = np.concatenate([[0.0], np.cumsum(steps)]) / _CLOSEST_POINTS
    cells = np.floor(traveled)
    keep = np.concatenate([[True], cells[1:] > cells[:-1]])
    keep[-1] = True
    return np.flatnonzero(keep)
