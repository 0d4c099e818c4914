"""`roadlang explain FAILURE.json`: which draws matter, and the moment it went wrong."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from .console import echo, shown, style

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

    name, medians = record["expectation"], record["medians"]
    singles = [item for item in medians if len(item["draws"]) == 1]
    holding = {item["draws"][0] for item in singles if item["holds"]}
    pairs = [item for item in medians if len(item["draws"]) == 2 and not holding & {*item["draws"]}]
    head = f"{style('violated', fg='red')}  {name}: {record['text']}"
    rho = plain(quantity(record["robustness"], record["unit"]))
    lines = [f"{head}  robustness {rho}", *_moment(record["moment"])]
    lines += ["", f"robustness of {name} with one random value at its median, the others unchanged"]
    lines += _rows(singles, record["unit"])
    helping = [item for item in pairs if item["holds"]]
    if helping:
        lines += ["", "with two at their medians, where neither helps alone"]
        lines += _rows(helping, record["unit"])
    elif not holding:
        lines += ["", "no single value, and no pair of the most important ones, makes it hold"]
    return lines


def _moment(moment: Mapping[str, Any] | None) -> list[str]:
    if moment is None:
        return []
    place = "" if moment["station"] is None else f", s = {moment['station']:.1f} m"
    place += f" ({moment['place']})" if moment["place"] else ""
    speed = "" if moment["speed"] is None else f", {moment['agent']} at {moment['speed']:.1f} m/s"
    partner = f", {moment['partner']}" if moment["partner"] else ""
    return [f"goes wrong at {moment['time']:.1f} s{place}{speed}{partner}"]


def _rows(items: Sequence[Mapping[str, Any]], unit: str) -> list[str]:
    rows = []
    for item in items[:_SHOWN]:
        word = style("holds", fg="green") if item["holds"] else ""
        number = _number(item, unit)
        rows.append(f"  {number:>11}  {' + '.join(item['draws'])}  {word}".rstrip())
    more = len(items) - _SHOWN
    return [*rows, f"  ... and {more} more"] if more > 0 else rows


def _number(item: Mapping[str, Any], unit: str) -> str:
    from ..report.numbers import plain, quantity

    if item["holds"] is None:
        return "no scene"
    if item["robustness"] is None:
        return "inf" if item["holds"] else "-inf"
    return plain(quantity(item["robustness"], unit))
