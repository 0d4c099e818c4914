"""Below the legend: signals and robustness over arc length, one row each, with their extremes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from operator import itemgetter
from typing import TYPE_CHECKING

from roadlang.api import geometry

from . import palette
from .markup import element, group, number, path_data, rho, text

if TYPE_CHECKING:
    from roadlang.api import Profile, Scene
    from roadlang.geometry import Floats

_ROW = 3.1
_PLOT = 2.1
_MOST_ROWS = 8
_TICKS = 8


@dataclass(frozen=True)
class ProfileRow:
    """A curve over arc length with a dot at `station`; a robustness is filled down to zero."""

    name: str
    note: str
    profile: Profile
    station: float
    signal: bool = False


def rows_of(scene: Scene) -> list[ProfileRow]:
    """The `let` signals, then the judged constraints; of networks, the road of the extreme."""
    rows = []
    for signal in scene.signals:
        peaks = [_peak(profile) for profile in signal.profiles if profile.values]
        if peaks:
            _, at, largest = max(peaks, key=itemgetter(0))
            note = f"up to {number_text(largest.values[at])} {signal.unit}".rstrip()
            rows.append(ProfileRow(signal.name, note, largest, largest.stations[at], signal=True))
    for verdict in (*scene.requirements, *scene.expectations):
        place = verdict.tightest
        shown = [p for p in verdict.profiles if place is not None and p.road == place.road]
        if place is not None and shown and verdict.robustness is not None:
            rows.append(ProfileRow(verdict.name, rho(verdict.robustness), shown[0], place.station))
    return rows[:_MOST_ROWS]


def _peak(profile: Profile) -> tuple[float, int, Profile]:
    """The greatest size of the values of a profile, and where it is first."""
    import numpy as np

    sizes = np.abs(profile.values)
    at = int(sizes.argmax())
    return float(sizes[at]), at, profile


def number_text(value: float) -> str:
    """Three significant digits with a typographic minus."""
    return f"{value:.3g}".replace("-", "\N{MINUS SIGN}")


def height(rows: Sequence[ProfileRow], size: float) -> float:
    """Pixels that the rows and their axis take."""
    return (len(rows) * _ROW + 2.4) * size if rows else 0.0


def profiles(rows: Sequence[ProfileRow], x: float, y: float, width: float, size: float) -> str:
    """The plots from (x, y) down, all over the same arc length."""
    if not rows:
        return ""
    left = x + 0.62 * size * max(10, min(22, max(len(row.name) for row in rows)))
    length = max(row.profile.stations[-1] for row in rows) or 1.0
    drawn: list[str] = []
    for index, row in enumerate(rows):
        top = y + (index * _ROW + 0.5) * size
        drawn += _row(row, x, top, left, x + width, length, size)
    drawn += _axis(y + (len(rows) * _ROW + 0.2) * size, left, x + width, length, size)
    return group(drawn, class_="profiles", font_size=0.9 * size, fill=palette.INK)


def _row(
    row: ProfileRow, x: float, top: float, left: float, right: float, length: float, size: float
) -> Iterator[str]:
    import numpy as np

    height = _PLOT * size
    values, stations = np.asarray(row.profile.values), np.asarray(row.profile.stations)
    low, high = min(float(values.min()), 0.0), max(float(values.max()), 0.0)
    span = (high - low) or 1.0
    across = left + (right - left) * stations / length
    down = top + height * (high - values) / span
    zero = top + height * high / span
    base = top + 0.62 * height
    yield text(row.name, x, base - 0.5 * size, font_weight="600")
    yield text(row.note, x, base + 0.6 * size, font_size=0.8 * size, fill=palette.MUTED_INK)
    yield element("line", x1=left, y1=zero, x2=right, y2=zero, stroke=palette.GROUND_EDGE,
                  stroke_width=1.0)  # fmt: skip
    if not row.signal:
        yield from _filled(across, down, zero)
    color = palette.AGENTS[0] if row.signal else palette.SATISFIED
    yield element("path", d=path_data(_thinned(across, down)), fill="none", stroke=color,
                  stroke_width=1.3, stroke_linejoin="round")  # fmt: skip
    at = int(np.abs(stations - row.station).argmin())
    yield element("circle", cx=float(across[at]), cy=float(down[at]), r=0.22 * size,
                  fill=color if row.signal else palette.TIGHT)  # fmt: skip


def _filled(across: Floats, down: Floats, zero: float) -> Iterator[str]:
    """The area to zero: green where the robustness is positive, red where it is negative."""
    import numpy as np

    for limit, color in ((np.minimum, palette.SATISFIED), (np.maximum, palette.VIOLATIONS[0])):
        edge = limit(down, zero)
        if (edge != zero).any():
            line = _thinned(across, edge)
            outline = np.concatenate([[[line[0, 0], zero]], line, [[line[-1, 0], zero]]])
            yield element("path", d=path_data(outline, closed=True), fill=color, fill_opacity=0.16)


def _thinned(across: Floats, down: Floats) -> Floats:
    """At most a point a pixel, extremes kept: (n, 2)."""
    import numpy as np

    line = np.column_stack([across, down])
    most = 1200
    if len(line) <= most:
        return line
    groups = np.array_split(np.arange(len(line)), most // 2)
    keep = [i for g in groups for i in sorted({g[line[g, 1].argmin()], g[line[g, 1].argmax()]})]
    return line[sorted({0, *keep, len(line) - 1})]


def _axis(y: float, left: float, right: float, length: float, size: float) -> Iterator[str]:
    step = geometry.round_length(length / _TICKS * 2)
    yield element("line", x1=left, y1=y, x2=right, y2=y, stroke=palette.MUTED_INK,
                  stroke_width=0.8)  # fmt: skip
    for index in range(int(length / step + 1e-9) + 1):
        at = left + (right - left) * index * step / length
        yield element("line", x1=at, y1=y, x2=at, y2=y + 0.3 * size, stroke=palette.MUTED_INK,
                      stroke_width=0.8)  # fmt: skip
        if index and at > right - 6 * size:  # the axis has its name there
            continue
        label = number(index * step) + (" m" if index == 0 else "")
        yield text(label, at, y + 1.25 * size, text_anchor="middle", font_size=0.8 * size,
                   fill=palette.MUTED_INK)  # fmt: skip
    yield text("arc length", right, y + 1.25 * size, text_anchor="end", font_size=0.8 * size,
               fill=palette.MUTED_INK)  # fmt: skip
