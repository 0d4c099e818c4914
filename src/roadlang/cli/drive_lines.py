"""What `roadlang run` prints of drives: a line for each, or all expectations of the only one."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ..ir.result_columns import OF_DRIVES, robustness_column
from .console import echo, holding, style

if TYPE_CHECKING:
    from ..session.finished_drives import DriveLine

_MOST_CONTACTS = 3


def print_drive(drive: DriveLine, run: str, in_full: bool) -> None:
    """One line; `in_full`: how long it took and a line for each expectation."""
    label = f"{run}{': ' if run else ''}scene {drive.scene}"
    took = "no time" if drive.duration is None else f"{drive.duration:.1f} s"
    if not in_full:
        echo(f"{label}: {_outcome(drive)} ({took} driven)")
        _print_contacts(drive)
        _print_controller_failures(drive)
        return
    echo(f"{label}: {took} driven in {drive.engine}")
    for verdict in drive.verdicts:
        rho = "" if verdict.robustness is None else f"  robustness {verdict.robustness:.3g}"
        echo(f"  {_word(verdict.satisfied, 8)}  {verdict.name}: {verdict.text}{rho}")
    _print_contacts(drive)
    _print_controller_failures(drive)


def _print_contacts(drive: DriveLine) -> None:
    """Who touched whom, if no expectation says that something went wrong: they stand still from
    then on, which the expectations may not be about."""
    shown = [f"{each.agent} and {each.other} at {each.time:.1f} s" for each in drive.contacts]
    if shown:
        more = f" and {len(shown) - _MOST_CONTACTS} more" if len(shown) > _MOST_CONTACTS else ""
        echo(f"  {style('contact', fg='yellow')}  {', '.join(shown[:_MOST_CONTACTS])}{more}")


def _print_controller_failures(drive: DriveLine) -> None:
    for failure in drive.failures:
        word = style("failed", fg="red")
        echo(f"  {word}  controller of {failure.agent} at {failure.time:.1f} s: {failure.summary}")


def summary(rows: Sequence[Mapping[str, Any]], satisfied: Sequence[bool], contacts: int = 0) -> str:
    """In how many scenes all expectations hold, and in how many of them there are contacts all the
    same; of several scenes also the worst."""
    from ..judging.badness import badness, says_how_near

    text = holding(sum(satisfied), len(satisfied))
    if contacts:
        text += f", with contacts in {contacts} of them"
    failed = sum("controller failure time" in row for row in rows)
    if failed:
        text += f"; controllers failed in {failed}"
    found = [(*_of_worst(row), row) for row in rows if row.get("worst")]
    judged = [item for item in found if item[0] is not None]
    if len(rows) < 2 or not judged:
        return f"{text}; "
    holds, rho, worst = min(judged, key=lambda item: badness(*item[:2]))
    if not says_how_near(holds, rho):
        return f"{text}; "
    run = f"{worst['run']}, " if "run" in worst else ""
    name = worst["worst"] if rho is None else f"{worst['worst']} {rho:.3g}"
    at = (worst.get(f"worst {name}") for name in ("time", "station", "road"))
    place = _place(*at)
    return f"{text}; worst: {run}scene {worst['scene']}, {name}{place}; "


def _of_worst(row: Mapping[str, Any]) -> tuple[bool | None, float | None]:
    """Whether the worst expectation of a drive is satisfied, and its robustness."""
    name = row["worst"]
    return row.get(f"{name} satisfied"), row.get(robustness_column(name, OF_DRIVES))


def _outcome(drive: DriveLine) -> str:
    from ..judging.badness import says_how_near

    worst = drive.worst
    if worst is None:
        return "nothing to judge" if not drive.verdicts else "not judged"
    if not says_how_near(worst.satisfied, worst.robustness):
        return _word(worst.satisfied)
    rho = "" if worst.robustness is None else f" {worst.robustness:.3g}"
    place = _place(drive.worst_time, drive.worst_station, drive.worst_road)
    if drive.worst_time is not None and drive.first_time is not None:
        place = f", first at {drive.first_time:.1f} s, worst{place}"
    between = ", worst: " if worst.satisfied else " "
    return f"{_word(worst.satisfied)}{between}{worst.name}{rho}{place}"


def _place(time: float | None, station: float | None, road: str | None) -> str:
    along = "" if station is None or math.isnan(station) else f", s = {station:.0f} m"
    if road:
        return f" on {road}{along}"
    return "" if time is None else f" at {time:.1f} s{along}"


def _word(satisfied: bool | None, width: int = 0) -> str:
    """How an expectation came out, padded to `width` before it is colored."""
    if satisfied is None:
        return "not judged"
    word, color = ("holds", "green") if satisfied else ("violated", "red")
    return style(word.ljust(width), fg=color)
