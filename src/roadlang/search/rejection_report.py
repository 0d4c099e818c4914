"""How many candidates each requirement rejected, and how near it came to being satisfied."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..judging.acceptance import AcceptanceResult
from ..judging.requirement import Requirement


@dataclass(frozen=True, slots=True)
class RejectionRow:
    """`share`: of the candidates that reached this requirement, `tried`, how many it rejected.
    `settled`: how many of them satisfy it by bounds alone, without its robustness being computed.

    `best` is the greatest robustness seen; None where it never had to be computed, or only of
    candidates that it rejected while bounds accepted others. `impossible`: no draw can satisfy it.
    """

    name: str
    text: str
    line: int | None
    tried: int
    rejected: int
    share: float
    best: float | None
    implied: bool
    impossible: bool = False
    settled: int = 0


@dataclass
class RejectionStats:
    """Counts for each requirement, merged in any order."""

    candidates: int = 0
    tried: list[int] = field(default_factory=list)
    rejected: list[int] = field(default_factory=list)
    settled: list[int] = field(default_factory=list)
    best: list[float] = field(default_factory=list)
    even_share: float | None = None
    """the share of even draws that hold, where it had to be guessed: candidates were not even"""

    @classmethod
    def empty(cls, requirements: int) -> RejectionStats:
        """Statistics of no candidates."""
        tried, rejected, settled = ([0] * requirements for _ in range(3))
        return cls(0, tried, rejected, settled, [-np.inf] * requirements)

    def count(self, result: AcceptanceResult, rows: NDArray[np.bool_]) -> None:
        """Count the candidates at `rows` (V,)."""
        by = result.rejected_by[rows]
        self.candidates += int(rows.sum())
        for index in range(len(self.tried)):
            settled = result.settled[index, rows]
            reached = ~np.isnan(result.rho[index, rows]) | settled | (by == index)
            self.tried[index] += int(reached.sum())
            self.settled[index] += int(settled.sum())
            self.rejected[index] += int((by == index).sum())
            seen = result.rho[index, rows][~np.isnan(result.rho[index, rows])]
            self.best[index] = max(self.best[index], float(seen.max(initial=-np.inf)))

    def see(self, index: int, robustness: float) -> None:
        """Take note of the robustness of a candidate that is counted already."""
        self.best[index] = max(self.best[index], robustness)

    def add(self, other: RejectionStats) -> None:
        """Add the counts of `other` to these."""
        self.candidates += other.candidates
        self.even_share = self.even_share if other.even_share is None else other.even_share
        for index in range(len(self.tried)):
            self.tried[index] += other.tried[index]
            self.rejected[index] += other.rejected[index]
            self.settled[index] += other.settled[index]
            self.best[index] = max(self.best[index], other.best[index])


def rows_of(
    stats: RejectionStats, requirements: Sequence[Requirement], impossible: frozenset[int]
) -> tuple[RejectionRow, ...]:
    """The table, those that reject most first; implicit requirements only where they reject."""
    rows = []
    for index, requirement in enumerate(requirements):
        tried, rejected = stats.tried[index], stats.rejected[index]
        if requirement.implied and not rejected:
            continue
        best = stats.best[index]
        is_seen = np.isfinite(best) and (best >= 0.0 or not stats.settled[index])
        rows.append(
            RejectionRow(
                requirement.name,
                requirement.text,
                requirement.line,
                tried,
                rejected,
                rejected / tried if tried else 0.0,
                best if is_seen else None,
                requirement.implied,
                index in impossible,
                stats.settled[index],
            )
        )
    return tuple(sorted(rows, key=lambda row: -row.rejected))


def rows_of_outcomes(
    requirements: Sequence[Requirement], robustness: Sequence[Mapping[str, float | None]]
) -> tuple[RejectionRow, ...]:
    """The table of candidates that were judged by all requirements, by name; without those that
    go without saying. Several may reject one candidate."""
    rows = []
    for one in requirements:
        found = [rho for each in robustness if (rho := each.get(one.name)) is not None]
        if one.implied or not found:
            continue
        rejected = sum(rho < 0.0 for rho in found)
        share = rejected / len(found)
        rows.append(
            RejectionRow(
                one.name, one.text, one.line, len(found), rejected, share, max(found), one.implied
            )
        )
    return tuple(sorted(rows, key=lambda row: -row.rejected))


def as_text(rows: Sequence[RejectionRow], candidates: int) -> str:
    """The table for people."""
    head = ("requirement", "rejected", "of those tried", "best robustness", "line")
    lines: list[tuple[str, ...]] = [head]
    for row in rows:
        best = f"{row.best:.3g}" if row.best is not None else "at least 0" if row.settled else "-"
        share = "impossible" if row.impossible else f"{row.share:.1%}"
        label = row.text if row.implied else f"{row.name}: {row.text}"
        line = "" if row.line is None else str(row.line)
        lines.append((label, f"{row.rejected:,} of {row.tried:,}", share, best, line))
    widths = [max(len(line[column]) for line in lines) for column in range(len(head))]
    table = "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip()
        for line in lines
    )
    return f"{candidates:,} candidates tried\n{table}"
