"""A picture as extractors see it, and what they give back."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from ..diagnostics import Diagnostic
from .read_only import Frozen

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ..geometry import RoadNetwork
    from ..geometry.earth.pixel_map import PixelMap


@dataclass(frozen=True)
class Picture(Frozen):
    """`pixels`: (height, width, 3) uint8 BGR, row 0 at the top.

    `characters` is the grid of a picture typed as text (its `pixels` are then None).
    `legend` maps a character or a color ("#2e7d32", "white") to "road" or an object kind.
    `scale` is meters per pixel. Pixel (0, 0) has its center at image coordinates (0, 0); in the
    world the picture's bottom-left pixel corner is the origin, x east, y north.

    Georeferenced pictures whose up is not north have `north_up`, the map to the north-aligned
    rectangle around them, whose bottom-left corner is then the origin. Those whose pixels were not
    square were resampled; `file` maps pixels to those of the file. What users state and read is in
    pixels of the file: see `from_file` and `to_file`.
    """

    pixels: NDArray[np.uint8] | None
    scale: float
    legend: Mapping[str, str] = field(default_factory=dict)
    characters: tuple[str, ...] | None = None
    path: str = ""
    file: PixelMap | None = None
    north_up: PixelMap | None = None

    @property
    def height(self) -> int:
        """Rows."""
        if self.characters is not None:
            return len(self.characters)
        assert self.pixels is not None
        return int(self.pixels.shape[0])

    @property
    def width(self) -> int:
        """Columns."""
        if self.characters is not None:
            return max((len(row) for row in self.characters), default=0)
        assert self.pixels is not None
        return int(self.pixels.shape[1])

    def to_world(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 2) image coordinates (x right, y down) to meters."""
        import numpy as np

        points, height = np.asarray(points, dtype=float), self.height
        if self.north_up is not None:
            points, height = self.north_up.apply(points), self.north_up.height
        x = (points[..., 0] + 0.5) * self.scale
        y = (height - 0.5 - points[..., 1]) * self.scale
        return np.stack([x, y], axis=-1)

    def to_pixels(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 2) meters to image coordinates."""
        import numpy as np

        points = np.asarray(points, dtype=float)
        height = self.height if self.north_up is None else self.north_up.height
        x = points[..., 0] / self.scale - 0.5
        y = height - 0.5 - points[..., 1] / self.scale
        upright = np.stack([x, y], axis=-1)
        return upright if self.north_up is None else self.north_up.undo(upright)

    def from_file(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 2) pixels of the file, as users state them, to image coordinates."""
        return points if self.file is None else self.file.undo(points)

    def to_file(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 2) image coordinates to pixels of the file."""
        return points if self.file is None else self.file.apply(points)

    @property
    def file_size(self) -> tuple[int, int]:
        """Columns and rows of the file."""
        if self.file is None:
            return self.width, self.height
        return self.file.width, self.file.height

    @property
    def file_scale(self) -> float:
        """Meters per pixel of the file: the root of the area of a pixel on the ground."""
        return self.scale if self.file is None else self.scale / self.file.factor

    def network(
        self, polylines: Iterable[NDArray[np.float64]], width: float | None = None
    ) -> Extraction:
        """An extraction of roads given as (n, 2) polylines in image coordinates.

        Ends that coincide (to half a pixel) become one junction. `width` is in pixels.
        """
        from ..geometry import network_of_polylines
        from ..geometry.arrays import finite_points

        checked = (
            finite_points(line, f"the points of polyline {index}")
            for index, line in enumerate(polylines)
        )
        world = [self.to_world(line) for line in checked]
        meters = None if width is None else width * self.scale
        return Extraction(network_of_polylines(world, meters, tolerance=0.5 * self.scale))


@dataclass(frozen=True)
class FoundObject:
    """An object of a legend or map: `kind`, and its outline's center and size in meters.

    `height` in meters; None: that of the kind.
    """

    kind: str
    x: float
    y: float
    length: float
    width: float
    heading: float = 0.0
    height: float | None = None


@dataclass(frozen=True)
class Extraction(Frozen):
    """Roads in meters, objects of the legend, confidence of the extractor (0 to 1), remarks.

    `mask`: (height, width) bool, the pixels of the roads, if the extractor computes them: tiles are
    built from it. `width_errors`: meters, the standard deviation of what was measured of each
    road's width, in the order of the network's edges, where the extractor knows it. `has_widths` is
    False where the picture says nothing of the widths, as one typed in characters: those of the
    edges are then the most that there is room for, and their lanes say how wide the roads are.
    `confidences`: of each road, in the same order, at even arc lengths from its start to its end,
    where they differ along it: each edge's `confidence` is about their mean. `warnings`: of parts
    of a map that could not be used, with their places.
    """

    network: RoadNetwork
    objects: tuple[FoundObject, ...] = ()
    confidence: float = 1.0
    remarks: tuple[str, ...] = ()
    mask: NDArray[np.bool_] | None = None
    width_errors: tuple[float, ...] = ()
    has_widths: bool = True
    warnings: tuple[Diagnostic, ...] = ()
    confidences: tuple[NDArray[np.float64], ...] = ()
