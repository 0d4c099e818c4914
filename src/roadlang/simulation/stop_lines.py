"""Stop lines that agents cross, and what the signals there show."""

from __future__ import annotations

import numpy as np

from ..geometry.arrays import Booleans, Floats, Integers
from ..ir.scene_junctions import SceneControl
from .route_table import RouteTable


def is_red(control: SceneControl, connection: int, time: float) -> bool:
    """Whether the signals of a junction show red to a connection; never where it has none.

    Green and yellow of the phases that have the connection are not red. `time`: seconds since the
    start of the drive.
    """
    if control.kind != "signals" or not control.phases:
        return False
    lengths = [phase.green + phase.yellow + phase.all_red for phase in control.phases]
    left = (time + control.offset) % sum(lengths)
    for phase, length in zip(control.phases, lengths, strict=True):
        if left < length:
            return connection not in phase.connections or left >= phase.green + phase.yellow
        left -= length
    return False


def has_signals(table: RouteTable) -> bool:
    """Whether any connection of the lines has signals."""
    return any(turn.junction.control.kind == "signals" for turn in table.turns)


def crossed_at_red(
    table: RouteTable, rows: Integers, front: Floats, moved: Floats, begin: Floats, seconds: float
) -> Booleans:
    """(n,) which of some agents have crossed a stop line at red since the times `begin` (n,).

    `front` (n,): arc lengths of their fronts then, `moved` (n,) how far they have come in the
    `seconds` since. Who is over the line at the start does not cross it.
    """
    line, turn = table.next_turn(rows, front)
    crosses = (line <= front + moved) & (turn >= 0)
    for i in np.flatnonzero(crosses):
        found = table.turns[turn[i]]
        time = float(begin[i]) + float((line[i] - front[i]) / moved[i]) * seconds
        crosses[i] = is_red(found.junction.control, found.connection.id, time)
    return np.asarray(crosses)
