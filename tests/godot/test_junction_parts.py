"""Paint and signals of junctions, in a real engine."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roadlang.scenes.sampling import SamplingResult
from roadlang_godot.build.layout import layout_of
from roadlang_godot.net.protocol import BULK_DATAGRAM, HEADER_BYTES, Message
from roadlang_godot.net.session import Session
from tests.scenes.test_junction_paint import SIDEWALKS, crossing

pytestmark = pytest.mark.godot


def test_signals_and_paint_are_built_and_proven(
    session: Session, sample: Callable[..., SamplingResult]
) -> None:
    scene, _ = crossing(sample, SIDEWALKS + "control with signals")
    things = layout_of(scene).parts
    session.begin({"name": "test", "extent": 500.0}, clear=True)
    session.update(things)
    assert session.prove().parts == len(things)
    kinds = [thing.kind for thing in things]
    assert kinds.count(Message.SIGNALS) == 1
    paint = [thing for thing in things if thing.kind == Message.PAINT]
    assert len(paint) > 1
    assert all(len(thing.body) + 12 + HEADER_BYTES <= BULK_DATAGRAM for thing in paint)


def test_only_lines_along_curbs_are_painted_where_nobody_stops(
    sample: Callable[..., SamplingResult],
) -> None:
    scene, _ = crossing(sample, "lanes: 2")
    kinds = [thing.kind for thing in layout_of(scene).parts]
    assert {Message.PATCH, Message.PAINT} < set(kinds)
    assert Message.SIGNALS not in kinds
