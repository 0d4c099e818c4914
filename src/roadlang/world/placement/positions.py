"""Where along their road copies begin: as a length, as a share, by another, or in a row."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

import numpy as np

from ...evaluate.copies import CopyBatch
from ...evaluate.evaluation import build, evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry.arrays import Floats, Integers
from ...ir.placed_batch import PlacedBatch
from ...ir.scenario import ScenarioActor
from ...ir.values import Entity, PassCall
from ...plugins.guard import wrong_result
from ...plugins.kinds import Standing
from ..roads.roads import road_batch
from .actor_numbers import column, number_of_copies
from .copies import element_of, is_group, kinds_of_copies

Others = Callable[[ScenarioActor], PlacedBatch]
"""Where agents and objects are that were placed before"""
_NOWHERE = -1e6
"""Arc length of what is placed by a copy that is not there: on no road"""


def starts_of(actor: ScenarioActor, copies: CopyBatch, others: Others) -> Floats:
    """(R,) arc lengths at which copies begin on their road."""
    assert actor.on is not None
    road = road_batch(actor.on, copies.candidates)
    length = _of_rows(road.length, copies)
    spacing = actor.options.get("spacing")
    first = copies if spacing is None else copies.numbered(np.ones(copies.count, np.int64))
    away: Floats | float = 1.0
    if names_another(actor, copies.scenario):
        other, standing = standing_beside(actor, copies, others)
        start = np.asarray(standing.start, float).reshape(-1)
        away = np.where(start < other.start[:, 0], -1.0, 1.0)
    elif isinstance(actor.at, PassCall):
        start = np.asarray(standing_of(actor, first, others).start, float).reshape(-1)
    else:
        at = column(evaluate(actor.at, first, element_of(actor)), copies)
        start = at * length if actor.at_fraction else at
    if spacing is not None:
        start = start + away * _from_the_first(actor, copies)
    return np.mod(start, length) if road.closed else start


def standing_of(actor: ScenarioActor, copies: CopyBatch, others: Others) -> Standing:
    """Where copies stand by another: the result of a kind of position. Raises RL474."""
    assert isinstance(actor.at, PassCall)

    def resolve(entity: Entity) -> Any:
        other = copies.scenario.actors.get(entity.name)
        if other is None:
            return entity.name
        return _of_copies(other, entity.copy, copies, others(other))

    kinds = kinds_of_copies(actor, copies)
    built = build(actor.at, copies, element_of(actor), resolve=resolve)
    with built.guarded:
        found = built.kind.place(kinds.lengths[:, None], kinds.widths[:, None])
    if not isinstance(found, Standing):
        fault = f"gave a {type(found).__name__}, not a Standing"
        raise wrong_result(built.entry, actor.at.span, fault)
    for field in fields(Standing):
        size = np.size(getattr(found, field.name))
        if size != copies.count:
            fault = f"gave `{field.name}` of {size} numbers for {copies.count} copies"
            raise wrong_result(built.entry, actor.at.span, fault)
    return found


def names_another(actor: ScenarioActor, scenario: IndexedScenario) -> bool:
    """Whether its position is by another agent or object."""
    return isinstance(actor.at, PassCall) and _other(actor, scenario)[0] is not None


def named_other(actor: ScenarioActor, scenario: IndexedScenario) -> str:
    """What its position is by, as it is written: `lead`, or `lead[0]` for a copy of a group."""
    other, copy = _other(actor, scenario)
    assert other is not None
    return f"{other.name}[{copy - 1}]" if copy else other.name


def standing_beside(
    actor: ScenarioActor, copies: CopyBatch, others: Others
) -> tuple[PlacedBatch, Standing]:
    """The other that copies (R,) are placed by, and where they stand on its road: arrays (R, 1).
    Those of a row have what their first has."""
    spaced = "spacing" in actor.options
    first = copies.numbered(np.ones(copies.count, np.int64)) if spaced else copies
    other, copy = _other(actor, copies.scenario)
    assert other is not None
    return _of_copies(other, copy, first, others(other)), standing_of(actor, first, others)


def other_of_copies(
    actor: ScenarioActor, copies: CopyBatch, counts: int
) -> tuple[ScenarioActor, Integers]:
    """The agent or object that copies are placed by, and which of its `counts` copies each."""
    other, copy = _other(actor, copies.scenario)
    assert other is not None
    is_alone = copy or not is_group(other) or "spacing" in actor.options
    numbers = np.full(copies.count, max(copy, 1) - 1) if is_alone else copies.copies - 1
    return other, np.minimum(numbers, counts - 1)


def _other(actor: ScenarioActor, scenario: IndexedScenario) -> tuple[ScenarioActor | None, int]:
    """The agent or object that its position names, and the number of the copy, or 0."""
    for entity in scenario.dependencies.entities(actor.at):
        if entity.name in scenario.actors:
            return scenario.actors[entity.name], entity.copy
    return None, 0


def row_distances(actor: ScenarioActor, copies: CopyBatch) -> list[list[float]]:
    """(R) how far from the first of its row each copy stands, after all of those between; of a copy
    in no row, 0. Signs as in `_from_the_first`."""
    value = actor.options.get("spacing")
    if value is None:
        return [[0.0]] * copies.count
    if not copies.scenario.dependencies.draws(value):
        steps = number_of_copies(actor, "spacing", copies, 0.0).tolist()
        numbers = copies.copies.tolist()
        return [
            [step * k for k in range(number)] for step, number in zip(steps, numbers, strict=True)
        ]
    ends, which = _row_ends(actor, copies)
    return [
        ends[group, :number].tolist()
        for group, number in zip(which.tolist(), copies.copies.tolist(), strict=True)
    ]


def _of_copies(
    other: ScenarioActor, copy: int, copies: CopyBatch, placed: PlacedBatch
) -> PlacedBatch:
    """Another agent or object in the scene of each copy: arrays (R, 1). `copy`: the one of its
    copies that is named, or 0."""
    most = placed.x.shape[1]
    if most < max(copy, 1):
        zero, no = np.zeros((copies.count, 1)), np.zeros((copies.count, 1), bool)
        start, lane = zero + _NOWHERE, no.astype(np.int64)
        return PlacedBatch(no, zero, zero, zero, zero, zero, start, zero, lane, no, lane - 1)
    numbers = np.minimum(copies.copies, most) if is_group(other) else np.ones(copies.count, int)
    numbers = np.full(copies.count, copy) if copy else numbers
    parts = (getattr(placed, field.name) for field in fields(PlacedBatch))
    found = PlacedBatch(*(part[copies.rows, numbers - 1][:, None] for part in parts))
    if not copy or found.present.all():
        return found
    return replace(found, start=np.where(found.present, found.start, _NOWHERE))


def _from_the_first(actor: ScenarioActor, copies: CopyBatch) -> Floats:
    """(R,) meters from the first copy of a row to each: the spacings between, added up. Below 0
    those behind it; of a row that is placed by another, toward that."""
    value = actor.options["spacing"]
    if not copies.scenario.dependencies.draws(value):
        return (copies.copies - 1) * number_of_copies(actor, "spacing", copies, 0.0)
    ends, which = _row_ends(actor, copies)
    return np.asarray(ends[which, copies.copies - 1])


def _row_ends(actor: ScenarioActor, copies: CopyBatch) -> tuple[Floats, Integers]:
    """Arc lengths (G, N) from the first copy of each row to all, and the row of each copy (R,)."""
    most = int(copies.copies.max(initial=1))
    rows, which = np.unique(np.stack([copies.rows, copies.tries]), axis=1, return_inverse=True)
    every = CopyBatch(
        copies.candidates,
        np.repeat(rows[0], most),
        np.tile(np.arange(1, most + 1), rows.shape[1]),
        np.repeat(rows[1], most),
    )
    steps = number_of_copies(actor, "spacing", every, 0.0).reshape(-1, most)
    ends = np.cumsum(steps, axis=1) - steps[:, :1]
    return ends, which.reshape(-1)


def _of_rows(columns: Floats, copies: CopyBatch) -> Floats:
    """(V or 1, 1) to (R,)."""
    numbers = columns.reshape(-1)
    return numbers[np.minimum(copies.rows, len(numbers) - 1)]
