"""`roadlang explain FAILURE.json`: which draws matter, and the moment it went wrong."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .console import echo, shown, style

if TYPE_CHECKING:
    from ..report.explained import FailureExplanation, ShownInfluence

_SHOWN = 10
"""Draws, and pairs of them, that are listed."""


def explain_failure(file: str, scene_file: str | None) -> None:
    """Print and write what is found."""
    from ..session.failure_files import failure_in
    from ..session.failure_findings import explanation, write_explanation

    record = explanation(failure_in(file, scene_file))
    echo("\n".join(_lines(record)))
    written = write_explanation(record, Path(file))
    echo(f"the complete results are in {shown(written)}")


def _lines(record: Mapping[str, Any]) -> list[str]:
    from ..report.numbers import plain, quantity

    found = _typed(record)
    name, unit = found.expectation, found.unit
    head = f"{style('violated', fg='red')}  {name}: {record['text']}"
    rho = plain(quantity(record["robustness"], unit))
    lines = [f"{head}  robustness {rho}", *_moment(record["moment"])]
    lines += ["", f"robustness of {name} with one random value at its median, the others unchanged"]
    lines += _rows(found.singles, unit)
    if found.without_effect:
        lines += ["", "no effect by themselves: " + ", ".join(found.without_effect)]
    if found.pairs:
        lines += ["", "with two at their medians, where neither helps alone"]
        lines += _rows(found.pairs, unit)
    elif not any(item.holds for item in found.singles):
        lines += ["", "no single value, and no pair of the most important ones, makes it hold"]
    return lines


def _typed(record: Mapping[str, Any]) -> FailureExplanation:
    from ..report.explained import FailureExplanation, ShownInfluence

    medians = (
        ShownInfluence(tuple(item["draws"]), item["robustness"], item["holds"])
        for item in record["medians"]
    )
    known = record["expectation"], record["unit"], tuple(medians), record["robustness"]
    return FailureExplanation(*known)


def _moment(moment: Mapping[str, Any] | None) -> list[str]:
    if moment is None:
        return []
    place = "" if moment["station"] is None else f", s = {moment['station']:.1f} m"
    place += f" ({moment['place']})" if moment["place"] else ""
    speed = "" if moment["speed"] is None else f", {moment['agent']} at {moment['speed']:.1f} m/s"
    partner = f", {moment['partner']}" if moment["partner"] else ""
    return [f"goes wrong at {moment['time']:.1f} s{place}{speed}{partner}"]


def _rows(items: Sequence[ShownInfluence], unit: str) -> list[str]:
    rows = []
    for item in items[:_SHOWN]:
        word = style("holds", fg="green") if item.holds else ""
        number = _number(item, unit)
        rows.append(f"  {number:>11}  {' + '.join(item.draws)}  {word}".rstrip())
    more = len(items) - _SHOWN
    return [*rows, f"  ... and {more} more"] if more > 0 else rows


def _number(item: ShownInfluence, unit: str) -> str:
    from ..report.numbers import plain, quantity

    if item.holds is None:
        return "no scene"
    if item.robustness is None:
        return "inf" if item.holds else "-inf"
    return plain(quantity(item.robustness, unit))
