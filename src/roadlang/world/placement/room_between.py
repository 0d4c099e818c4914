"""What agents and objects keep clear of, and how much room they lack."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...evaluate.candidates import CandidateBatch
from ...geometry import Footprints, close_pairs, distance_between, separation
from ...geometry.arrays import Floats, Integers
from ...ir.scenario import ScenarioImage, ScenarioNetwork
from ..networks.networks import network_root
from ..placement_faults import DEFAULT_APART

LEGEND = -1
COPY = -2
"""Numbers, instead of those of agents and objects, of what a legend names and of copies of the same
group"""


@dataclass
class PlacedRectangles:
    """Things that were placed: their rectangles, candidates, distances to keep, and numbers."""

    boxes: list[Footprints] = field(default_factory=list)
    rows: list[Integers] = field(default_factory=list)
    apart: list[Floats] = field(default_factory=list)
    numbers: list[Integers] = field(default_factory=list)

    def beginning(self, *others: PlacedRectangles) -> PlacedRectangles:
        """A copy with others, to be added to."""
        self.joined()  # or each copy would join thousands of arrays again
        every = (*others, self)
        return PlacedRectangles(
            [boxes for item in every for boxes in item.boxes],
            [rows for item in every for rows in item.rows],
            [apart for item in every for apart in item.apart],
            [numbers for item in every for numbers in item.numbers],
        )

    def add(self, number: int, placed: dict[str, NDArray[Any]]) -> None:
        """Add an agent or object, `placed` as an `Arrangement` has it."""
        present = placed["present"].astype(bool)
        names = ("x", "y", "heading", "length", "width")
        boxes = Footprints(*(placed[name][present] for name in names))
        self.add_rows(number, boxes, np.nonzero(present)[0], placed["apart"][present])

    def add_rows(self, number: int, boxes: Footprints, rows: Integers, apart: Floats) -> None:
        """Add things by themselves."""
        counted = apart != -np.inf
        if counted.any():
            self.boxes.append(boxes.take(counted))
            self.rows.append(rows[counted])
            self.apart.append(apart[counted])
            self.numbers.append(np.full(int(counted.sum()), number))

    def joined(self) -> tuple[Footprints, Integers, Floats, Integers]:
        """All of them as single arrays."""
        if len(self.boxes) != 1:
            names = ("x", "y", "heading", "length", "width")
            columns = [[getattr(box, name) for box in self.boxes] for name in names]
            self.boxes = [Footprints(*(_joined(column) for column in columns))]
            self.rows, self.apart = [_joined(self.rows, np.int64)], [_joined(self.apart)]
            self.numbers = [_joined(self.numbers, np.int64)]
        return self.boxes[0], self.rows[0], self.apart[0], self.numbers[0]


def legend_neighbors(candidates: CandidateBatch, varying: bool) -> PlacedRectangles:
    """What the legends of pictures name. `varying`: also where the picture differs between
    candidates, which are then evaluated singly."""

    def make() -> PlacedRectangles:
        found = PlacedRectangles()
        scenario = candidates.scenario
        networks = [n for n in scenario.networks.values() if not _is_derived(n, candidates)]
        for network in networks:
            if _has_legend(network, candidates) and (
                varying or not scenario.is_varying(network.name)
            ):
                objects = network_root(network, candidates).objects
                parts = [(o.x, o.y, o.heading, o.length, o.width) for o in objects]
                rectangles = np.array(parts, dtype=float).reshape(-1, 5)
                several = np.tile(rectangles, (candidates.count, 1))
                rows = np.repeat(np.arange(candidates.count), len(rectangles))
                apart = np.full(len(several), np.nan)
                found.add_rows(LEGEND, Footprints(*several.T), rows, apart)
        return found

    return candidates.once(("legend neighbors", varying), make, inherited=False)


def _is_derived(network: ScenarioNetwork, candidates: CandidateBatch) -> bool:
    return isinstance(candidates.scenario.source_of(network), ScenarioNetwork)


def _has_legend(network: ScenarioNetwork, candidates: CandidateBatch) -> bool:
    images = (
        link for link in candidates.scenario.chain(network) if isinstance(link, ScenarioImage)
    )
    return any("legend" in image.options for image in images)


def missing_room(
    boxes: Footprints, rows: Integers, apart: Floats, placed: PlacedRectangles
) -> tuple[Floats, Integers]:
    """(n,) meters that things lack to what is placed, 0 where they fit, and the number of what
    they are too near to, -1 for nothing."""
    others, other_rows, other_apart, numbers = placed.joined()
    margin = max(_greatest(apart), _greatest(other_apart), DEFAULT_APART)
    i, j = close_pairs(boxes, others, margin, rows, other_rows)
    lacking = _lacking(boxes.take(i), others.take(j), apart[i], other_apart[j])
    return _most_missing(len(rows), i, lacking, numbers[j])


def room_among(boxes: Footprints, rows: Integers, apart: Floats) -> tuple[Floats, Integers]:
    """The same to those before them among each other."""
    i, j = close_pairs(boxes, boxes, max(_greatest(apart), DEFAULT_APART), rows, rows)
    earlier = j < i
    i, j = i[earlier], j[earlier]
    lacking = _lacking(boxes.take(i), boxes.take(j), apart[i], apart[j])
    return _most_missing(len(rows), i, lacking, np.full(len(i), COPY))


def _lacking(a: Footprints, b: Footprints, apart_a: Floats, apart_b: Floats) -> Floats:
    """(n,) meters that pairs are nearer than they are to be, 0 or less for those that are not."""
    required = np.fmax(apart_a, apart_b)
    apart = np.where(np.isnan(required), DEFAULT_APART, required)
    apart = np.where((apart_a == -np.inf) | (apart_b == -np.inf), -np.inf, apart)
    gap = separation(a, b)
    lacking = apart - gap
    # Of what overlaps the separation is what counts, and in crowds that is most of it.
    near = np.flatnonzero((lacking > 0.0) & (gap > 0.0))
    lacking[near] = apart[near] - distance_between(a.take(near), b.take(near))
    return lacking


def _most_missing(
    count: int, index: Integers, lacking: Floats, numbers: Integers
) -> tuple[Floats, Integers]:
    """(count,) the greatest lack of each thing, and to what."""
    missing, blocker = np.zeros(count), np.full(count, -1)
    # Less than a hundredth of a millimeter is rounding: rows stand exactly as far apart as said.
    wrong = np.flatnonzero(lacking > 1e-5)
    wrong = wrong[np.argsort(lacking[wrong], kind="stable")]
    missing[index[wrong]] = lacking[wrong]
    blocker[index[wrong]] = numbers[wrong]
    return missing, blocker


def _greatest(apart: Floats) -> float:
    required = apart[np.isfinite(apart)]
    return float(required.max(initial=0.0))


def _joined(parts: list[Any], kind: Any = np.float64) -> NDArray[Any]:
    return np.concatenate(parts) if parts else np.zeros(0, kind)
