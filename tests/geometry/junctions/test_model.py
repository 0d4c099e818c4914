"""What connections are by their pieces."""

from __future__ import annotations

import pytest

from roadlang.geometry.networks.junction_model import Connection, LaneEnd


def connection(*pieces: tuple[float, float]) -> Connection:
    ends = LaneEnd(1, "end", -1), LaneEnd(2, "start", -1)
    line = (0.0, 2.0), (0.0, -2.0)
    return Connection(0, *ends, "left", (0.0, 0.0, 0.0), pieces, (3.0, 3.5), line)


def test_a_connection_is_as_sharp_as_its_sharpest_piece() -> None:
    made = connection((2.0, 0.0), (3.0, 0.05), (4.0, -0.2), (1.5, 0.1))
    assert made.curvature == 0.2
    assert made.length == pytest.approx(10.5)
    assert connection((5.0, 0.0)).curvature == 0.0
