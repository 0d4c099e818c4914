"""`read with csv`: a road from a table of points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Reader, String, geometry, option

if TYPE_CHECKING:
    from pathlib import Path


@dataclass(frozen=True)
class Csv(Reader):
    """A road from a table of points: columns x and y in meters, and optionally the width."""

    name: ClassVar[str] = "csv"
    suffixes: ClassVar[tuple[str, ...]] = (".csv", ".tsv", ".txt")
    reads: ClassVar[tuple[str, ...]] = ("road",)
    x: String = option("x", help="name of the x column (east, in meters)")
    y: String = option("y", help="name of the y column (north, in meters)")
    width: String = option("width", help="name of the width column (in meters), if there is one")

    def read(self, path: Path) -> Any:
        """A `Curve`, or a `Road` where there are widths; closed where the last row is the first."""
        from roadlang_standard.csv_table import read_table

        table = read_table(path)
        points = table.columns(self.x, self.y)
        closed = is_loop(points)
        curve = geometry.Curve.through(points, closed)
        width = table.width(self.width)
        if width is None:
            return curve
        if closed and len(width) > len(curve.points):
            width = width[: len(curve.points)]
        profile = geometry.WidthProfile.even(width, curve.length, closed)
        return geometry.Road(curve, profile)


def is_loop(points: Any) -> bool:
    """Whether the last point is the first again, or no farther than two usual steps from it."""
    import numpy as np

    if len(points) < 8:
        return bool(len(points) > 3 and np.allclose(points[0], points[-1]))
    steps = np.hypot(*np.diff(points, axis=0).T)
    gap = float(np.hypot(*(points[0] - points[-1])))
    return gap <= 2.0 * float(np.median(steps))
