"""Roads as a graph: junctions and ends are nodes, the lines between them are edges."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from roadlang.geometry import Floats


@dataclass
class Line:
    """A line between two nodes: points (n, 2) in pixels, x right, y down; a loop has one node."""

    start: int
    end: int
    points: Floats
    linked: float = 0.0
    """Share of the length that was bridged without evidence."""

    @property
    def length(self) -> float:
        """Pixels."""
        steps = self.points[1:] - self.points[:-1]
        return float(np.hypot(steps[:, 0], steps[:, 1]).sum())

    @property
    def closed(self) -> bool:
        """Whether it comes back to where it began."""
        return self.start == self.end


@dataclass
class Graph:
    """Nodes (x, y) by id, in the order of their ids, and lines."""

    nodes: dict[int, Floats] = field(default_factory=dict)
    lines: list[Line] = field(default_factory=list)

    def degree(self) -> dict[int, int]:
        """How many line ends meet at each node."""
        count = dict.fromkeys(self.nodes, 0)
        for line in self.lines:
            count[line.start] += 1
            count[line.end] += 1
        return count

    def add_node(self, position: Floats) -> int:
        """A new node; its id."""
        key = next(reversed(self.nodes), -1) + 1
        self.nodes[key] = np.asarray(position, float)
        return key

    def drop_lonely(self) -> None:
        """Forget nodes without lines."""
        self.nodes = {key: self.nodes[key] for key, count in self.degree().items() if count}
