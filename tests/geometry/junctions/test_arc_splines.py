"""Arcs through points: they end where the points do, stay near them, and are few."""

from __future__ import annotations

import math

import numpy as np
import pytest

from roadlang.geometry import Floats
from roadlang.geometry.junctions.arc_splines import Pieces, arc_spline

TOLERANCE = 0.02


def followed(pose: tuple[float, float, float], pieces: Pieces, spacing: float = 0.05) -> Floats:
    """(n, 3) x, y and heading along arcs from a pose, by the chord of each step."""
    found = [pose]
    for length, curvature in pieces:
        count = max(1, math.ceil(length / spacing))
        step = length / count
        chord = step * float(np.sinc(curvature * step / (2.0 * math.pi)))
        for _ in range(count):
            x, y, heading = found[-1]
            middle = heading + curvature * step / 2.0
            x, y = x + chord * math.cos(middle), y + chord * math.sin(middle)
            found.append((x, y, heading + curvature * step))
    return np.array(found)


def swaying(seed: int) -> Floats:
    """(n, 3) poses half a meter apart along a line whose curvature comes and goes."""
    rng = np.random.default_rng(seed)
    s = np.arange(0.0, 60.0, 0.5)
    bend = rng.uniform(-0.05, 0.05) + rng.uniform(-0.06, 0.06) * np.sin(
        s / rng.uniform(4.0, 12.0) + rng.uniform(0.0, 6.0)
    )
    pieces = tuple((0.5, float(k)) for k in bend)
    start = (*rng.uniform(-300.0, 300.0, 2), rng.uniform(-3.0, 3.0))
    return followed(start, pieces, spacing=1.0)


@pytest.mark.parametrize("seed", range(12))
def test_arcs_end_where_the_points_do_and_stay_near_them(seed: int) -> None:
    poses = swaying(seed)
    pieces = arc_spline(poses[:, :2], poses[:, 2], TOLERANCE)
    line = followed(tuple(poses[0].tolist()), pieces)
    assert np.abs(line[-1] - poses[-1]).max() < 2e-3
    away = np.hypot(*(poses[:, None, :2] - line[None, :, :2]).transpose(2, 0, 1))
    assert away.min(axis=1).max() < 0.05 + TOLERANCE
    assert math.fsum(length for length, _ in pieces) == pytest.approx(60.0, rel=2e-3)
    assert 2 <= len(pieces) <= len(poses) // 4


@pytest.mark.parametrize("place", [(0.0, 0.0, 0.0), (200.0, -80.0, 2.0)])
@pytest.mark.parametrize(
    "pieces",
    [
        ((30.0, 0.0),),
        ((20.0, 0.05),),
        ((12.0, -0.1),),
        ((20.0, 0.04), (20.0, -0.04)),
        ((15.0, 0.0), (15.0, 0.0)),
    ],
)
def test_arcs_are_found_again(place: tuple[float, float, float], pieces: Pieces) -> None:
    ends = np.array([place, followed(place, pieces)[-1]])
    (length, curvature), *rest = arc_spline(ends[:, :2], ends[:, 2], TOLERANCE)
    joined = ((30.0, 0.0),) if len(pieces) == 2 and pieces[0][1] == 0.0 else pieces
    found = [(length, curvature), *rest]
    assert len(found) == len(joined)
    for one, other in zip(found, joined, strict=True):
        assert one == pytest.approx(other, abs=1e-9)


def test_a_tighter_tolerance_takes_more_arcs() -> None:
    poses = swaying(3)
    counts = [len(arc_spline(poses[:, :2], poses[:, 2], t)) for t in (1.0, 0.1, 0.01, 0.001)]
    assert counts == sorted(counts)
    assert counts[0] < counts[-1]


def test_points_between_are_followed_where_the_ends_alone_would_be_a_straight_line() -> None:
    poses = followed((5.0, 5.0, 0.0), ((10.0, 0.1), (20.0, -0.1), (10.0, 0.1)), spacing=0.5)
    pieces = arc_spline(poses[:, :2], poses[:, 2], 0.05)
    line = followed(tuple(poses[0].tolist()), pieces)
    assert line[:, 1].max() == pytest.approx(poses[:, 1].max(), abs=0.05)
