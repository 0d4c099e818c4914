"""Perturbs a drawn, a typed and a made-up network many times and checks what joins the junctions:
`python -m benchmarks.junctions.perturbed`."""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import cv2
import numpy as np
import shapely

from benchmarks.junctions.extracted_networks import drawing
from benchmarks.junctions.random_networks import KINDS, random_network
from roadlang.api import Extraction, Extractor, Picture
from roadlang.ir.scene import Scene, SceneRoad
from roadlang.testing import sample

_LIMIT = 0.01
_TYPED = """
image plan from \"\"\"
  ....#.......#....
  #################
  ....#.......#....
  ....#.......#....
  ....#############
  ....#.......#....
\"\"\" { scale: 12m/px, legend: { "#": road } }
network town from plan { lanes: 2 }
"""
_DRAWN = """
image plan from "town.png" { scale: 0.4m/px }
network town from plan { lanes: 2 }
"""
_MADE_UP = """
image plan from "town.png" { scale: 0.4m/px }
network town from plan {
  extract with made_up
  lanes: 2
}
"""
_BENT = """
network bent from town {
  perturb with sine { amplitude: 0.5m..3m, wavelength: 40m..100m }
}
"""


def made_up(shape: str, number: int) -> type[Extractor]:
    """An extractor that finds a random network, whatever the picture."""

    @dataclass(frozen=True)
    class MadeUp(Extractor):
        """A random network."""

        name: ClassVar[str] = "made_up"

        def extract(self, picture: Picture) -> Extraction:
            """The network alone."""
            return Extraction(random_network(shape, number).network)

    return MadeUp


@dataclass
class Faults:
    """Over all variants: the worst, in meters and 1/m, and how many variants have any fault."""

    corner: float = 0.0
    overlap: float = 0.0
    curvature: float = 0.0
    faulty: int = 0
    changed: int = 0

    def add(self, scene: Scene, first: Scene) -> None:
        """Checks the network `bent` of a scene; `first` is one whose junctions it should share."""
        (network,) = (n for n in scene.networks if n.name == "bent")
        (other,) = (n for n in first.networks if n.name == "bent")
        self.changed += network.junctions != other.junctions
        roads = {road.name: road for road in scene.roads if road.network == "bent"}
        corner = overlap = curvature = 0.0
        for junction in network.junctions:
            area = shapely.Polygon(junction.area).buffer(-_LIMIT / 2)
            near = []
            for arm in junction.arms:
                corners, strip = _face(roads[arm.road], arm.end)
                given = np.array([junction.area[arm.left], junction.area[arm.right]])
                corner = max(corner, float(np.abs(corners - given).max()))
                near.append(strip)
            for place, strip in enumerate(near):
                overlap = max(overlap, _depth(strip, area))
                overlap = max([overlap, *(_depth(strip, more) for more in near[:place])])
            bends = [abs(k) for c in junction.connections for _, k in c.pieces]
            curvature = max([curvature, *bends])
        self.corner, self.overlap = max(self.corner, corner), max(self.overlap, overlap)
        self.curvature = max(self.curvature, curvature)
        self.faulty += corner > _LIMIT or overlap > _LIMIT or curvature > 0.25 + 1e-9


def _depth(a: Any, b: Any) -> float:
    """How wide the overlap of two surfaces is, meters: twice its area over its perimeter."""
    common = shapely.intersection(a, b)
    return float(2.0 * common.area / common.length) if common.area > 1e-9 else 0.0


def _face(road: SceneRoad, end: str) -> tuple[np.ndarray, Any]:
    """The left and right corner (2, 2) of a road where its junction ends, seen from inside, and its
    surface over the next 15 m."""
    s, x, y = (np.array(values) for values in (road.stations, road.x, road.y))
    half, heading = np.array(road.width) / 2.0, np.array(road.heading)
    normal = np.column_stack([-np.sin(heading), np.cos(heading)])
    left = np.column_stack([x, y]) + half[:, None] * normal
    right = np.column_stack([x, y]) - half[:, None] * normal
    if end == "end":
        s, left, right = s[-1] - s[::-1], right[::-1], left[::-1]
    trim = road.trim[0] if end == "start" else road.trim[1]
    beyond = road.trim[1] if end == "start" else road.trim[0]
    chosen = (s >= trim - 1e-9) & (s <= min(trim + 15.0, s[-1] - beyond) + 1e-9)
    ring = np.concatenate([left[chosen], right[chosen][::-1]])
    strip = shapely.Polygon(ring).buffer(0) if len(ring) > 3 else shapely.Polygon()
    return np.array([left[chosen][0], right[chosen][0]]), strip


def _networks(options: argparse.Namespace) -> Iterator[tuple[str, str, type[Extractor]]]:
    """Names, texts and what is made up in them."""
    if not options.kinds:
        town = made_up("town", 5)
        yield from (("typed", _TYPED, town), ("drawn", _DRAWN, town), ("made up", _MADE_UP, town))
    for kind in options.kinds:
        yield kind, _MADE_UP, made_up(kind, options.seed)


def main() -> None:
    """Prints a row for each network."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--variants", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--kinds", nargs="*", choices=list(KINDS), default=[],
        help="random networks of these kinds, by the seed, in place of the three",
    )  # fmt: skip
    options = parser.parse_args()
    print(
        "network         variants junctions faulty corner m overlap m curvature  plans changed  s"
    )
    with tempfile.TemporaryDirectory() as folder:
        network = random_network("town", 5).network
        picture = drawing(network, {edge.id: 7.0 for edge in network.edges})
        cv2.imwrite(str(Path(folder) / "town.png"), picture)
        for name, text, shape in _networks(options):
            begun = time.process_time()
            scenes = sample(
                text + _BENT, options.variants, kinds=[shape], seed=options.seed, folder=folder
            )
            spent, faults, first = time.process_time() - begun, Faults(), None
            for scene in (found.record for found in scenes):
                first = first or scene
                faults.add(scene, first)
            assert first is not None
            places = sum(len(n.junctions) for n in first.networks if n.name == "bent")
            print(
                f"{name:15} {len(scenes):8} {places:9} {faults.faulty:6} {faults.corner:8.1e} "
                f"{faults.overlap:9.1e} {faults.curvature:9.3f} {faults.changed:14} {spent:.1f}",
                flush=True,
            )


if __name__ == "__main__":
    main()
