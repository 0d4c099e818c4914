"""Which lanes lead into which: the links of roads, and the connections of junctions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from roadlang.api import Diagnostic
from roadlang.geometry import LaneEnd, MapJunction, MapTurn
from roadlang_formats.map_xml import MapFile

from .built_roads import BuiltRoad
from .records import OTHER_END, ConnectionRecord, Contact, JunctionRecord

Roads = Mapping[str, BuiltRoad]
RoadEnd = tuple[str, Contact]
_FARTHEST = 50.0
"""Meters between the reference lines of roads that are linked: they may be at either edge."""


class TurnReader:
    """Turns between roads of a network, whose edges have `numbers` by the ids of the roads."""

    def __init__(self, file: MapFile, roads: Roads, numbers: Mapping[str, int]) -> None:
        self._file, self._roads, self._numbers = file, roads, numbers
        self.remarks: dict[str, None] = {}
        """warnings about links, each once"""
        self.warnings: dict[Diagnostic, None] = {}
        """of lanes of connecting roads that are left out"""

    def junctions(self, records: Mapping[str, JunctionRecord]) -> tuple[MapJunction, ...]:
        """Those of the file, then the joints of roads that follow one another."""
        found: list[MapJunction] = []
        for record in records.values():
            turns = [turn for item in record.connections for turn in self._connected(item, record)]
            self._add(found, turns, joint=False)
        for pairs in _meeting(self._followed()):
            turns = [turn for one, other in pairs for turn in self._passed(one, other)]
            self._add(found, turns, joint=len(pairs) == 1)
        return tuple(found)

    def _add(self, found: list[MapJunction], turns: list[MapTurn], *, joint: bool) -> None:
        if turns:
            ends = [end for turn in turns for end in (turn.source, turn.target)]
            arms = tuple(dict.fromkeys((end.edge, end.end) for end in ends))
            found.append(MapJunction(len(found), arms, tuple(turns), joint))

    def _followed(self) -> list[tuple[RoadEnd, RoadEnd]]:
        """Pairs of ends of roads of the network that meet outside of junctions, each once."""
        found: dict[frozenset[RoadEnd], tuple[RoadEnd, RoadEnd]] = {}
        for id in self._numbers:
            for end in OTHER_END:
                link = self._roads[id].record.link(end)
                if link is None or link.kind == "junction":
                    continue
                if link.id not in self._roads:
                    self._remark(
                        id, f"leads to road {link.id}, which does not exist: it ends there"
                    )
                    continue
                pair = (id, end), (link.id, link.contact)
                if link.id in self._numbers and self._are_near(*pair):
                    found.setdefault(frozenset(pair), pair)
        return [pair for pair in found.values() if pair[0] != pair[1]]

    def _remark(self, id: str, what: str) -> None:
        line = self._file.line(self._roads[id].record.element)
        self.remarks.setdefault(f"road {id} (line {line}) {what}")

    def _are_near(self, one: RoadEnd, other: RoadEnd) -> bool:
        """Whether two ends meet; if not, a remark is added, because real maps have such links."""
        gap = math.dist(*(self._roads[id].point(end) for id, end in (one, other)))
        if gap > _FARTHEST:
            far = f"road {other[0]}, which is {gap:.3g} m away"
            self._remark(one[0], f"leads to {far}: they are not joined")
        return gap <= _FARTHEST

    def _passed(self, one: RoadEnd, other: RoadEnd) -> Iterator[MapTurn]:
        """Both ways between the lanes of two roads that are linked."""
        pairs = {
            *((a, b) for a, b in self._links(one)),
            *((a, b) for b, a in self._links(other)),
        }
        if not pairs:
            sign = -1 if one[1] == other[1] else 1
            pairs = {(id, sign * id) for id in self._roads[one[0]].lanes_at(one[1])}
        for a, b in sorted(pairs):
            first, second = self._lane_end(one, a), self._lane_end(other, b)
            if first is not None and second is not None:
                yield MapTurn(first, second)
                yield MapTurn(second, first)

    def _links(self, at: RoadEnd) -> Iterator[tuple[int, int]]:
        """Lanes at an end of a road with what they are linked to there."""
        for id, lane in self._roads[at[0]].lanes_at(at[1]).items():
            linked = lane.predecessor if at[1] == "start" else lane.successor
            if linked is not None:
                yield id, linked

    def _lane_end(self, at: RoadEnd, lane: int) -> LaneEnd | None:
        number, found = self._numbers.get(at[0]), self._roads[at[0]].ids[at[1]].get(lane)
        return None if number is None or found is None else LaneEnd(number, at[1], found)

    def _connected(self, item: ConnectionRecord, junction: JunctionRecord) -> Iterator[MapTurn]:
        """The turns of one connection."""
        for id in (item.incoming, item.connecting):
            if id not in self._roads:
                reason = f"junction `{junction.id}` has a connection of road `{id}`, "
                raise self._file.fault(item.element, f"{reason}which does not exist")
        if item.direct:
            yield from self._joined_directly(item, junction)
            return
        connecting = self._roads[item.connecting]
        enters, leaves = item.contact, OTHER_END[item.contact]
        before, after = (connecting.record.link(end) for end in (enters, leaves))
        if after is None or after.kind != "road" or after.id not in self._roads:
            return
        at = self._incoming_end(item, junction, before.contact if before else None)
        if not self._are_near((item.connecting, enters), at):
            return
        if not self._are_near((item.connecting, leaves), (after.id, after.contact)):
            return
        lanes = item.lanes or tuple((b, a) for a, b in self._links((item.connecting, enters)))
        onward = dict(self._links((item.connecting, leaves)))
        passing = {track: id for id, track in connecting.ids[leaves].items()}
        for source_lane, lane in lanes:
            track = connecting.ids[enters].get(lane)
            target_lane = onward.get(passing.get(track or 0, 0))
            source = self._lane_end(at, source_lane)
            if track is None or source is None or target_lane is None:
                continue
            target = self._lane_end((after.id, after.contact), target_lane)
            if target is not None:
                line = connecting.middle(track, backward=enters == "end")
                if line is None:
                    what = f"the line of lane {lane} of road {item.connecting}"
                    reason = "it is not a curve; the turn is drawn from end to end"
                    element = connecting.record.element
                    self.warnings[self._file.left_out(element, what, reason)] = None
                yield MapTurn(source, target, line)

    def _incoming_end(
        self, item: ConnectionRecord, junction: JunctionRecord, linked: Contact | None
    ) -> RoadEnd:
        """The end of the incoming road: that which leads to the junction; if both do, the one that
        the connecting road names."""
        ends: list[Contact] = []
        for end in OTHER_END:
            link = self._roads[item.incoming].record.link(end)
            if link is not None and link.kind == "junction" and link.id == junction.id:
                ends.append(end)
        if len(ends) == 1:
            return item.incoming, ends[0]
        return item.incoming, linked or "end"

    def _joined_directly(
        self, item: ConnectionRecord, junction: JunctionRecord
    ) -> Iterator[MapTurn]:
        """Of a junction without connecting roads."""
        at, other = self._incoming_end(item, junction, None), (item.connecting, item.contact)
        for a, b in item.lanes if self._are_near(at, other) else ():
            first, second = self._lane_end(at, a), self._lane_end(other, b)
            if first is not None and second is not None:
                yield MapTurn(first, second)
                yield MapTurn(second, first)


def _meeting(pairs: list[tuple[RoadEnd, RoadEnd]]) -> list[list[tuple[RoadEnd, RoadEnd]]]:
    """Pairs that have an end in common are one junction, as where a street ends in a loop."""
    groups: list[list[tuple[RoadEnd, RoadEnd]]] = []
    for pair in pairs:
        same = [group for group in groups if any(end in other for other in group for end in pair)]
        groups = [group for group in groups if group not in same]
        groups.append([*(other for group in same for other in group), pair])
    return groups
