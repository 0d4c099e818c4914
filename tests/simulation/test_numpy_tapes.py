"""Programs and steps of vehicles by calls of numpy give the same bytes as formulas of arrays."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang.simulation.building.world_building import world_of
from roadlang.simulation.lines.line_nodes import Spacing, line_nodes
from roadlang.simulation.lines.line_sources import LineSource
from roadlang.simulation.lines.lines import Lines
from roadlang.simulation.tapes import numpy_tapes, repeating
from roadlang.simulation.tapes.numpy_tapes import NumpyTape
from roadlang.simulation.tapes.registers import aligned, shared
from roadlang.simulation.tapes.repeating import Repetition
from roadlang.simulation.tapes.tape import Tape, program_of
from roadlang.simulation.tapes.traced import TracedColumn, value_of
from roadlang.simulation.vehicles import compiled, motion
from roadlang.simulation.vehicles.motion import advance

from .test_same_bytes import LOOP, bytes_of, drives, records
from .traced_chains import STATE, STEPS, program_and_result

BENT = """
road base {
  draw with segments { pieces: [straight(40m), arc(40m, 80deg), straight(40m)] }
  width: 8m, lanes: 2
}
road bent from base { perturb with sine { amplitude: 0m..3m, wavelength: 60m..90m } }
agent ego is choice(car, truck) on bent at 5m..20m { lane: -1, drive with DRIVER }
world { friction: 0.2..0.9 }
"""
STANLEY = BENT.replace("DRIVER", "stanley { speed: (9m/s)..(22m/s) }")
PURSUIT = BENT.replace("DRIVER", "pure_pursuit { speed: (9m/s)..(22m/s) }")
ON_A_LOOP = LOOP.replace("lane_follow", "pure_pursuit")


@given(STEPS, st.integers(1, 70), st.integers(0, 2**32 - 1))
def test_it_computes_what_numpy_does(steps: list[Any], agents: int, seed: int) -> None:
    program, columns, expected = program_and_result(steps, agents, seed, 3)
    lines = np.zeros((1, 8)), np.zeros(agents, np.int64)
    out, samples = np.empty((len(program.gives), agents)), np.empty((0, 1, agents))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(numpy_tapes, "WIDE", 16)  # several parts, of which the last is not full
        tape = NumpyTape(program, STATE, lines, False, 0.02)
    went = tape.repeated(np.stack(columns), np.zeros(agents), 3, samples, out)
    assert went == 3
    assert out[3].tobytes() == expected[3].tobytes()
    assert out[0].tobytes() == expected[0].tobytes()


@pytest.mark.parametrize(
    ("text", "options"),
    [
        (STANLEY, {"control_step": 0.04}),
        (STANLEY, {"control_step": 0.1, "after_violation": 1.0}),
        (STANLEY, {"control_step": 0.3, "step": 0.1}),
        (PURSUIT, {"control_step": 0.04}),
        (ON_A_LOOP, {"control_step": 0.1}),
    ],
    ids=["stanley", "ends_early", "seldom", "pursuit", "loop"],
)
def test_repeated_steps_are_those_that_are_made_one_by_one(
    text: str, options: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compiled, "is_installed", lambda: False)
    monkeypatch.setattr(compiled, "is_loaded", lambda: False)
    scenes = records(text, 5)
    went = []
    original = Repetition.drive

    def drive(self: Repetition, *arguments: Any) -> bool:
        went.append(original(self, *arguments))
        return went[-1]

    monkeypatch.setattr(Repetition, "drive", drive)
    together = [bytes_of(trace) for trace in drives(scenes, duration=20.0, **options)]
    assert any(went), "steps were repeated"
    (alone,) = drives(scenes[3:4], duration=20.0, **options)
    assert bytes_of(alone) == together[3]
    monkeypatch.setattr(numpy_tapes, "WIDE", 2)
    assert [bytes_of(trace) for trace in drives(scenes, duration=20.0, **options)] == together
    monkeypatch.setattr(repeating, "LARGE", 2**16)  # samples of several seconds in one array
    assert [bytes_of(trace) for trace in drives(scenes, duration=20.0, **options)] == together
    monkeypatch.setattr(Repetition, "of", lambda *_: None)
    assert [bytes_of(trace) for trace in drives(scenes, duration=20.0, **options)] == together
    monkeypatch.setattr(motion, "MOST", 0)  # as of so many that rows of memory do not pay
    assert [bytes_of(trace) for trace in drives(scenes, duration=20.0, **options)] == together


def test_rows_begin_where_memory_is_fetched_at_once() -> None:
    rows = aligned(5, 13)
    assert rows.shape == (5, 13)
    assert all(row.ctypes.data % 64 == 0 for row in rows)


def test_a_column_of_one_number_is_that_number() -> None:
    assert shared(np.full(4, 2.5)) == 2.5
    assert shared(np.array([0.0, -0.0])) is None
    assert shared(np.array([1.0, 2.0])) is None
    assert shared(np.zeros(0)) is None


def test_a_copy_of_a_track_has_memory_of_its_own() -> None:
    world = world_of(records(STANLEY, 2), {}, 0.02, 0.1)
    track, rows = world.track, np.array([1])
    track.of_rows(rows)
    wanted = np.full(2, 0.1), np.ones(2)
    expected = world.start.copied()
    advance(expected, world.bodies, track, wanted, 3, 0.02)
    for other in (copy.deepcopy(track), pickle.loads(pickle.dumps(track))):
        found = world.start.copied()
        advance(found, world.bodies, other, wanted, 3, 0.02)
        assert found.along.tobytes() == expected.along.tobytes()
        assert other.steps(world.bodies.walks, 0.02) is not track.steps(world.bodies.walks, 0.02)
        assert not other._parts


def test_nodes_of_a_line_do_not_depend_on_the_lines_beside_it() -> None:
    draw = np.random.default_rng(4)
    sources = []
    for points, closed in ((7, False), (90, True), (2, False), (40, True), (300, False)):
        s = np.append(0.0, np.cumsum(draw.uniform(0.2, 9.0, points - 1)))
        x, y, heading, width = draw.uniform(-9.0, 9.0, (4, points))
        heading[0] = heading[-1] = -0.0
        sources.append(LineSource(s, x, y, heading, width if points > 9 else 7.0, closed))
    spacing = Spacing.of(sources, 12.0)
    together = line_nodes(sources, spacing, spacing.nodes)
    table = Lines.of(sources, 12.0).table.reshape(len(sources), spacing.nodes, -1)
    parts = Lines.of(sources, 12.0, at_once=2).table
    assert parts.tobytes() == table.tobytes()
    for row, source in enumerate(sources):
        own = Spacing.of([source], 12.0)
        alone = line_nodes([source], own, own.nodes)[:, 0]
        assert alone.tobytes() == together[:, row, : own.nodes].tobytes()


@pytest.mark.parametrize(
    "angles", [[0.5, 6.0], [0.0, 1.0], [-0.0, 1.0], [-1.0, 2.0], [2.0, 7.0], [1.0, np.nan]]
)
def test_remainders_within_a_turn_are_not_computed_but_are_the_same(angles: list[float]) -> None:
    tape = Tape(2, 1)
    turned = TracedColumn(tape, 0) % (2.0 * np.pi)
    program = program_of(tape, [value_of(tape, turned)])
    state, samples, out = np.array([angles]), np.empty((0, 1, 2)), np.empty((1, 2))
    lines = np.zeros((1, 8)), np.zeros(2, np.int64)
    NumpyTape(program, 1, lines, False, 0.02).repeated(state, np.zeros(2), 1, samples, out)
    assert out[0].tobytes() == (state[0] % (2.0 * np.pi)).tobytes()
