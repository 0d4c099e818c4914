"""The stop lines with signals on the routes of agents, and who crosses them at red."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry.arrays import Booleans, Floats, Integers
from .route_lines import RouteLine
from .signal_lights import Lights


@dataclass(frozen=True)
class StopLines:
    """Of L lines, at most X each, in their order."""

    along: Floats
    """(L, X) arc lengths of the line; infinite where it has fewer"""
    connection: Integers
    """(L, X) numbers in `lights` of the connections that begin there"""
    lights: Lights

    @classmethod
    def of(cls, lines: Sequence[RouteLine]) -> StopLines:
        """Those of lines, in their order."""
        found = [
            [(leg.begin, leg.turn) for leg in line.legs if leg.turn and leg.begin > 0.0]
            for line in lines
        ]
        found = [
            [(at, turn) for at, turn in row if turn.junction.control.kind == "signals"]
            for row in found
        ]
        junctions = {id(turn.junction): turn.junction for row in found for _, turn in row}
        lights = Lights.of(tuple(junctions.values()))
        numbers = {key: number for number, key in enumerate(junctions)}
        shape = len(lines), max((len(row) for row in found), default=0)
        along, connection = np.full(shape, math.inf), np.zeros(shape, dtype=np.int64)
        for place, row in enumerate(found):
            for column, (at, turn) in enumerate(row):
                ids = [one.id for one in turn.junction.connections]
                first = int(lights.first[numbers[id(turn.junction)]])
                along[place, column] = at
                connection[place, column] = first + ids.index(turn.connection.id)
        return cls(along, connection, lights)

    @property
    def is_empty(self) -> bool:
        """Whether no line crosses one."""
        return not self.along.shape[1]

    def crossed_at_red(
        self, line: Integers, front: Floats, moved: Floats, begin: Floats, seconds: float
    ) -> Booleans:
        """(n,) which of some agents have crossed one at red since the times `begin` (n,).

        `line` (n,): their lines, `front` (n,): arc lengths of their fronts then, `moved` (n,) how
        far they have come in the `seconds` since. Who is over the line at the start does not cross
        it.
        """
        stop = self.along[line]
        agent, column = np.nonzero((stop > front[:, None]) & (stop <= (front + moved)[:, None]))
        time = begin[agent] + (stop[agent, column] - front[agent]) / moved[agent] * seconds
        is_red = self.lights.is_red(self.connection[line[agent], column], time)
        crossed = np.zeros(len(line), dtype=bool)
        crossed[agent[is_red]] = True
        return crossed
