"""Robustness on many drives: those with the same samples in time are one batch of signals."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..diagnostics import DiagnosticError
from ..geometry.arrays import Floats
from ..ir.scene import Scene
from ..ir.trace import Trace
from ..plugins.registry import Registry
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
    alike: dict[tuple[int, bytes], list[_Member]] = defaultdict(list)
    for drive, (scene, trace) in enumerate(zip(scenes, traces, strict=True)):
        for member in _members(drive, scene, trace, registry):
            alike[id(member.said), member.time.tobytes()].append(member)
    for members in alike.values():
        if len(members) > 1:
            for member, rho in zip(members, _rho(members), strict=False):
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


def _rho(members: Sequence[_Member]) -> Floats:
    """(V,) the robustness of each, none where it cannot be evaluated."""
    first = members[0]
    signals = {
        name: np.stack([member.values[name] for member in members])
        if isinstance(value, np.ndarray)
        else value
        for name, value in first.values.items()
    }
    try:
        rho = first.said.formula.rho(first.time, signals)
    except DiagnosticError:
        return np.empty(0)
    return np.broadcast_to(rho, len(members))  # of no signal at all there is but one
