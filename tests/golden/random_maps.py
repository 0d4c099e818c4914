"""Maps of other tools from random numbers: OpenDRIVE, OpenStreetMap, GeoJSON."""

from __future__ import annotations

import math
import random
from typing import Any

from tests.formats.small_maps import lane, link, linked, piece, road, section, xodr

_TYPES = (
    *("driving", "driving", "driving", "sidewalk", "biking", "bus", "parking", "shoulder"),
    *("bidirectional", "median", "entry", "exit", "restricted", "none", "tram", "curb"),
)
_MARKS = ("solid", "broken", "solid solid", "botts dots", "curb", "none", "grass", "broken solid")
_STEP = 0.01
"""Meters, of the numeric integration that finds where a piece ends."""

Pose = tuple[float, float, float]


def _piece(rng: random.Random, length: float) -> tuple[str, Any]:
    """The element of a piece, and its curvature by the distance from its start."""
    kind = rng.choice(("line", "arc", "spiral", "poly3", "paramPoly3", "arcLength"))
    if kind == "arc":
        k = rng.uniform(-0.03, 0.03)
        return f'<arc curvature="{k!r}"/>', lambda s: k
    if kind == "spiral":
        a, b = rng.uniform(-0.02, 0.02), rng.uniform(-0.03, 0.03)
        shape = f'<spiral curvStart="{a!r}" curvEnd="{b!r}"/>'
        return shape, lambda s: a + (b - a) * s / length
    if kind == "line":
        return "<line/>", lambda s: 0.0
    c, d = rng.uniform(-0.004, 0.004), rng.uniform(-5e-5, 5e-5)
    if kind == "poly3":
        return f'<poly3 a="0" b="0" c="{c!r}" d="{d!r}"/>', (c, d)
    if kind == "arcLength":
        v = f'aV="0" bV="0" cV="{c!r}" dV="{d!r}"'
        return f'<paramPoly3 pRange="arcLength" aU="0" bU="1" cU="0" dU="0" {v}/>', (c, d)
    v = f'aV="0" bV="0" cV="{c * length**2!r}" dV="{d * length**3!r}"'
    range_ = rng.choice(('pRange="normalized" ', ""))
    return f'<paramPoly3 {range_}aU="0" bU="{length!r}" cU="0" dU="0" {v}/>', (c, d)


def _end(pose: Pose, length: float, shape: Any) -> Pose:
    """The pose at the end of a piece."""
    x, y, heading = pose
    if callable(shape):
        count = round(length / _STEP)
        step = length / count
        for i in range(count):
            middle = heading + shape((i + 0.25) * step) * step / 2.0
            x, y = x + step * math.cos(middle), y + step * math.sin(middle)
            heading += shape((i + 0.5) * step) * step
        return x, y, heading
    c, d = shape
    u, run = 0.0, 0.0
    while run < length:
        run += _STEP * math.hypot(1.0, 2.0 * c * u + 3.0 * d * u * u)
        u += _STEP
    v = c * u**2 + d * u**3
    turn = math.atan2(2.0 * c * u + 3.0 * d * u * u, 1.0)
    cosine, sine = math.cos(heading), math.sin(heading)
    return x + cosine * u - sine * v, y + sine * u + cosine * v, heading + turn


def _pieces(rng: random.Random, pose: Pose, count: int) -> tuple[str, float, Pose]:
    """The pieces of a road from a pose, its length, and the pose at its end."""
    found, s = "", 0.0
    for _ in range(count):
        length = round(rng.uniform(8.0, 40.0), 2)
        shape, bend = _piece(rng, length)
        found += piece(s, *pose, length, shape)
        pose = _end(pose, length, bend)
        if rng.random() < 0.15:  # maps of other tools have small gaps and kinks
            pose = (pose[0] + 0.02, pose[1] - 0.03, pose[2] + rng.uniform(-0.02, 0.02))
        s += length
    return found, s, pose


def _polynomials(rng: random.Random, tag: str, start: str, a: float, length: float) -> str:
    """One or two cubics of an element."""
    found = f'<{tag} {start}="0" a="{a}" b="{rng.uniform(-0.01, 0.01)!r}" c="0" d="0"/>'
    if rng.random() < 0.5:
        at, c = rng.uniform(0.2, 0.8) * length, rng.uniform(-0.002, 0.002)
        found += f'<{tag} {start}="{at!r}" a="{a}" b="0.01" c="{c!r}" d="-0.00001"/>'
    return found


