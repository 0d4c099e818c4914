"""Random networks of fifteen kinds: what drawings and maps hold, and what is hard to join."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from roadlang.geometry import Curve, Edge, Node, RoadNetwork, WidthProfile, chain
from roadlang.geometry.curves.segments import Arc, Straight
from roadlang.geometry.lanes.cross_section import CrossSection


@dataclass(frozen=True)
class RandomNetwork:
    """A network with the cross-section of each road."""

    kind: str
    network: RoadNetwork
    sections: dict[int, CrossSection]


@dataclass
class Sketch:
    """Nodes and curves between them, and a generator to draw their lanes with."""

    rng: np.random.Generator
    most_lanes: int = 6
    one_way_share: float = 0.5
    nodes: list[tuple[float, float]] = field(default_factory=list)
    edges: list[tuple[int, int, Curve, int, float, bool]] = field(default_factory=list)

    def node(self, x: float, y: float) -> int:
        """A new node; its id."""
        self.nodes.append((float(x), float(y)))
        return len(self.nodes) - 1

    def road(
        self,
        start: int,
        end: int,
        curve: Curve | None = None,
        lanes: int | None = None,
        one_way: bool | None = None,
    ) -> None:
        """A straight road unless a curve is given; lanes of 2.75 to 3.75 m."""
        if curve is None:
            curve = Curve.through([self.nodes[start], self.nodes[end]])
        if one_way is None:
            one_way = bool(self.rng.random() < 0.5 * self.one_way_share)
        if lanes is None:
            lanes = int(self.rng.integers(1, self.most_lanes + 1))
        width = lanes * float(self.rng.uniform(2.75, 3.75)) * (1.3 if lanes == 1 else 1.0)
        self.edges.append((start, end, curve, lanes, width, one_way))

    def arm(self, node: int, heading: float, length: float = 120.0, **road: Any) -> None:
        """A straight road away from a node."""
        x, y = self.nodes[node]
        end = self.node(x + length * np.cos(heading), y + length * np.sin(heading))
        self.road(node, end, **road)

    def bent(self, node: int, heading: float, angle: float, over: float, **road: Any) -> None:
        """A road away from a node that soon turns by `angle` over so many meters."""
        pieces: list[Straight | Arc] = [
            Straight(5.0),
            Arc(over / abs(angle), angle),
            Straight(80.0),
        ]
        curve = chain(pieces, self.nodes[node], heading).curve()
        end = self.node(*curve.points[-1])
        self.road(node, end, curve, **road)

    def result(self, kind: str) -> RandomNetwork:
        """What was drawn."""
        nodes = tuple(Node(id, place) for id, place in enumerate(self.nodes))
        edges, sections = [], {}
        for id, (start, end, curve, lanes, width, one_way) in enumerate(self.edges, 1):
            widths = np.full(2, width)
            edges.append(Edge(id, start, end, curve, widths))
            profile = WidthProfile.even(widths, curve.length, curve.closed)
            sections[id] = CrossSection.of_lane_count(lanes, profile, oneway=one_way)
        return RandomNetwork(kind, RoadNetwork(nodes, tuple(edges)), sections)


def star_headings(rng: np.random.Generator, arms: int, least: float) -> np.ndarray:
    """Headings at least `least` degrees apart."""
    free = 360.0 - arms * least
    gaps = least + free * np.diff(np.sort(np.concatenate([[0, 1], rng.random(arms - 1)])))
    return np.radians(rng.uniform(0, 360) + np.cumsum(gaps))


def _star(least: float) -> Callable[[Sketch], None]:
    def draw(sketch: Sketch) -> None:
        middle = sketch.node(0.0, 0.0)
        for heading in star_headings(sketch.rng, int(sketch.rng.integers(3, 7)), least):
            sketch.arm(middle, float(heading))

    return draw


def _row(count: int) -> Callable[[Sketch], None]:
    """Junctions 5 to 30 m apart."""

    def draw(sketch: Sketch) -> None:
        rng = sketch.rng
        sketch.most_lanes = 4
        places, heading = [sketch.node(0.0, 0.0)], float(rng.uniform(0, 6.28))
        headings = [heading]
        for _ in range(count - 1):
            x, y = sketch.nodes[places[-1]]
            gap = float(rng.uniform(5.0, 30.0))
            places.append(sketch.node(x + gap * np.cos(heading), y + gap * np.sin(heading)))
            headings.append(heading)
            sketch.road(places[-2], places[-1])
            heading += float(rng.uniform(-0.4, 0.4))
        sketch.arm(places[0], headings[0] + np.pi + float(rng.uniform(-0.3, 0.3)))
        sketch.arm(places[-1], heading)
        for place in places:
            sides = rng.choice([-1.0, 1.0], 2) if rng.random() < 0.4 else [rng.choice([-1.0, 1.0])]
            for side in set(sides):
                sketch.arm(place, headings[0] + float(side * rng.uniform(0.9, 2.2)))

    return draw


def _ramp(sketch: Sketch) -> None:
    middle, rng = sketch.node(0.0, 0.0), sketch.rng
    heading = float(rng.uniform(0, 6.28))
    main = int(rng.integers(2, 5))
    one_way = bool(rng.random() < 0.7)
    sketch.arm(middle, heading + np.pi, lanes=main, one_way=False)
    sketch.arm(middle, heading, lanes=main, one_way=False)
    angle = float(np.radians(rng.uniform(7.0, 16.0)) * rng.choice([-1.0, 1.0]))
    sketch.arm(middle, heading + angle, lanes=1, one_way=one_way)


def _bent(sketch: Sketch) -> None:
    middle, rng = sketch.node(0.0, 0.0), sketch.rng
    sketch.most_lanes = 4
    for heading in star_headings(rng, int(rng.integers(3, 5)), 60.0):
        angle = float(rng.uniform(0.8, 1.6) * rng.choice([-1.0, 1.0]))
        sketch.bent(middle, float(heading), angle, float(rng.uniform(25.0, 60.0)))


def _loop(sketch: Sketch) -> None:
    rng = sketch.rng
    middle, heading = sketch.node(0.0, 0.0), float(rng.uniform(0, 6.28))
    radius = float(rng.uniform(12.0, 40.0))
    angles = heading + np.pi + np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    center = radius * np.array([np.cos(heading), np.sin(heading)])
    ring = center + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    ring[0] = (0.0, 0.0)
    if rng.random() < 0.5:
        curve = Curve.through(ring, closed=True)
    else:
        spread = 0.6 * radius * np.array([-np.sin(heading), np.cos(heading)])
        far = 2.5 * center
        curve = Curve.through(
            np.array([(0.0, 0.0), center + spread, far, center - spread, (0.0, 0.0)])
        )
    sketch.road(middle, middle, curve, lanes=int(rng.integers(1, 3)), one_way=False)
    for side in rng.uniform(-0.8, 0.8, int(rng.integers(1, 3))) + np.array([0.0]):
        sketch.arm(middle, heading + np.pi + float(side), lanes=int(rng.integers(1, 4)))


def _double(sketch: Sketch) -> None:
    """Two roads between the same two nodes."""
    rng = sketch.rng
    sketch.most_lanes = 3
    gap, heading = float(rng.uniform(60.0, 120.0)), float(rng.uniform(0, 6.28))
    along = np.array([np.cos(heading), np.sin(heading)])
    left = np.array([-along[1], along[0]])
    first, second = sketch.node(0.0, 0.0), sketch.node(*(gap * along))
    for side in (1.0, -1.0):
        bulge = float(rng.uniform(12.0, 30.0))
        middle = gap / 2.0 * along + side * bulge * left
        sketch.road(first, second, Curve.through(np.array([(0.0, 0.0), middle, gap * along])))
    sketch.arm(first, heading + np.pi)
    sketch.arm(second, heading)


def _roundabout(sketch: Sketch) -> None:
    rng = sketch.rng
    sketch.most_lanes, sketch.one_way_share = 2, 0.0
    radius, count = float(rng.uniform(10.0, 30.0)), int(rng.integers(3, 6))
    headings = star_headings(rng, count, 360.0 / count * 0.7)
    lanes = int(rng.integers(1, 3))
    places = [sketch.node(radius * np.cos(h), radius * np.sin(h)) for h in headings]
    for place, heading in enumerate(headings):
        after = headings[(place + 1) % count]
        turn = float((after - heading) % (2.0 * np.pi))
        arc = chain([Arc(radius, turn)], sketch.nodes[places[place]], float(heading + np.pi / 2))
        points = np.array(arc.points)
        points[-1] = sketch.nodes[places[(place + 1) % count]]
        curve = Curve.hermite(points, arc.heading)
        sketch.road(places[place], places[(place + 1) % count], curve, lanes=lanes)
        sketch.arm(places[place], float(heading + rng.uniform(-0.2, 0.2)))


def _grid(sketch: Sketch) -> None:
    rng = sketch.rng
    sketch.most_lanes = 4
    rows, columns = 2, 3
    xs = np.cumsum(rng.uniform(50.0, 110.0, columns))
    ys = np.cumsum(rng.uniform(50.0, 110.0, rows))
    places = [[sketch.node(*(np.array([x, y]) + rng.normal(0.0, 5.0, 2))) for x in xs] for y in ys]
    for row in range(rows):
        for column in range(columns):
            if column:
                sketch.road(places[row][column - 1], places[row][column])
            if row:
                sketch.road(places[row - 1][column], places[row][column])
    for row in range(rows):
        sketch.arm(places[row][0], np.pi + float(rng.normal(0.0, 0.1)))
        sketch.arm(places[row][-1], float(rng.normal(0.0, 0.1)))


def _town(sketch: Sketch) -> None:
    """Random points joined to their neighbors without crossings (a Delaunay graph, thinned)."""
    from scipy.spatial import Delaunay

    rng = sketch.rng
    sketch.most_lanes = 3
    points = rng.uniform(0.0, 300.0, (9, 2))
    for x, y in points:
        sketch.node(x, y)
    pairs = {
        tuple(sorted((int(a), int(b))))
        for triangle in Delaunay(points).simplices
        for a, b in zip(triangle, np.roll(triangle, 1), strict=True)
    }
    leaving: dict[int, list[float]] = {place: [] for place in range(len(points))}
    for a, b in sorted(pairs):
        x, y = points[b] - points[a]
        heading = float(np.arctan2(y, x))
        ends = ((a, heading), (b, heading + np.pi))
        skew = min((_between(h, other) for n, h in ends for other in leaving[n]), default=180.0)
        if rng.random() < 0.7 and np.hypot(x, y) > 12.0 and skew >= 20.0:
            sketch.road(a, b)
            for node, leave in ends:
                leaving[node].append(leave)
    if not sketch.edges:
        sketch.road(0, 1)


def _between(first: float, second: float) -> float:
    """Degrees."""
    return abs(float(np.degrees((first - second + np.pi) % (2.0 * np.pi) - np.pi)))


def _stubs(sketch: Sketch) -> None:
    rng = sketch.rng
    sketch.most_lanes = 3
    middle = sketch.node(0.0, 0.0)
    headings = star_headings(rng, int(rng.integers(3, 6)), 45.0)
    for place, heading in enumerate(headings):
        sketch.arm(middle, float(heading), float(rng.uniform(3, 15)) if place == 0 else 120.0)


def _joint(sketch: Sketch) -> None:
    """Two arms that differ."""
    rng = sketch.rng
    middle, heading = sketch.node(0.0, 0.0), float(rng.uniform(0, 6.28))
    sketch.arm(middle, heading, one_way=False)
    sketch.arm(middle, heading + np.pi + float(rng.uniform(-1.2, 1.2)), one_way=False)


def _mixed(sketch: Sketch) -> None:
    """A star some of whose arms end at another star."""
    rng = sketch.rng
    sketch.most_lanes = 4
    middle = sketch.node(0.0, 0.0)
    for heading in star_headings(rng, 4, 50.0):
        length = float(rng.uniform(35.0, 90.0))
        place = sketch.node(length * np.cos(heading), length * np.sin(heading))
        sketch.road(middle, place)
        for side in rng.uniform(0.5, 1.2, 2) * np.array([-1.0, 1.0]):
            sketch.arm(place, float(heading + side))


def _oblique(sketch: Sketch) -> None:
    """Two roads that cross at 20 to 60 degrees."""
    middle, rng = sketch.node(0.0, 0.0), sketch.rng
    heading, skew = float(rng.uniform(0, 6.28)), float(np.radians(rng.uniform(20.0, 60.0)))
    for lanes, turn in ((int(rng.integers(1, 5)), 0.0), (int(rng.integers(1, 5)), skew)):
        for side in (0.0, np.pi):
            sketch.arm(middle, heading + turn + side, lanes=lanes, one_way=False)


KINDS: dict[str, Callable[[Sketch], None]] = {
    "star 45": _star(45.0),
    "star 20": _star(20.0),
    "two junctions": _row(2),
    "three junctions": _row(3),
    "ramp": _ramp,
    "bent arms": _bent,
    "loop": _loop,
    "double road": _double,
    "roundabout": _roundabout,
    "grid": _grid,
    "town": _town,
    "stubs": _stubs,
    "joint": _joint,
    "mixed": _mixed,
    "oblique": _oblique,
}


def random_network(kind: str, seed: int) -> RandomNetwork:
    """The network of a kind and a seed."""
    sketch = Sketch(np.random.default_rng([seed, list(KINDS).index(kind)]))
    KINDS[kind](sketch)
    return sketch.result(kind)
