"""Draws strokes, extracts them, compares with the truth: `python -m benchmarks.drawings`."""

from __future__ import annotations

import argparse
from dataclasses import dataclass, field

import cv2
import numpy as np
from scipy.spatial.distance import cdist

from benchmarks.drawings.strokes import SHAPES, Floats, Pen, Stroke, drawn, strokes_of
from roadlang.geometry import RoadNetwork
from roadlang.geometry.arrays import cross
from roadlang.ir.picture import Picture
from roadlang_standard.extract_auto import Auto

PENS = (
    Pen(1, False), Pen(1.5, True), Pen(2, False), Pen(3, True), Pen(6, True), Pen(7, False),
    Pen(12, True), Pen(20, False),
)  # fmt: skip
_ALONG = np.cos(np.radians(25.0))


@dataclass
class Figures:
    """What is seen on the drawings of one row; deviations in pixels, curvatures in 1/px."""

    straight: list[float] = field(default_factory=list)
    """farthest from a straight stroke, of each stroke"""
    bent: list[float] = field(default_factory=list)
    """greatest curvature on a straight stroke, of each stroke"""
    curved: list[float] = field(default_factory=list)
    """farthest from a curved stroke"""
    uneven: list[float] = field(default_factory=list)
    """greatest difference of curvature on an arc, as a share of it; for lines by hand, how much
    greater the greatest curvature is than it should be"""
    missing: int = 0
    points: int = 0

    def add(self, stroke: Stroke, network: RoadNetwork, picture: Picture, pen: Pen) -> None:
        """Compares a stroke with the roads."""
        away, curvature = compared(stroke, network, picture, 1.5 * pen.width + 3)
        self.points += len(away)
        self.missing += int(np.isnan(away).sum())
        if np.isnan(away).all():
            return
        if not stroke.free and stroke.curvature.max() == 0:
            self.straight.append(float(np.nanmax(away)))
            self.bent.append(float(np.nanmax(curvature)))
            return
        self.curved.append(float(np.nanmax(away)))
        truth = stroke.curvature[stroke.inner]
        if stroke.free:
            self.uneven.append(float(np.nanmax(curvature) / truth.max() - 1))
        else:
            self.uneven.append(float(np.nanmax(np.abs(curvature / truth - 1))))


def compared(
    stroke: Stroke, network: RoadNetwork, picture: Picture, near: float
) -> tuple[Floats, Floats]:
    """Distance (n,) of the inner points from the road that runs along them, and its curvature.

    NaN where there is none within `near` pixels. The picture's scale is 1.
    """
    tangents = np.gradient(stroke.points, axis=0)
    tangents /= np.hypot(*tangents.T)[:, None]
    truth = picture.to_world(stroke.points[stroke.inner])
    ahead = tangents[stroke.inner] * [1.0, -1.0]
    away = np.full(len(truth), np.nan)
    curvature = np.full(len(truth), np.nan)
    closest = np.full(len(truth), np.inf)
    for edge in network.edges:
        s = edge.curve.stations(0.25)
        points, along, bend = edge.curve.at(s), edge.curve.tangent(s), edge.curve.curvature(s)
        distance = cdist(truth, points)
        distance[np.abs(ahead @ along.T) < _ALONG] = np.inf
        nearest = np.argmin(distance, axis=1)
        least = distance[np.arange(len(truth)), nearest]
        better = least < np.minimum(near, closest)
        closest[better] = least[better]
        across = cross(ahead, points[nearest] - truth)
        away[better], curvature[better] = np.abs(across[better]), np.abs(bend[nearest][better])
    return away, curvature


def _row(name: str, figures: Figures) -> str:
    cells = []
    for values in (figures.straight, figures.bent, figures.curved, figures.uneven):
        if values:
            cells.append(f"{np.median(values):9.3f} {np.quantile(values, 0.95):8.3f}")
        else:
            cells.append(" " * 18)
    return f"{name:14}" + " ".join(cells) + f"{figures.missing / max(1, figures.points):8.1%}"


def main() -> None:
    """Prints a row for each shape, and for each pen."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--drawings", type=int, default=3, help="of each shape and pen")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shapes", nargs="*", default=list(SHAPES))
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    cv2.setNumThreads(1)
    by_shape = {shape: Figures() for shape in options.shapes}
    by_pen = {str(pen): Figures() for pen in PENS}
    for shape in options.shapes:
        for pen in PENS:
            for number in range(options.drawings):
                seed = options.seed * 1009 + number
                strokes = strokes_of(shape, seed, pen)
                picture = Picture(drawn(strokes, pen), 1.0)
                network = Auto().extract(picture).network
                this = Figures()
                for stroke in strokes:
                    for figures in (this, by_shape[shape], by_pen[str(pen)]):
                        figures.add(stroke, network, picture, pen)
                if options.verbose:
                    print(_row(f"{shape} {pen} {number}", this), flush=True)
    print("median and 95 % of strokes; pixels, and curvature in 1/px")
    heads = ("off line", "its curvature", "off curve", "unevenness", "missing")
    print(f"{'':14}" + " ".join(f"{head:>18}" for head in heads[:4]) + f"{heads[4]:>8}")
    for name, figures in (*by_shape.items(), *by_pen.items()):
        print(_row(name, figures))


if __name__ == "__main__":
    main()
