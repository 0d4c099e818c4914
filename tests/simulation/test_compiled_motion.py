"""The compiled motion moves several agents at once."""

from __future__ import annotations

import platform

import numpy as np
import pytest

from roadlang import testing
from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.lines import line_nodes, lines
from roadlang.simulation.lines.line_nodes import Spacing
from roadlang.simulation.lines.line_sources import LineSource
from roadlang.simulation.observing.bend_speeds import planned
from roadlang.simulation.tapes import interpreting
from roadlang.simulation.vehicles import compiled, kernels, poses

from .test_same_bytes import LOOP

numba = pytest.importorskip("numba")

AGENTS = 40
BENT = """
road base { draw with segments { pieces: [straight(60m), arc(40m, 80deg), straight(60m)] } }
road bent from base { perturb with sine { amplitude: 0m..3m, wavelength: 60m..90m } }
agent ego is car on bent at 25m
"""


def motion() -> tuple[object, ...]:
    """What the loop over agents is called with, of cars on straight lines."""
    column = np.ones(AGENTS)
    before = tuple(column.copy() for _ in range(10))
    cars, numbers = np.ones((13, AGENTS)), np.ones((4, AGENTS))
    first = np.arange(AGENTS)
    table = np.zeros((AGENTS + 2, 8))
    walks = np.zeros(AGENTS, bool)
    after = np.empty((10, AGENTS))
    return (before, after), cars, walks, (column, column), (first, numbers), table, 2, 0.02


def test_points_beside_lines_are_the_same_to_the_last_bit() -> None:
    scenes = [scene.record for scene in testing.sample(BENT, 3)]
    track = world_of(scenes, {}, 0.02, 0.1).track
    draw = np.random.default_rng(4)
    along = draw.uniform(-20.0, 200.0, (5, 3))  # beyond both ends too
    for left in (draw.uniform(-3.0, 3.0, 3), draw.uniform(-3.0, 3.0, (5, 3))):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(compiled, "is_loaded", lambda: False)
            expected = poses.points_beside(track, along, left)
            patch.setattr(compiled, "is_loaded", lambda: True)
            found = poses.points_beside(track, along, left)
        np.testing.assert_array_equal(found, expected)


def test_frames_ahead_on_lines_are_the_same_to_the_last_bit() -> None:
    scenes = [scene.record for scene in testing.sample(BENT, 3)]
    track = world_of(scenes, {}, 0.02, 0.1).track
    along = np.random.default_rng(4).uniform(-20.0, 200.0, (5, 3))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compiled, "is_loaded", lambda: False)
        cells, frames = poses.frames_ahead(track, along)
        patch.setattr(compiled, "is_loaded", lambda: True)
        found_cells, found = poses.frames_ahead(track, along)
    np.testing.assert_array_equal(found_cells, cells)
    np.testing.assert_array_equal(found, frames)
    assert len(np.unique(cells)) > 9


@pytest.mark.parametrize("varies", [False, True])
def test_nodes_of_lines_are_the_same_to_the_last_bit(varies: bool) -> None:
    draw = np.random.default_rng(4)
    sources = []
    for points, closed in ((7, False), (90, True), (2, False), (40, True), (300, False)):
        s = np.append(0.0, np.cumsum(draw.choice([0.3, 1.0, draw.uniform(0.2, 9.0)], points - 1)))
        x, y, heading, width = draw.uniform(-9.0, 9.0, (4, points))
        across = width if varies and points > 9 else 7.0
        sources.append(LineSource(s, x, y, heading, across, closed))
    spacing = Spacing.of(sources, 12.0)
    nodes = line_nodes.line_nodes(sources, spacing, spacing.nodes)
    np.testing.assert_array_equal(compiled.line_nodes(sources, spacing, spacing.nodes), nodes)
    for row, source in enumerate(sources):
        inside = slice(1 + int(spacing.pads[row]), int(spacing.pads[row] + spacing.counts[row]))
        at = np.arange(1, spacing.counts[row]) * spacing.meters[row]
        np.testing.assert_allclose(nodes[0, row, inside], np.interp(at, source.s, source.x))


def test_tables_of_lines_are_the_same_to_the_last_bit() -> None:
    draw = np.random.default_rng(5)
    nodes = draw.uniform(-9.0, 9.0, (4, 20, 30))
    spacing = draw.uniform(0.2, 3.0, 20)  # averaged over one to eight cells to each side
    expected, found = np.empty((2, 20, 30, len(lines.CELL)))
    lines.line_table(nodes, spacing, expected)
    compiled.line_table(nodes, spacing, found)
    np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("closed", [False, True])
def test_plans_before_bends_are_the_same_to_the_last_bit(
    closed: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = BENT if not closed else LOOP
    scenes = [scene.record for scene in testing.sample(text, 5)]
    table = world_of(scenes, {}, 0.02, 0.1).track.lines
    draw = np.random.default_rng(6)
    row = np.array([4, 0, 0, 3])
    limits = draw.uniform(1.0, 9.0, 4), np.array([0.0, 0.5, 3.0, 8.0])
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    expected = planned(table, row, *limits)
    monkeypatch.setattr(compiled, "is_loaded", lambda: True)
    np.testing.assert_array_equal(planned(table, row, *limits), expected)


@pytest.mark.slow
@pytest.mark.skipif(platform.machine() != "x86_64", reason="reads the instructions of x86-64")
def test_square_roots_and_divisions_are_those_of_several_agents_at_once() -> None:
    compiled._register_formulas()
    loop = numba.njit(nogil=True, **compiled.OPTIONS)(kernels.advanced)
    loop(*motion())
    (assembly,) = loop.inspect_asm().values()
    assert "sqrtpd" in assembly
    assert "divpd" in assembly
    assert "sqrtsd" not in assembly  # one agent after the other


@pytest.mark.slow
@pytest.mark.skipif(platform.machine() != "x86_64", reason="reads the instructions of x86-64")
def test_tapes_move_several_agents_at_once() -> None:
    compiled._register_formulas()
    loop = numba.njit(nogil=True, **compiled.OPTIONS)(interpreting.move)
    registers, places = np.ones((39, 5)), np.arange(39)
    loop(registers, places, 0, np.zeros(5), np.zeros(5, np.int64), np.ones((9, 8)), 2, 0.02)
    (assembly,) = loop.inspect_asm().values()
    assert "sqrtpd" in assembly
    assert "divpd" in assembly
    assert "sqrtsd" not in assembly  # one agent after the other
