"""Nodes, ways and relations of a Lanelet2 map, which is an OpenStreetMap file in form."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from xml.etree.ElementTree import Element, SubElement

from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang_formats.lanelets.model import LinePoint

Tags = Mapping[str, str]


class Primitives:
    """The elements of a file. Ids are counted over all of them; equal points are one node."""

    def __init__(self, projection: LocalProjection, reserved: int) -> None:
        """The first ids, `reserved` of them, are for others."""
        self._projection = projection
        self._last = reserved
        self._nodes: dict[LinePoint, int] = {}
        self._ways: list[Element] = []
        self._relations: list[Element] = []

    def node(self, point: LinePoint) -> int:
        """The id of a point."""
        if point not in self._nodes:
            self._nodes[point] = self.id()
        return self._nodes[point]

    def way(self, points: Iterable[LinePoint], tags: Tags) -> int:
        """The id of a new line string."""
        found = Element("way", self._attributes(self.id()))
        for point in points:
            SubElement(found, "nd", ref=str(self.node(point)))
        _tag(found, tags)
        self._ways.append(found)
        return int(found.attrib["id"])

    def relation(
        self, members: Iterable[tuple[str, str, int]], tags: Tags, id: int | None = None
    ) -> int:
        """The id of a new relation; `members`: type, role and id."""
        found = Element("relation", self._attributes(self.id() if id is None else id))
        for type, role, ref in members:
            SubElement(found, "member", type=type, ref=str(ref), role=role)
        _tag(found, tags)
        self._relations.append(found)
        return int(found.attrib["id"])

    def id(self) -> int:
        """One that no other element has."""
        self._last += 1
        return self._last

    def root(self) -> Element:
        """The whole file."""
        root = Element("osm", version="0.6", generator="roadlang")
        for (x, y, z), id in self._nodes.items():
            latitude, longitude = self._projection.place(x, y)
            node = SubElement(root, "node", self._attributes(id))
            node.set("lat", f"{latitude:.11f}")
            node.set("lon", f"{longitude:.11f}")
            _tag(node, {"local_x": f"{x:.6f}", "local_y": f"{y:.6f}", "ele": f"{z:.6f}"})
        root.extend(self._ways)
        root.extend(self._relations)
        return root

    @staticmethod
    def _attributes(id: int) -> dict[str, str]:
        return {"id": str(id), "visible": "true", "version": "1"}


def _tag(element: Element, tags: Tags) -> None:
    for key, value in tags.items():
        SubElement(element, "tag", k=key, v=value)
