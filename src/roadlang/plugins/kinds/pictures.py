"""Kinds that make roads of pictures and files: `adjust`, `extract`, `read`."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from .base import Kind

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ...geometry import Curve, Road, RoadNetwork
    from ...ir.picture import Extraction, Picture


class Adjuster(Kind):
    """`adjust with`: changes an image. Set `is_random` where it draws from `random`, so that each
    scene has a different image."""

    verb: ClassVar[str] = "adjust"
    required_methods: ClassVar[tuple[str, ...]] = ("adjust",)

    def adjust(self, pixels: NDArray[np.uint8], random: np.random.Generator) -> NDArray[np.uint8]:
        """The image after the change.

        `pixels` is (height, width, 3) uint8 in OpenCV's order blue, green, red; it is a copy that
        may be changed in place. Returns an array of the same shape and type; another is RL474.
        """
        raise NotImplementedError


class Extractor(Kind):
    """`extract with`: finds the roads of an image.

    `is_pure`: what it finds depends on the picture and its options alone, on no file and no setting
    elsewhere. Its result for a picture may then be reused.
    """

    verb: ClassVar[str] = "extract"
    required_methods: ClassVar[tuple[str, ...]] = ("extract",)
    is_pure: ClassVar[bool] = False

    def extract(self, picture: Picture) -> Extraction:
        """Find the roads of a picture and, with a legend, its objects.

        Returns an `Extraction`: `picture.network(polylines, width)` makes one of polylines in image
        coordinates. An extraction without roads is RL412 at the statement, with its `remarks` as
        help. Raise `DiagnosticError` for faults of the picture.
        """
        raise NotImplementedError


class Reader(Kind):
    """`read with`: reads an image, network or road from a file.

    Without `read with`, the file of a road or network is read by the kind that has its ending in
    `suffixes`; an image always needs `read with`.
    """

    verb: ClassVar[str] = "read"
    required_methods: ClassVar[tuple[str, ...]] = ("read",)
    geometry_is_user_input: ClassVar[bool] = True
    suffixes: ClassVar[tuple[str, ...]] = ()
    """endings of file names in lower case, with the dot: `(".geojson", ".json")`"""
    reads: ClassVar[tuple[str, ...]] = ("road",)
    """the statements that it reads for: "image", "network", "road" or several"""

    def read(self, path: Path) -> Curve | Road | RoadNetwork | Extraction | NDArray[np.uint8]:
        """What the file at `path` holds; roadlang has checked that it exists and can be read.

        For `road` a `geometry.Curve`, or a `geometry.Road` that has a width and lanes as well; for
        `network` a `geometry.RoadNetwork`, as `geometry.network_of_polylines` makes it, or an
        `Extraction`; for `image` an array (height, width, 3) or (height, width) of uint8. Anything
        else is RL474. Raise `DiagnosticError` or `geometry.GeometryError` for faults of the file.
        """
        raise NotImplementedError

    def companions(self, path: Path) -> Iterable[str]:
        """Other files that `read` opens because the file at `path` refers to them: absolute paths,
        or paths relative to it. Their digests are recorded with those of all inputs."""
        return ()
