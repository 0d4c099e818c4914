"""What an extract of OpenStreetMap says: nodes with their places, and ways through them."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from roadlang_formats.degrees import why_no_place
from roadlang_formats.map_xml import MapElement, MapFile


@dataclass(frozen=True, slots=True)
class OsmNode:
    """A point, in degrees."""

    latitude: float
    longitude: float
    tags: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class OsmWay:
    """A line or outline through nodes, by the ids of these. `title`: what people call it;
    `offset`: where it begins in the text of its file."""

    nodes: tuple[str, ...]
    tags: Mapping[str, str]
    id: str
    title: str
    offset: int = 0


@dataclass(frozen=True, slots=True)
class OsmRestriction:
    """Turns from a way into another at a node that nobody may make, or, with `only`, the one that
    everybody must make."""

    source: str
    node: str
    target: str
    only: bool


@dataclass(frozen=True, slots=True)
class OsmExtract:
    """All nodes and ways of a file. A way is cut where nodes of it are not in the file."""

    nodes: Mapping[str, OsmNode]
    ways: tuple[OsmWay, ...]
    restrictions: tuple[OsmRestriction, ...] = ()


def osm_extract(file: MapFile) -> OsmExtract:
    """Raises RL479 for impossible coordinates and for ids used twice."""
    nodes: dict[str, OsmNode] = {}
    for element in file.root.all("node"):
        if _is_deleted(element):
            continue
        id = file.attribute(element, "id")
        if id in nodes:
            raise file.fault(element, f"two nodes have the id `{id}`")
        latitude, longitude = (file.number(element, name) for name in ("lat", "lon"))
        reason = why_no_place(latitude, longitude)
        if reason:
            raise file.fault(element, reason)
        nodes[id] = OsmNode(latitude, longitude, _tags(element))
    ways = []
    seen = set()
    for element in file.root.all("way"):
        if _is_deleted(element):
            continue
        id = file.attribute(element, "id")
        if id in seen:
            raise file.fault(element, f"two ways have the id `{id}`")
        seen.add(id)
        listed = [file.attribute(child, "ref") for child in element.all("nd")]
        tags = _tags(element)
        place = f"way {id}", element.offset
        ways += [OsmWay(run, tags, id, *place) for run in _runs(listed, nodes)]
    return OsmExtract(nodes, tuple(ways), tuple(_restrictions(file)))


def check_is_streets(file: MapFile) -> None:
    """Raises RL479 for a Lanelet2 map, which has the same form but no streets."""
    for element in file.root.all("relation"):
        if _tags(element).get("type") == "lanelet":
            help = (
                "read the map that it was made from: OpenDRIVE, OpenStreetMap, GeoJSON or a scene"
            )
            raise file.fault(element, "it is a Lanelet2 map, which has lanes, not streets", help)


def _restrictions(file: MapFile) -> Iterator[OsmRestriction]:
    """Those for cars at a node; others, such as those for a time of day, are left out."""
    for element in file.root.all("relation"):
        tags = _tags(element)
        rule = tags.get("restriction", "")
        is_one = tags.get("type") == "restriction" and not _is_deleted(element)
        if not is_one or "motorcar" in tags.get("except", ""):
            continue
        members: dict[tuple[str, str], list[str]] = {}
        for child in element.all("member"):
            key = child.attributes.get("type", ""), child.attributes.get("role", "")
            members.setdefault(key, []).append(child.attributes.get("ref", ""))
        keys = (("way", "from"), ("node", "via"), ("way", "to"))
        found = [members.get(key, []) for key in keys]
        if rule.startswith(("no_", "only_")) and [len(ids) for ids in found] == [1, 1, 1]:
            (source,), (node,), (target,) = found
            yield OsmRestriction(source, node, target, rule.startswith("only_"))


def _is_deleted(element: MapElement) -> bool:
    """Whether the user of an editor such as JOSM deleted it. The file still lists it."""
    return element.attributes.get("action") == "delete"


def _runs(listed: Sequence[str], nodes: Container[str]) -> Iterator[tuple[str, ...]]:
    """The parts of a way between nodes that the file does not have, as at the edge of an extract.
    A part has two nodes or more."""
    for present, run in groupby(listed, nodes.__contains__):
        found = tuple(run)
        if present and len(found) > 1:
            yield found


def _tags(element: MapElement) -> Mapping[str, str]:
    return {
        child.attributes["k"]: child.attributes["v"]
        for child in element.all("tag")
        if "k" in child.attributes and "v" in child.attributes
    }
