"""The ASAM OpenDRIVE checker and netconvert on one file."""

from __future__ import annotations

import itertools
import math
import subprocess
from collections import Counter
from pathlib import Path
from typing import TypeAlias
from xml.etree import ElementTree

from tests.formats.opendrive_reader import ReadRoad, pose_of

Line: TypeAlias = list[tuple[float, float]]
"""Meters east and north."""
_SETTINGS = """<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<Config><Param name="InputFile" value="{file}"/><CheckerBundle application="xodrBundle">
<Param name="resultFile" value="{result}"/></CheckerBundle></Config>
"""
_SHARE = 0.005
"""By which a road of netconvert may differ in length."""
_ASIDE = {"sidewalk", "parking"}
"""Lanes that need not be on both sides, so that they are not as long as the road on the average."""
_OPTIONS = (
    # The roads of a file end where the corners of its junctions begin: no more is to be cut off.
    "--junctions.endpoint-shape",
    *("--opendrive.curve-resolution", "0.5", "--precision", "6"),
    "--output.original-names",
)


def checked(program: str, file: Path) -> tuple[int, Counter[str]]:
    """How many rules the ASAM checker has completed, and which ones it says are broken.

    It ends with 0 whatever it finds, and skips rules without a word: its result says so.
    """
    result, settings = file.with_suffix(".xqar"), file.with_suffix(".xml")
    result.unlink(missing_ok=True)
    settings.write_text(_SETTINGS.format(file=file, result=result))
    subprocess.run([program, "-c", str(settings)], capture_output=True, check=True, cwd=file.parent)
    root = ElementTree.parse(result)
    completed = sum(rule.get("status") == "completed" for rule in root.iter("Checker"))
    return completed, Counter(str(issue.get("ruleUID")) for issue in root.iter("Issue"))


def converted(program: str, file: Path) -> list[str]:
    """What netconvert misses of a file: roads, turns, lengths; also that it fails."""
    net = file.with_suffix(".net.xml")
    command = [program, "--opendrive-files", str(file), "-o", str(net), *_OPTIONS]
    # 4 GB: a file that it cannot take has eaten all memory before now.
    done = subprocess.run(
        ["sh", "-c", 'ulimit -v 4000000; exec "$@"', "sh", *command], capture_output=True, text=True
    )
    if done.returncode:
        return [f"netconvert failed: {done.stderr.strip()[-200:]}"]
    root, read = ElementTree.parse(net).getroot(), ElementTree.parse(file).getroot()
    edges = {edge.get("id"): edge for edge in root.iter("edge") if edge.get("function") is None}
    junctions = {str(junction.get("id")) for junction in read.iter("junction")}
    return [*_turns(read, root), *_lengths(read, edges, _nodes(root, junctions))]


def _turns(file: ElementTree.Element, net: ElementTree.Element) -> list[str]:
    """Connecting roads without a connection of the lanes that they link.

    Of several lanes of a road that lead into one lane netconvert keeps one at least, but not all.
    """
    names: dict[str, list[str]] = {}
    for lane in net.iter("lane"):
        for param in lane.iterfind("param[@key='origId']"):
            for name in str(param.get("value")).split():
                names.setdefault(name, []).append(str(lane.get("id")))
    found = {
        (f"{link.get('from')}_{link.get('fromLane')}", f"{link.get('to')}_{link.get('toLane')}")
        for link in net.iter("connection")
    }
    turns: dict[tuple[str, str], list[bool]] = {}
    for road in file.iterfind("road"):
        if road.get("junction") == "-1":
            continue
        ends = [
            f"{road.find(f'link/{tag}').attrib['elementId']}"  # type: ignore[union-attr]
            f"_{road.find(f'.//lane/link/{tag}').attrib['id']}"  # type: ignore[union-attr]
            for tag in ("predecessor", "successor")
        ]
        pairs = itertools.product(*(names.get(end, []) for end in ends))
        key = ends[0].partition("_")[0], ends[1]
        turns.setdefault(key, []).append(any(pair in found for pair in pairs))
    return [
        f"no turn from road {source} to lane {target}"
        for (source, target), lanes in turns.items()
        if not any(lanes)
    ]


