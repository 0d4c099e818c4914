"""Robustness on many drives: those with the same samples in time are one batch of signals.

Many formulas look at all samples alike (`always (x < 3)`). Their robustness stays the same if the
last sample is repeated, so that drives of different lengths are one batch too.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..diagnostics import DiagnosticError
from ..geometry.arrays import Floats
from ..ir.scene import Scene
from ..ir.trace import Trace
from ..plugins.registry import Registry
from ..stl.formula import formulas as f
from .drive_formulas import DriveFormula
from .drives import DriveCondition


@dataclass(frozen=True, eq=False)
class _Member:
    """An expectation of a drive, with the values of its variables."""

    drive: int
    name: str
    said: DriveFormula
    time: Floats
    values: Mapping[str, Any]


def robustness_together(
    scenes: Sequence[Scene], traces: Sequence[Trace], registry: Registry
) -> list[dict[str, float]]:
    """Of each drive, by expectation, what `DriveCondition.rho` is to the last bit; of those alone
    that are evaluated together: the others have to be evaluated by themselves."""
    found: list[dict[str, float]] = [{} for _ in scenes]
    by_formula: dict[int, list[_Member]] = defaultdict(list)
    for drive, (scene, trace) in enumerate(zip(scenes, traces, strict=True)):
        for member in _members(drive, scene, trace, registry):
            by_formula[id(member.said)].append(member)
    for batch in (batch for members in by_formula.values() for batch in _batches(members)):
        if len(batch) > 1:
            for member, rho in zip(batch, _rho(batch), strict=False):
                found[member.drive][member.name] = float(rho)
    return found


def _members(drive: int, scene: Scene, trace: Trace, registry: Registry) -> Iterator[_Member]:
    """The plain formulas over a drive, whose robustness is made of least and greatest numbers:
    these are the same however many rows there are, which sums need not be."""
    for verdict in scene.expectations:
        if verdict.domain != "drive" or verdict.formula is None or "monitor" in verdict.formula:
            continue
        try:
            condition = DriveCondition(verdict.formula, trace, registry)
            if not condition.evaluation.is_plain:
                continue
            choices = list(condition.choices())
        except DiagnosticError:  # told where the drive is judged
            continue
        if len(choices) == 1:
            yield _Member(drive, verdict.name, condition.said, trace.time, choices[0][1])


def _batches(members: Sequence[_Member]) -> Iterable[list[_Member]]:
    """The members of one formula that are evaluated together: those with the same samples in time
    and, where the last may be repeated, those with the first of the most samples."""
    longest = b""
    if _may_repeat_last(members[0].said.formula):
        longest = max((member.time.tobytes() for member in members), key=len)
    found: dict[bytes, list[_Member]] = defaultdict(list)
    for member in members:
        own = member.time.tobytes()
        found[longest if own and longest.startswith(own) else own].append(member)
    return found.values()


def _may_repeat_last(formula: f.Formula) -> bool:
    """Whether it means the same with more samples like the last: each operator looks at one sample,
    or at all from one on."""
    return all(
        (isinstance(part, f.UnaryTemporal) and not part.past and part.window is None)
        or isinstance(part, f.Truth | f.Comparison | f.Pointwise)
        for part in formula.walk()
    )


def _rho(members: Sequence[_Member]) -> Floats:
    """(V,) the robustness of each, none where it cannot be evaluated."""
    longest = max(members, key=lambda member: len(member.time))
    signals = {
        name: _stacked([member.values[name] for member in members], len(longest.time))
        if isinstance(value, np.ndarray)
        else value
        for name, value in longest.values.items()
    }
    try:
        rho = longest.said.formula.rho(longest.time, signals)
    except DiagnosticError:
        return np.empty(0)
    return np.broadcast_to(rho, len(members))  # of no signal at all there is but one


def _stacked(rows: Sequence[Floats], samples: int) -> Floats:
    """(V, samples) of rows of so many samples or fewer, the last of each repeated."""
    stacked = np.empty((len(rows), samples))
    for into, row in zip(stacked, rows, strict=True):
        into[: len(row)] = row
        into[len(row) :] = row[-1]
    return stacked
