"""Reference lines: the pieces of a `planView` as one curve."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from roadlang.geometry import Curve, Floats, GeometryError, poses_along
from roadlang_formats.map_xml import MapFile

from .records import GeometryRecord, RoadRecord

_SPACING = 2.0
_TURN = 0.1
"""Radians between samples, at most."""
_CUBIC_STEPS = 4
"""Samples of a cubic per meter, for its arc length."""
_SHORTEST = 1e-6
"""Meters: a shorter piece is left out, and samples that are nearer are one."""
_LARGEST_GAP = 1.0
"""Meters between the end of a piece and the beginning of the next."""
_KINK = 1e-4
"""Radians: a larger one is kept to the last `_BEFORE_KINK` meters of the piece before it."""
_BEFORE_KINK = 0.05
_STRETCHED = 1.5
"""By what factor the length of a cubic may differ from what the file says."""
_MOST_SAMPLES = 200_000
"""Of a road."""


@dataclass(frozen=True, eq=False)
class PlanViewCurve:
    """A curve, and its arc lengths (n,) at the `s` (n,) of the file."""

    curve: Curve
    s: Floats
    arc_lengths: Floats

    def along(self, s: Floats) -> Floats:
        """Arc lengths of the curve at `s` of the file."""
        return np.interp(s, self.s, self.arc_lengths)


def reference_line(file: MapFile, road: RoadRecord) -> PlanViewCurve:
    """The line of a road. Raises RL479 where pieces do not meet, or where nothing is left."""
    parts: list[Floats] = []
    stations: list[Floats] = []
    pieces = [piece for piece in road.geometry if piece.length > _SHORTEST]
    count = 0
    for index, piece in enumerate(pieces):
        s, poses = _sampled(file, piece)
        after = pieces[index + 1] if index + 1 < len(pieces) else None
        count += len(s)
        if count > _MOST_SAMPLES:
            raise file.fault(piece.element, f"road `{road.id}` turns too often to be followed")
        if after is not None:
            s, poses = _led_over(file, piece, after, s, poses)
        parts.append(poses)
        stations.append(piece.s + s)
    if not parts:
        raise file.fault(road.element, f"all pieces of road `{road.id}` have the length 0")
    poses, along = _distinct(np.concatenate(parts), np.concatenate(stations))
    try:
        curve = Curve.hermite(poses[:, :2], poses[:, 2])
        arc_lengths = curve.arc.length_at(curve.spline.knots)
    except GeometryError as error:
        raise file.fault(
            road.element, f"the reference line of road `{road.id}` is not a valid curve: {error}"
        ) from None
    return PlanViewCurve(curve, np.maximum.accumulate(along), arc_lengths)


def _distinct(poses: Floats, stations: Floats) -> tuple[Floats, Floats]:
    """Without samples that are nearly where the one before is."""
    keep = [0]
    for row in range(1, len(poses)):
        if math.dist(poses[row, :2], poses[keep[-1], :2]) > _SHORTEST:
            keep.append(row)
    if len(keep) > 1:
        keep[-1] = len(poses) - 1
    return poses[keep], stations[keep]


def _led_over(
    file: MapFile, piece: GeometryRecord, after: GeometryRecord, s: Floats, poses: Floats
) -> tuple[Floats, Floats]:
    """A piece without its last sample, in the place of which the next one begins."""
    gap = math.dist(poses[-1, :2], (after.x, after.y))
    if gap > _LARGEST_GAP:
        reason = f"this piece begins {gap:.3g} m away from the end of the one above it"
        raise file.fault(after.element, reason)
    kink = abs(math.remainder(float(poses[-1, 2]) - after.heading, 2.0 * math.pi))
    if (kink > _KINK or gap > 1e-4) and s[-1] - s[-2] > 2.0 * _BEFORE_KINK:
        near = _poses(file, piece, np.array([0.0, s[-1] - _BEFORE_KINK, s[-1]]))
        s = np.append(s[:-1], s[-1] - _BEFORE_KINK)
        return s, np.vstack((poses[:-1], near[1]))
    return s[:-1], poses[:-1]


def _sampled(file: MapFile, piece: GeometryRecord) -> tuple[Floats, Floats]:
    """`s` (n,) from the start of a piece, and poses (n, 3) there."""
    turn = _TURN * _SPACING
    if piece.kind in ("arc", "spiral"):
        turn = max(map(abs, piece.numbers)) * piece.length
    elif piece.kind != "line":
        turn = math.inf
    steps = 1 if piece.kind == "line" else int(min(max(turn / _TURN, piece.length / _SPACING), 1e9))
    if math.isinf(turn):
        steps = int(piece.length * _CUBIC_STEPS / 2.0)
    if steps > _MOST_SAMPLES:
        raise file.fault(piece.element, "this piece turns too often to be followed")
    s = np.linspace(0.0, piece.length, max(steps, 1 if piece.kind == "line" else 4) + 1)
    return s, _poses(file, piece, s)


def _poses(file: MapFile, piece: GeometryRecord, s: Floats) -> Floats:
    """(n, 3) x, y and heading at `s` (n,) from the start of a piece, from 0 on."""
    start = np.array([piece.x, piece.y, piece.heading])
    if piece.kind == "line":
        step = np.array([math.cos(piece.heading), math.sin(piece.heading), 0.0])
        return np.asarray(start + s[:, None] * step)
    if piece.kind == "arc":
        return poses_along(start, (piece.numbers[0], piece.numbers[0]), s)
    if piece.kind == "spiral":
        first, last = piece.numbers
        if s[-1] < piece.length:
            last = first + (last - first) * float(s[-1]) / piece.length
        return poses_along(start, (first, last), s)
    return _cubic_poses(file, piece, s, start)


def _cubic_poses(file: MapFile, piece: GeometryRecord, s: Floats, start: Floats) -> Floats:
    """Of `poly3`, a function of u, and of `paramPoly3`, whose parameter is p: at shares of its
    arc length."""
    fine = np.linspace(0.0, 1.0, max(64, min(int(piece.length * _CUBIC_STEPS), 20_000)) + 1)
    if piece.kind == "poly3":
        p = _reaching(piece, fine)
        u, v = np.polynomial.Polynomial([0.0, 1.0]), np.polynomial.Polynomial(piece.numbers)
    else:
        p = fine if piece.normalized else fine * piece.length
        u, v = (np.polynomial.Polynomial(piece.numbers[i : i + 4]) for i in (0, 4))
    du, dv = u.deriv(), v.deriv()
    speed = np.hypot(du(p), dv(p))
    middle = (p[1:] + p[:-1]) / 2.0
    # Simpson's rule on each step.
    steps = (speed[1:] + speed[:-1] + 4.0 * np.hypot(du(middle), dv(middle))) / 6.0 * np.diff(p)
    lengths = np.concatenate(([0.0], np.cumsum(steps)))
    found = float(lengths[-1])
    if not piece.length / _STRETCHED < found < piece.length * _STRETCHED:
        reason = f"this cubic is {found:.3g} m long, not {piece.length:g} m"
        raise file.fault(piece.element, reason)
    at = np.interp(s / piece.length * lengths[-1], lengths, p)
    local = np.column_stack((u(at), v(at)))
    cosine, sine = math.cos(piece.heading), math.sin(piece.heading)
    points = start[:2] + local @ np.array([[cosine, sine], [-sine, cosine]])
    return np.column_stack((points, piece.heading + np.arctan2(dv(at), du(at))))


def _reaching(piece: GeometryRecord, fine: Floats) -> Floats:
    """The values of u up to that at which a `poly3` is as long as the piece."""
    u = fine * piece.length
    slope = np.polynomial.Polynomial(piece.numbers).deriv()
    lengths = np.concatenate(([0.0], np.cumsum(np.diff(u) * _speeds(slope, u))))
    return np.asarray(fine * float(np.interp(piece.length, lengths, u)))


def _speeds(slope: np.polynomial.Polynomial, u: Floats) -> Floats:
    """The mean of `sqrt(1 + slope^2)` over each step."""
    middle = (u[1:] + u[:-1]) / 2.0
    ends = np.hypot(1.0, slope(u))
    return np.asarray((ends[1:] + ends[:-1] + 4.0 * np.hypot(1.0, slope(middle))) / 6.0)