def _lane(rng: random.Random, id: int, length: float, outward: float, linked_to: bool) -> str:
    type = "driving" if abs(id) == 1 and rng.random() < 0.8 else rng.choice(_TYPES)
    inside = linked(id, id) if linked_to else ""
    if rng.random() < 0.25:
        unit = rng.choice((' unit="km/h"', ' unit="mph"', ' unit="m/s"', ""))
        limit = rng.choice(("50", "20", "no limit", "0", "900"))
        inside += f'<speed sOffset="0" max="{limit}"{unit}/>'
    draw = rng.random()
    width = rng.choice((2.0, 3.0, 3.5))
    if draw < 0.4:
        across = _polynomials(rng, "width", "sOffset", width, length)
    elif draw < 0.6:
        across = _polynomials(rng, "border", "sOffset", math.copysign(outward, id), length)
    else:
        across = f'<width sOffset="0" a="{width}" b="0" c="0" d="0"/>'
    found = lane(id, across, type, inside)
    mark = f'type="{rng.choice(_MARKS)}"'
    more = f'<roadMark sOffset="{length / 3!r}" type="{rng.choice(_MARKS)}"/></lane>'
    found = found.replace('type="broken"', mark)
    if rng.random() < 0.3:
        found = found.replace("</lane>", more)
    if rng.random() < 0.2:
        written = rng.choice(("both", "reversed", "standard"))
        found = found.replace("<lane ", f'<lane direction="{written}" ')
    return found


def _lanes(rng: random.Random, length: float) -> str:
    """The sections of a road, whose lanes begin and end."""
    offset = _polynomials(rng, "laneOffset", "s", rng.choice((0.0, 1.5)), length)
    found = offset if rng.random() < 0.4 else ""
    begins = [0.0, *sorted(rng.uniform(0.2, 0.8) * length for _ in range(rng.randrange(3)))]
    sides = [rng.randint(0, 2), rng.randint(1, 3)]
    for place, begin in enumerate(begins):
        span = ([*begins, length][place + 1]) - begin
        left, right = sides
        lanes = section(
            begin,
            [_lane(rng, id, span, 3.2 * id, place > 0) for id in range(left, 0, -1)],
            [_lane(rng, -id, span, 3.2 * id, place > 0) for id in range(1, right + 1)],
        )
        center = "/></lane></center>"
        found += lanes.replace(f'"solid"{center}', f'"{rng.choice(_MARKS)}"{center}')
        if rng.random() < 0.5:
            sides[1] = max(1, min(sides[1] + rng.choice((-1, 1)), 3))
    return found


def opendrive_map(seed: int) -> str:
    """Three arms that meet in a junction, one of them in two roads, and a road that stands alone.

    The connecting roads are straight lines between the reference lines.
    """
    rng = random.Random(seed)
    roads, starts = [], list[Pose]()
    for id in (1, 2, 3):
        angle = 2.1 * id + rng.uniform(-0.3, 0.3)
        start = (12.0 * math.cos(angle), 12.0 * math.sin(angle), angle)
        pieces, length, end = _pieces(rng, start, rng.randint(1, 4))
        onward = {"successor": "road 4 start"} if id == 3 else {}
        inside = link(predecessor="junction 9", **onward)
        if rng.random() < 0.5:
            inside += '<type s="0" type="town"><speed max="30" unit="mph"/></type>'
        profile = _polynomials(rng, "elevation", "s", 2.0, length)
        if rng.random() < 0.5:
            inside += f"<elevationProfile>{profile}</elevationProfile>"
        name = rng.choice(("", "High Street"))
        roads.append(road(id, length, pieces, _lanes(rng, length), inside=inside, name=name))
        starts.append(start)
    pieces, length, _ = _pieces(rng, end, 2)
    back = link(predecessor="road 3 end") if seed % 2 else ""
    roads.append(road(4, length, pieces, _lanes(rng, length), inside=back))
    alone = (200.0, -100.0, rng.uniform(-3.0, 3.0))
    pieces, length, _ = _pieces(rng, alone, 1)
    roads.append(road(rng.choice(("west", 77)), length, pieces, _lanes(rng, length)))
    connections = ""
    for number, (one, other) in enumerate(((1, 2), (2, 3), (3, 1), (2, 1))):
        roads.append(_connecting(20 + number, starts[one - 1], starts[other - 1], one, other))
        lane_link = '<laneLink from="1" to="-1"/>' if rng.random() < 0.8 else ""
        connections += (
            f'<connection id="{number}" incomingRoad="{one}" connectingRoad="{20 + number}" '
            f'contactPoint="start">{lane_link}</connection>'
        )
    junction = f'<junction id="9" name="square">{connections}</junction>'
    reference = "<geoReference>+proj=tmerc +lat_0=48.5 +lon_0=-11</geoReference>"
    text = xodr(*roads, junction, header=reference if seed % 3 else "")
    return text.replace("<road ", '<road rule="LHT" ') if seed % 4 == 3 else text


