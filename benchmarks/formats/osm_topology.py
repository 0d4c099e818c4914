"""Junctions of extracts of OpenStreetMap as `read with osm` has them, against SUMO's import:
`python -m benchmarks.formats.osm_topology --netconvert .../netconvert FILE.osm ...`.

A junction is a node at which three or more streets for cars end in either network. Its arms are
equal if as many edges for cars lead in and out of it, in the same directions. Nodes of netconvert
with an edge of less than 0.5 m between them are one, as `read with osm` has it.
"""

from __future__ import annotations

import argparse
import math
import subprocess
import tempfile
from collections import Counter
from pathlib import Path
from typing import TypeAlias
from xml.etree import ElementTree

from roadlang.geometry import RoadNetwork
from roadlang_formats.read_osm import OpenStreetMap

_MEETING = 3
_SAME = 0.7
"""Meters between two nodes that are one."""
_SHORT = 0.5
"""Meters of an edge whose ends are one node."""
_STEP = 3.0
"""Meters along a street to where its direction is measured."""
_ANGLE = math.radians(25.0)
Place: TypeAlias = tuple[float, float]
Arm: TypeAlias = tuple[float, bool, bool]
"""Bearing away from the node; whether traffic leads in; whether it leads out."""


def main() -> None:
    """Prints the counts of each file, and where arms differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--netconvert", required=True, help="of SUMO")
    parser.add_argument("--left-hand", action="store_true", help="where traffic is on the left")
    parser.add_argument("--where", action="store_true", help="print the places that differ")
    parser.add_argument("files", nargs="+", type=Path)
    options = parser.parse_args()
    for file in options.files:
        network = OpenStreetMap().read(file).network
        more = ["--lefthand"] if options.left_hand else []
        theirs = _sumo_arms([options.netconvert, *more], file, network)
        ours = _our_arms(network)
        counts: Counter[str] = Counter()
        for place in _junctions(ours, theirs):
            one, other = _at(ours, place), _at(theirs, place)
            equal = _equal(one, other)
            counts["equal" if equal else "different"] += 1
            if options.where and not equal:
                print(f"  ({place[0]:.0f}, {place[1]:.0f}): {_shown(one)} | {_shown(other)}")
        share = counts["equal"] / max(counts.total(), 1)
        print(f"{file.name}: {counts.total()} junctions, {share:.1%} equal", flush=True)


def _our_arms(network: RoadNetwork) -> dict[Place, list[Arm]]:
    found: dict[Place, list[Arm]] = {network_node.position: [] for network_node in network.nodes}
    for edge in network.edges:
        lanes = edge.cross_section.lanes if edge.cross_section is not None else ()
        ways = {lane.direction for lane in lanes}
        step = min(_STEP, edge.length / 2.0)
        for node, end, near, enters in (
            (edge.start, 0.0, step, "backward"),
            (edge.end, edge.length, edge.length - step, "forward"),
        ):
            (x, y), (u, v) = edge.curve.at([end, near])
            leaves = "forward" if enters == "backward" else "backward"
            arm = math.atan2(v - y, u - x), enters in ways, leaves in ways
            found[network.node(node).position].append(arm)
    return found


def _sumo_arms(program: list[str], file: Path, network: RoadNetwork) -> dict[Place, list[Arm]]:
    latitude, longitude = network.origin or (0.0, 0.0)
    projection = f"+proj=tmerc +lat_0={latitude} +lon_0={longitude} +k=1 +x_0=0 +y_0=0 +ellps=WGS84"
    with tempfile.TemporaryDirectory() as folder:
        plain = Path(folder) / "plain"
        command = [*program, "--osm-files", str(file), "--plain-output-prefix", str(plain)]
        command += ["--proj", projection, "--offset.disable-normalization", "--geometry.remove"]
        command += ["--keep-edges.by-vclass", "passenger,delivery", "--no-turnarounds"]
        subprocess.run(command, check=True, capture_output=True)
        nodes = ElementTree.parse(f"{plain}.nod.xml").getroot()
        edges = ElementTree.parse(f"{plain}.edg.xml").getroot()
    at = {
        str(node.get("id")): (float(str(node.get("x"))), float(str(node.get("y"))))
        for node in nodes.iter("node")
    }
    short = set()
    for edge in edges.iter("edge"):
        one, other = (str(edge.get(name)) for name in ("from", "to"))
        if math.dist(at[one], at[other]) < _SHORT and edge.get("shape") is None:
            at = {id: at[one] if place == at[other] else place for id, place in at.items()}
            short.add(edge.get("id"))
    found: dict[Place, dict[int, Arm]] = {place: {} for place in at.values()}
    for edge in edges.iter("edge"):
        if edge.get("id") in short:
            continue
        ends = [at[str(edge.get(name))] for name in ("from", "to")]
        shape = [tuple(map(float, p.split(",")[:2])) for p in str(edge.get("shape", "")).split()]
        line = [(p[0], p[1]) for p in shape] or ends
        for place, points, enters in ((ends[0], line, False), (ends[1], line[::-1], True)):
            bearing = _bearing(points)
            arms = found[place]
            same = [key for key, arm in arms.items() if _near(arm[0], bearing, math.radians(2.0))]
            before = arms[same[0]] if same and not arms[same[0]][1 if enters else 2] else None
            key = same[0] if before is not None else len(arms)
            into, out = (before[1], before[2]) if before is not None else (False, False)
            arms[key] = (bearing, into or enters, out or not enters)
    return {place: list(arms.values()) for place, arms in found.items()}


def _bearing(points: list[Place]) -> float:
    """Of a line, from its first point toward the point a step along it. It need not begin at its
    node: netconvert puts lanes beside it where `placement` says so."""
    place = points[0]
    left, before = _STEP, place
    for point in points:
        length = math.dist(before, point)
        if length >= left:
            share = left / length
            x, y = (b + (p - b) * share for b, p in zip(before, point, strict=True))
            return math.atan2(y - place[1], x - place[0])
        left, before = left - length, point
    return math.atan2(before[1] - place[1], before[0] - place[0])


def _junctions(*sides: dict[Place, list[Arm]]) -> list[Place]:
    """Places of junctions of any side, each once."""
    found: list[Place] = []
    for side in sides:
        for place, arms in side.items():
            known = any(math.dist(place, other) < _SAME for other in found)
            if len(arms) >= _MEETING and not known:
                found.append(place)
    return found


def _at(arms: dict[Place, list[Arm]], place: Place) -> list[Arm]:
    near = min(arms, key=lambda other: math.dist(place, other))
    return arms[near] if math.dist(near, place) < _SAME else []


def _equal(one: list[Arm], other: list[Arm]) -> bool:
    """Whether each arm of one has its like in the other."""
    left = list(other)
    for bearing, *ways in one:
        like = [arm for arm in left if list(arm[1:]) == ways and _near(arm[0], bearing, _ANGLE)]
        if not like:
            return False
        left.remove(min(like, key=lambda arm: abs(math.remainder(arm[0] - bearing, math.tau))))
    return not left


def _near(one: float, other: float, angle: float) -> bool:
    return abs(math.remainder(one - other, math.tau)) <= angle


def _shown(arms: list[Arm]) -> str:
    signs = {(True, True): "=", (True, False): ">", (False, True): "<"}
    return " ".join(f"{math.degrees(a):.0f}{signs.get((i, o), '?')}" for a, i, o in sorted(arms))


if __name__ == "__main__":
    main()
