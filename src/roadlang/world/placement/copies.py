"""How many copies an agent or object has, and what kind each of them is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...diagnostics import Code, DiagnosticError, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.copies import CopyBatch
from ...evaluate.draw_record import DrawRecord
from ...evaluate.evaluation import build, converted, evaluate
from ...evaluate.kind_instance import KindInstance, scalar
from ...evaluate.option_bounds import check_bounds
from ...geometry.arrays import Booleans, Floats
from ...ir.category import PAINTED, PEDESTRIAN
from ...ir.read_only import frozen
from ...ir.scenario import ScenarioActor
from ...ir.values import Condition, Measure, PassCall, RandomValue
from ...plugins.common_options import MOST_COPIES
from ...plugins.guard import plugin_guard
from ...plugins.options import schema_of

_UNUSUAL_SIZE = 1.0
"""Meters, of a kind that has no length or width"""


def counts(actor: ScenarioActor, candidates: CandidateBatch) -> NDArray[np.int64]:
    """(V,) how many copies there are. Raises RL612."""
    count = actor.options.get("count")
    if count is None:
        return np.ones(candidates.count, dtype=np.int64)
    value = np.asarray(evaluate(count, candidates), dtype=np.float64).reshape(-1)
    if not ((value >= 0) & (value <= MOST_COPIES)).all():
        found = f"{float(value[(value < 0) | (value > MOST_COPIES)][0]):g}"
        raise DiagnosticError(
            diagnose(
                Code.COUNT_OUT_OF_BOUNDS,
                actor.span_of("count"),
                name=actor.name,
                count=found,
                most=MOST_COPIES,
                help=f"limit it, as in `max(0, min(COUNT, {MOST_COPIES}))`",
            )
        )
    return np.broadcast_to(np.rint(value).astype(np.int64), (candidates.count,))


def most_copies(actor: ScenarioActor, candidates: CandidateBatch) -> int:
    """The greatest count among these candidates."""
    return int(counts(actor, candidates).max(initial=0))


def is_group(actor: ScenarioActor) -> bool:
    """Whether it has a `count`, so that its copies are numbered."""
    return "count" in actor.options


def element_of(actor: ScenarioActor) -> int:
    """What `evaluate` is called with for a `CopyBatch` of it."""
    return 1 if is_group(actor) else 0


def is_absent(
    condition: Condition, copy: int, candidates: CandidateBatch
) -> NDArray[np.bool_] | None:
    """(V,) candidates that do not have this copy of a group that a formula speaks of."""
    absent = None
    for entity in candidates.scenario.dependencies.entities(condition):
        if entity.role in ("agent", "object"):
            actor = candidates.scenario.actors[entity.name]
            if is_group(actor):
                missing = counts(actor, candidates) < (entity.copy or copy)
                absent = missing if absent is None else absent | missing
    return absent


@dataclass(frozen=True)
class CopyKinds:
    """The kind of each copy, candidates one after the other; equal copies share one."""

    instances: tuple[KindInstance, ...]
    drawn: tuple[tuple[CopyBatch, NDArray[np.intp]], ...] = ()
    """the copies of which the kind, or options of it, were drawn, and which of all they are"""

    def record_in(self, record: DrawRecord, present: Booleans | None = None) -> None:
        """Add what was drawn to a record; see `CopyBatch.record_in`."""
        for copies, index in self.drawn:
            copies.record_in(record, None if present is None else present[index])

    @cached_property
    def lengths(self) -> Floats:
        """(R,) meters along the heading."""
        return self._sizes("length")

    @cached_property
    def widths(self) -> Floats:
        """(R,) meters across the heading; NaN of paint that is as wide as the road where it
        lies."""
        return self._sizes("width")

    @cached_property
    def are_markings(self) -> Booleans:
        """(R,) which of them are paint."""
        return np.array([found.kind.category in PAINTED for found in self.instances], dtype=bool)

    @cached_property
    def are_pedestrians(self) -> Booleans:
        """(R,) which of them keep to lanes for pedestrians."""
        return np.array([found.kind.category == PEDESTRIAN for found in self.instances], dtype=bool)

    def _sizes(self, name: str) -> Floats:
        distinct = {id(found): found for found in self.instances}
        sizes = {key: _size(found.kind, name) for key, found in distinct.items()}
        return np.array([sizes[key] for key in map(id, self.instances)])


def kinds_of_copies(actor: ScenarioActor, copies: CopyBatch) -> CopyKinds:
    """What each copy is, its options drawn."""
    scenario = copies.scenario
    if scenario.dependencies.differ(actor.kind):
        return _kinds(actor, copies)
    first = copies.chosen(np.zeros(1, dtype=np.intp))
    make = partial(_kinds, actor, first)
    same = scenario.once(("kind of copies", actor.name), lambda: make().instances[0])
    return CopyKinds((same,) * copies.count)


def _kinds(actor: ScenarioActor, copies: CopyBatch) -> CopyKinds:
    element = element_of(actor)
    value = evaluate(actor.kind, copies, element)
    calls = value.reshape(-1).tolist() if isinstance(value, np.ndarray) else [scalar(value)]
    if len(calls) == 1:
        calls = calls * copies.count
    keys = np.array([*map(id, calls)])
    instances: list[KindInstance] = [None] * copies.count  # type: ignore[list-item]
    drawn = []
    for call in {id(call): call for call in calls}.values():
        rows = np.flatnonzero(keys == id(call))
        chosen = copies.chosen(rows)
        for row, found in zip(rows.tolist(), _instances(call, chosen, element), strict=True):
            instances[row] = found
        drawn.append((chosen, rows))
    return CopyKinds(tuple(instances), (*drawn, (copies, np.arange(copies.count))))


def _instances(call: PassCall, copies: CopyBatch, element: int) -> Sequence[KindInstance]:
    """The kind of a call for each row: the same where none of its options is drawn."""
    contents = copies.scenario.dependencies.contents(call)
    if not any(isinstance(value, RandomValue | Measure) for value in contents):
        return [build(call, copies, element, single=True)] * copies.count
    entry, kind = copies.scenario.kind(call)
    written = call.options
    fields: dict[str, Any] = {o.name: o.default for o in schema_of(kind) if not o.required}
    columns: dict[str, list[Any]] = {}
    for option in schema_of(kind):
        if option.name in written:
            value = evaluate(written[option.name], copies, element)
            check_bounds(option, value, call)
            converted_rows = (
                converted(option, row, copies, element, True) for row in _rows(value, copies.count)
            )
            columns[option.name] = list(map(frozen, converted_rows))
    with plugin_guard(entry, call.span):
        return [
            KindInstance(
                kind(**fields | {k: rows[row] for k, rows in columns.items()}), entry, call
            )
            for row in range(copies.count)
        ]


def _rows(value: Any, count: int) -> list[Any]:
    """The value of each row, as plain numbers and words, also inside lists and maps."""
    if isinstance(value, np.ndarray):
        rows = value.reshape(-1).tolist()
        return rows if len(rows) == count else rows * count
    if isinstance(value, tuple):
        return list(zip(*(_rows(item, count) for item in value), strict=True)) or [()] * count
    if isinstance(value, dict):
        columns = {key: _rows(item, count) for key, item in value.items()}
        return [{key: rows[row] for key, rows in columns.items()} for row in range(count)]
    return [scalar(value)] * count


def _size(kind: Any, name: str) -> float:
    size = getattr(kind, name, None)
    if size is None and name == "width" and kind.category in PAINTED:
        return math.nan
    return float(size or _UNUSUAL_SIZE)


def kinds_of(actor: ScenarioActor, candidates: CandidateBatch) -> CopyKinds:
    """The kind of every copy, candidates one after the other. What was drawn for a candidate alone
    is recorded; of several, where `CopyKinds.record_in` is called."""

    def make() -> CopyKinds:
        if most_copies(actor, candidates) == 0:
            return CopyKinds(())
        copies = CopyBatch.every(candidates, most_copies(actor, candidates))
        kinds = kinds_of_copies(actor, copies)
        if candidates.record is not None and candidates.count == 1:
            kinds.record_in(candidates.record)
        return kinds

    return candidates.once(("kinds", actor.name), make, inherited=False)