def _connecting(id: int, one: Pose, other: Pose, first: int, last: int) -> str:
    (x, y, _), (to_x, to_y, _) = one, other
    length = math.hypot(to_x - x, to_y - y)
    line = piece(0, x, y, math.atan2(to_y - y, to_x - x), length)
    lanes = section(0, (), [lane(-1, inside=linked(1, -1))])
    ends = link(predecessor=f"road {first} start", successor=f"road {last} start")
    return road(id, length, line, lanes, junction=9, inside=ends)


_TAGS: dict[str, tuple[str, ...]] = {
    "highway": (
        *("residential", "primary", "motorway", "service", "footway", "trunk_link", "tertiary"),
        *("living_street", "residential", "residential"),
    ),
    "lanes": ("1", "2", "3", "4", "5", "0", "two", "40"),
    "lanes:forward": ("1", "2", "3"),
    "lanes:backward": ("1", "2", "3"),
    "oneway": ("yes", "no", "-1", "reverse", "true", "1", "maybe"),
    "maxspeed": ("50", "30 mph", "none", "7.5km/h", "120 kph", "0", "20 knots", " 40 "),
    "junction": ("roundabout", "circular", "yes"),
    "access": ("no", "private"),
    "area": ("yes", "no"),
    "motor_vehicle": ("no", "yes"),
    "name": ("Main", "Low", "Main"),
}
_OFTEN = {"lanes": 0.4, "oneway": 0.3, "name": 0.5, "maxspeed": 0.4}


Ways = list[tuple[list[int], dict[str, str]]]
"""Ids of points, and tags."""


def _ways(seed: int) -> tuple[dict[int, tuple[float, float]], Ways]:
    """Points in degrees, and walks over them, some closed, with tags."""
    rng = random.Random(f"streets {seed}")
    points = {
        10 * row + column: (
            48.0 + 0.001 * row + rng.uniform(-2e-4, 2e-4),
            11.0 + 0.0015 * column + rng.uniform(-2e-4, 2e-4),
        )
        for row in range(5)
        for column in range(5)
    }
    found: Ways = []
    for number in range(9):
        at = rng.choice(list(points))
        walk = [at]
        for _ in range(rng.randint(1, 5)):
            at += rng.choice((-10, -1, 1, 10))
            if at in points:
                walk.append(at)
        tags = {
            key: rng.choice(values)
            for key, values in _TAGS.items()
            if key == "highway" or rng.random() < _OFTEN.get(key, 0.06)
        }
        if number in (3, 4):
            row, column = rng.randint(0, 2), rng.randint(0, 2)
            corner = 10 * row + column
            walk = [corner, corner + 2, corner + 22, corner + 20, corner]
            if number == 4:
                tags = {"building": rng.choice(("yes", "house", "no"))}
        found.append((walk, tags))
    return points, found


def street_extract(seed: int) -> str:
    """Ways over a crooked grid, as OpenStreetMap."""
    points, ways = _ways(seed)
    nodes = "".join(
        f'<node id="{id}" lat="{y!r}" lon="{x!r}"/>\n' for id, (y, x) in points.items() if id != 33
    )
    lines = ""
    for number, (walk, tags) in enumerate(ways):
        refs = "".join(f'<nd ref="{node}"/>' for node in walk)
        listed = "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())
        lines += f'<way id="{number}">{refs}{listed}</way>\n'
    return f'<osm version="0.6">\n{nodes}{lines}</osm>\n'


def lines_of_streets(seed: int) -> Any:
    """The same ways as GeoJSON; closed ones are polygons, some lines stand in one feature."""
    points, ways = _ways(seed)
    features = list[Any]()
    for number, (walk, tags) in enumerate(ways):
        line: Any = [[points[node][1], points[node][0]] for node in walk]
        kind = "LineString"
        if number == 4:
            inner = [[x + 1e-4, y + 1e-4] for x, y in line]
            kind, line = ("Polygon", [line, inner]) if seed % 2 else ("MultiPolygon", [[line]])
        elif number == 6:
            kind, line = "MultiLineString", [line, [[x, y + 0.004] for x, y in line]]
        properties: dict[str, Any] = dict(tags)
        if number % 2 and properties.get("lanes", "").isdigit():
            properties["lanes"] = int(properties["lanes"])
        if properties.get("oneway") == "yes":
            properties["oneway"] = True
        geometry = {"type": kind, "coordinates": line}
        features.append({"type": "Feature", "properties": properties, "geometry": geometry})
    features.append({"type": "Feature", "properties": None, "geometry": None})
    features.append({"type": "Feature", "geometry": {"type": "Point", "coordinates": [11.0, 48.0]}})
    return {"type": "FeatureCollection", "features": features}
