"""What Godot is sent of a scene, in lines: every part with its head, its text and its numbers."""

from __future__ import annotations

import json
from collections.abc import Iterator

import numpy as np

from roadlang import Scene
from roadlang_godot.build.layout import Layout, layout_of
from roadlang_godot.net.protocol import Message
from roadlang_godot.net.scene_part import ScenePart
from tests.golden.summaries import array, of_json

_HEAD_BYTES = 8


def layout_lines(scene: Scene, road: str = "mesh") -> Iterator[str]:
    """The layout of a scene with roads as meshes or tiles."""
    layout: Layout = layout_of(scene.record, road)
    yield from of_json(layout.settings(), "settings")
    yield f"frame: {layout.frame}"
    yield f"agents: {dict(layout.agents)} paths: {dict(layout.paths)}"
    yield f"left to Python: {layout.undriven}"
    for part in layout.parts:
        yield from _part(part)


def _part(part: ScenePart) -> Iterator[str]:
    title = f"{part.kind.name} {part.id} {part.label}"
    if part.kind in (Message.AGENT, Message.WORLD):
        yield f"{title}: {len(part.content)} bytes to prove"
        yield from of_json(json.loads(part.body), "  ")
        return
    head = " ".join(f"{byte:02x}" for byte in part.body[:_HEAD_BYTES])
    yield f"{title}: {len(part.body)} bytes, {len(part.content)} to prove, head {head}"
    words = part.content[: len(part.content) // 4 * 4]
    whole = np.frombuffer(words, dtype="<i4")
    real = np.frombuffer(words, dtype="<f4").astype(float)
    small = (whole >= 0) & (whole < 1 << 20)
    if small.any() and not small.all():
        yield f"  places of integers: {array(np.flatnonzero(small).tolist())}"
    if small.any():
        yield f"  integers: {array(whole[small].tolist())}"
    if not small.all():
        yield f"  numbers: {array([v if abs(v) < 1e9 else 0.0 for v in real[~small].tolist()])}"
