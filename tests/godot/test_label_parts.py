"""The labels of all that is sent to the engine."""

from __future__ import annotations

import struct

from roadlang import testing
from roadlang_godot.build.label_parts import instances_of, label_parts
from roadlang_godot.build.layout import layout_of
from roadlang_godot.net.protocol import Message
from roadlang_standard.semantic_classes import SemanticClass

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] }, lanes: 2, sidewalks: 2m }
object trees is tree on main at 10m..50m { count: 3, side: left, offset: 1m }
agent ego is car on main at 20m
"""


def test_each_kind_of_part_has_one_message_with_a_number_of_its_own() -> None:
    (sampled,) = testing.sample(TEXT)
    layout = layout_of(sampled.record)
    instances = instances_of(sampled.record, layout.objects)
    assert [(one.number, one.actor.name) for one in instances[:2]] == [(1, "ego"), (2, "trees[0]")]
    parts = label_parts(layout.parts, layout.agents, layout.objects, instances)
    assert [part.id for part in parts] == list(range(1, len(parts) + 1))
    rows = {}
    for part in parts:
        kind, count = struct.unpack_from("<BH", part.body)
        rows[kind] = list(struct.iter_unpack("<IBBH", part.content))
        assert count == len(rows[kind])
    assert rows == {
        0: [(0, SemanticClass.OTHER, 0, 0), (1, SemanticClass.TERRAIN, 0, 0),
            (2, SemanticClass.VEGETATION, 0, 0)],
        Message.SEGMENT: [(1, SemanticClass.SIDEWALK, 0, 0), (2, SemanticClass.ROAD, 0, 0),
                          (3, SemanticClass.SIDEWALK, 0, 0)],
        Message.AGENT: [(1, SemanticClass.CAR, 0, 1)],
        Message.OBJECTS: [(1, SemanticClass.VEGETATION, 1, 2)],
    }  # fmt: skip