def _nodes(net: ElementTree.Element, junctions: set[str]) -> dict[frozenset[str], list[Line]]:
    """The lanes within nodes that are no junctions, in the coordinates of the file, by the two
    roads that they join."""
    offset = str(net.find("location").attrib["netOffset"])  # type: ignore[union-attr]
    east, north = map(float, offset.split(","))
    inner = {
        str(lane.get("id")): [(x - east, y - north) for x, y, *_ in _points(lane)]
        for edge in net.iterfind("edge[@function='internal']")
        for lane in edge.iterfind("lane")
    }
    found: dict[frozenset[str], list[Line]] = {}
    for link in net.iter("connection"):
        via = str(link.get("via"))
        if via[1:].rsplit("_", 2)[0] not in junctions and via in inner:
            ends = frozenset(_road(str(link.get(name))) for name in ("from", "to"))
            found.setdefault(ends, []).append(inner[via])
    return found


def part_inside(road: ElementTree.Element, end: str, lanes: list[Line]) -> float:
    """Meters of the lanes of a node, on the average, that are a part of the road: those before the
    line across its end."""
    pieces = ReadRoad(road).pieces()
    at_start = end == "predecessor"
    # The stated length of the road is what is to be judged: its pieces say where it ends.
    x, y, heading = (
        pose_of(pieces[0], 0.0)
        if at_start
        else pose_of(pieces[-1], float(pieces[-1].attrib["length"]))
    )
    outward = heading + math.pi if at_start else heading
    cos, sin = math.cos(outward), math.sin(outward)
    total = 0.0
    for lane in lanes:
        past = [cos * (px - x) + sin * (py - y) for px, py in lane]
        for (one, other), (first, last) in zip(
            itertools.pairwise(past), itertools.pairwise(lane), strict=True
        ):
            low, high = sorted((one, other))
            whole = math.dist(first, last)
            total += whole if high <= 0.0 else whole * -low / (high - low) if low < 0.0 else 0.0
    return total / len(lanes)


def _road(edge: str) -> str:
    return edge.lstrip("-").partition("#")[0]


def _lengths(
    file: ElementTree.Element,
    edges: dict[str | None, ElementTree.Element],
    nodes: dict[frozenset[str], list[Line]],
) -> list[str]:
    """Roads that are missing, and those whose two directions are not as long on the average.

    Where a road bends on into another one netconvert puts a node
    (NBNodeShapeComputer::computeNodeShapeDefault), which may lie on one side of the joint alone: of
    what one drives through it, each road has the part on its side.
    """
    faults = []
    for road in file.iterfind("road"):
        if road.get("junction") != "-1":
            continue
        if road.find(".//lane[@type='driving']") is None:
            continue  # netconvert has no edges for these
        ways = [_edges(name, edges) for name in (f"-{road.get('id')}", str(road.get("id")))]
        if not any(ways):
            faults.append(f"road {road.get('id')} is missing")
        elif all(len(way) == 1 for way in ways):
            lanes = [
                [lane for lane in edge.iterfind("lane") if lane.get("type") not in _ASIDE]
                for (edge,) in ways
            ]
            if not all(lanes):
                continue
            both = lanes[0] + lanes[1]
            mean = sum(map(_plan_length, both)) / len(both)
            length = float(str(road.get("length")))
            for other in road.iterfind("link/*[@elementType='road']"):
                inner = nodes.get(frozenset((str(road.get("id")), str(other.get("elementId")))))
                mean += part_inside(road, other.tag, inner) if inner else 0.0
            if abs(mean / length - 1.0) > _SHARE:
                faults.append(f"road {road.get('id')} is {mean:.2f} m long, not {length:.2f} m")
    return faults


def _plan_length(lane: ElementTree.Element) -> float:
    """netconvert's length, but on a slope that of the plan, as lengths of OpenDRIVE are."""
    points = _points(lane)
    if not any(len(point) > 2 for point in points):
        return float(str(lane.get("length")))
    return sum(math.dist(one[:2], other[:2]) for one, other in itertools.pairwise(points))


def _points(lane: ElementTree.Element) -> list[tuple[float, ...]]:
    return [tuple(map(float, point.split(","))) for point in str(lane.get("shape")).split()]


def _edges(name: str, edges: dict[str | None, ElementTree.Element]) -> list[ElementTree.Element]:
    """The edges of one direction of a road: several where lanes begin or end."""
    return [edge for id, edge in edges.items() if str(id).partition("#")[0] == name]
