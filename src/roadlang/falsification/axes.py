"""The search space: every random number that a scene of the scenario is made from."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ..diagnostics import DiagnosticError
from ..evaluate.candidates import CandidateBatch, fixed_candidate
from ..evaluate.draw_names import draw_place
from ..evaluate.draw_record import DrawRecord
from ..evaluate.evaluation import build
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.values import RandomValue
from ..plugins.kinds import Axis
from ..scenes.instantiate import driven_scene

_LOOKED_AT = 8
"""Candidates that are made to see what is drawn: how many copies a group has may be drawn too."""


def axes_of(scenario: IndexedScenario, seed: int) -> tuple[Axis, ...]:
    """The coordinates of the unit cube that is searched, in the order in which they are drawn.

    What only few candidates draw (the ninth car of a group) may be missing; it is then hashed of
    its place as in any other sample.
    """
    names: dict[str, None] = {}
    for attempt in range(_LOOKED_AT):
        record = DrawRecord()
        scenes, attempts = np.zeros(1, np.int64), np.array([attempt])
        candidate = CandidateBatch(scenario, seed, scenes, attempts, None, record)
        try:
            driven_scene(candidate, 0, {})
        except DiagnosticError:  # no scene that is accepted has this fault
            continue
        finally:
            names |= dict.fromkeys(record.named_coordinates())
    draws = {draw.place: draw for draw in scenario.draws()}
    return tuple(_axis(name, draws.get(draw_place(name)), scenario) for name in names)


def axes_written(scenario: IndexedScenario) -> tuple[Axis, ...]:
    """An axis for each place where something is drawn, whether or not a scene makes use of it."""
    draws = {draw.place: draw for draw in scenario.draws()}
    return tuple(_axis(place, draw, scenario) for place, draw in draws.items())


def _axis(name: str, draw: RandomValue | None, scenario: IndexedScenario) -> Axis:
    """An axis of a random number: one that a pass draws for itself is continuous."""
    if draw is None or scenario.dependencies.draws(
        *(value for value in draw.call.options.values())
    ):
        return Axis(name)
    built = build(draw.call, fixed_candidate(scenario), single=True)
    with built.guarded:
        cells = built.kind.cells()
        ends = None if cells is None else tuple(_ascending(cells))
        simplest = _coordinate(built.kind.simplest())
    return Axis(name, ends, built.kind.is_ordered, simplest)


def _coordinate(found: float) -> float:
    """A number in [0, 1). Raises `ValueError` for anything else."""
    if not 0.0 <= float(found) < 1.0:
        raise ValueError(f"its simplest value is at {found}, which is not in [0, 1)")
    return float(found)


def _ascending(cells: Iterator[float]) -> list[float]:
    """The ends of cells as floats, the last exactly 1. Raises `ValueError` for anything else."""
    ends = [float(end) for end in cells]
    if not ends or ends != sorted(ends) or not 0.0 <= ends[0] <= ends[-1] <= 1.0 + 1e-9:
        raise ValueError(f"its cells end at {ends}")
    return [*ends[:-1], 1.0]
