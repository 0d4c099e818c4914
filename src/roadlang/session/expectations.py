"""How each `expect` came out over several scenes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ..ir.scene import Verdict


@dataclass(frozen=True)
class Expectation:
    """One `expect`. `judged` and `violated` are indices of scenes, `worst` the least robustness.

    Not judged is what is about the drive before a scene is driven.
    """

    name: str
    text: str
    judged: tuple[int, ...]
    violated: tuple[int, ...]
    worst: float | None


def expectations_of(verdicts: Iterable[tuple[int, Verdict]]) -> tuple[Expectation, ...]:
    """Verdicts with the indices of their scenes, by name, in the order of the file."""
    by_name: dict[str, list[tuple[int, Verdict]]] = {}
    for index, verdict in verdicts:
        by_name.setdefault(verdict.name, []).append((index, verdict))
    return tuple(_expectation(found) for found in by_name.values())


def _expectation(found: list[tuple[int, Verdict]]) -> Expectation:
    first = found[0][1]
    values = [v.robustness for _, v in found if v.robustness is not None]
    return Expectation(
        first.name,
        first.text,
        tuple(index for index, v in found if v.satisfied is not None),
        tuple(index for index, v in found if v.satisfied is False),
        min(values, default=None),
    )
