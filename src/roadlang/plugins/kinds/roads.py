"""Kinds that make and change roads: `draw`, its pieces, `select`, `perturb`."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from .base import Kind

if TYPE_CHECKING:
    import numpy as np

    from ... import geometry
    from ...geometry.arrays import Booleans, Floats
    from ...ir.batch import BatchRandom, RoadBatch


class Drawer(Kind):
    """`draw with`: the center line of a road, from the options alone."""

    verb: ClassVar[str] = "draw"
    required_methods: ClassVar[tuple[str, ...]] = ("draw",)
    geometry_is_user_input: ClassVar[bool] = True

    def draw(self, closed: bool) -> geometry.Curve:
        """The center line in meters; `closed` is the road's option.

        Returns a `geometry.Curve`, as `Curve.through(points, closed)` makes it of (n, 2) points; of
        finite length below 10,000 km. Anything else is RL474.
        """
        raise NotImplementedError

    def least_length(self) -> float:
        """A lower bound of the length of the road in meters, computed without numpy; 0 if unknown.

        `check` draws a road to find positions beyond its end only where they are beyond this.
        """
        return 0.0


class Piece(Kind):
    """A piece of a drawn road, written as a call: `arc(40m, 60deg)`."""

    verb: ClassVar[str] = "piece"
    required_methods: ClassVar[tuple[str, ...]] = ("to_segment",)
    geometry_is_user_input: ClassVar[bool] = True

    def to_segment(self, curvature: float) -> geometry.Straight | geometry.Arc | geometry.Clothoid:
        """The piece as the continuation of a road that ends with this curvature (1/m, left
        positive).

        Returns a `geometry.Straight`, `geometry.Arc` or `geometry.Clothoid`.
        """
        raise NotImplementedError

    def least_length(self) -> float:
        """A lower bound of the length of the piece in meters, computed without numpy; 0 if
        unknown."""
        return 0.0


class Selector(Kind):
    """How a road is chosen from a network, written as a call: `route((0m, 0m), (80m, 0m))`."""

    verb: ClassVar[str] = "select"
    required_methods: ClassVar[tuple[str, ...]] = ("select",)
    geometry_is_user_input: ClassVar[bool] = True

    def select(self, network: geometry.RoadNetwork) -> geometry.Path:
        """The path through the network.

        Returns a `geometry.Path` of it: what `network.route` and `network.longest` return, or
        `Path(network, steps)` with consecutive steps. Anything else is RL474.
        """
        raise NotImplementedError


class Region(Kind):
    """A part of the plane, written as a call: `box((0m, 0m), (200m, 100m))`."""

    verb: ClassVar[str] = "region"
    required_methods: ClassVar[tuple[str, ...]] = ("contains",)

    def contains(self, points: Floats) -> Booleans:
        """(n,) whether each of the points (n, 2), meters, lies inside.

        Roads are cut where this changes along them, to the millimeter; parts shorter than half a
        meter may be missed.
        """
        raise NotImplementedError


class Perturber(Kind):
    """`perturb with`: displaces a road.

    Implement `displacement` (one variant, options are plain numbers) or, for speed,
    `displacements` (a batch, random options are (variants, 1) columns). Displacements are meters
    along the left normal, or, with a last axis of two, meters east and north; with `over`, and in a
    network, of the latter only the part along the normal counts.
    """

    verb: ClassVar[str] = "perturb"
    required_methods: ClassVar[tuple[str, ...]] = ("displacement", "displacements")
    geometry_is_user_input: ClassVar[bool] = True
    is_random: ClassVar[bool] = True
    """it draws from `random`: set to False if the options alone determine the displacement"""

    def displacement(self, road: RoadBatch, random: np.random.Generator) -> Floats:
        """The displacement of one variant; the arrays of `road` have one row.

        Returns (stations,) or (stations, 2) finite real meters; anything else is RL474, and more
        than 1,000 km are RL472. `over` and `taper` are applied to it afterwards.
        """
        raise NotImplementedError

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """The displacements of a batch of variants; without it, `displacement` is called for each.

        Returns (variants, stations) or (variants, stations, 2) meters as `displacement` does, with
        one row or without that axis where all variants are equal.
        """
        raise NotImplementedError

    def displacement_bound(self) -> Floats | float:
        """The greatest displacement, meters, that the options allow: a number, or (variants, 1).

        Requirements that it decides need no geometry. It must be monotonic in every option; by
        default no bound is known. A displacement beyond it is RL474.
        """
        return float("inf")

    def displacement_reached(self, length: float, closed: bool, gap: float) -> float:
        """A displacement in meters that some station of a road of `length` meters reaches, if
        stations are at most `gap` meters apart.

        Requirements that it decides are reported before anything is sampled. Options are plain
        numbers, and it must be least at the ends of ranges that do not contain 0; without it
        nothing is known.
        """
        return 0.0

    def shortest_feature(self, length: float, closed: bool) -> Floats | float | None:
        """The shortest wave (one period) or bump (end to end) that the options allow on a road of
        `length` meters: meters along the road, a number or (variants, 1), infinite for none.

        The road is sampled closely enough to show it. It must be monotonic in every option; by
        default it is unknown, and a remark says when the stations miss a displacement.
        """
        return None
