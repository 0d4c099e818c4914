"""Things seen from above, in their own frame: pixels, x ahead, y to the right, center at (0, 0)."""

from __future__ import annotations

from functools import lru_cache

from . import palette
from .markup import element, number


def car(length: float, width: float, color: str) -> list[str]:
    """Body, windscreen, rear window and roof."""
    glass = {"fill": "#1f2933", "fill_opacity": 0.85}
    half, side = length / 2, width / 2
    return [
        _box(-half, -side, length, width, 0.28 * width, fill=color, **_outline(width)),
        _quad(0.22 * length, 0.40 * width, 0.08 * length, 0.34 * width, **glass),
        _quad(-0.34 * length, 0.38 * width, -0.22 * length, 0.33 * width, **glass),
        _headlights(half, width),
    ]


def truck(length: float, width: float, color: str) -> list[str]:
    """A cab before a box."""
    half, side = length / 2, width / 2
    cab = 0.24 * length
    return [
        _box(-half, -side, length - cab - 0.02 * length, width, 0.06 * width,
             fill="#e9ecef", **_outline(width)),
        _box(half - cab, -0.46 * width, cab, 0.92 * width, 0.18 * width,
             fill=color, **_outline(width)),
        _quad(half - 0.32 * cab, 0.40 * width, half - 0.55 * cab, 0.36 * width,
              fill="#1f2933", fill_opacity=0.85),
    ]  # fmt: skip


def bicycle(length: float, width: float, color: str) -> list[str]:
    """Two wheels in line and a rider."""
    wheel = max(0.12 * width, 0.8)
    return [
        _line(-length / 2, 0, length / 2, 0, stroke="#343a40", stroke_width=wheel),
        _line(0.25 * length, -width / 2, 0.25 * length, width / 2,
              stroke="#343a40", stroke_width=wheel),
        element("ellipse", cx=0.0, cy=0.0, rx=0.16 * length, ry=0.38 * width, fill=color,
                **_outline(width)),
    ]  # fmt: skip


def pedestrian(length: float, width: float, color: str) -> list[str]:
    """Shoulders and a head."""
    size = max(length, width)
    return [
        element("ellipse", cx=0.0, cy=0.0, rx=0.30 * size, ry=0.52 * size, fill=color,
                **_outline(size)),
        element("circle", cx=0.04 * size, cy=0.0, r=0.24 * size, fill="#ffe8cc",
                **_outline(size)),
    ]  # fmt: skip


def building(length: float, width: float) -> list[str]:
    """A hipped roof, lit from one side."""
    half, side = length / 2, width / 2
    ridge = half - min(half, side) * 0.9
    h, s, r = f"{half:.2f}", f"{side:.2f}", f"{ridge:.2f}"
    dark = f"-{h},{s} {h},{s} {r},0.00 -{r},0.00"
    ends = f"-{h},-{s} -{h},{s} -{r},0.00", f"{h},-{s} {h},{s} {r},0.00"
    box = number(-half), number(-side), number(length), number(width)
    return [_roof() % (*box, dark, *ends)]


@lru_cache(maxsize=1)
def _roof() -> str:
    """The drawing of a building, without its numbers."""
    outline = {"stroke": palette.ROOF_LINE, "stroke_width": 0.7, "stroke_linejoin": "round"}
    parts = (
        _numberless_box(fill=palette.ROOF_LIGHT, **outline),
        element("polygon", points="%s", fill=palette.ROOF_DARK, **outline),
        *[element("polygon", points="%s", fill=palette.ROOF_LIGHT, fill_opacity=0.6, **outline)]
        * 2,
    )
    return "".join(parts)


def block(length: float, width: float, color: str) -> list[str]:
    """A kind that has no drawing of its own: its outline, and a mark at its front."""
    half, back, side = length / 2, length / 2 - 0.25 * width, 0.25 * width
    front = f"{half:.2f},0.00 {back:.2f},-{side:.2f} {back:.2f},{side:.2f}"
    stroke = number(_stroke_width(width))
    box = number(-half), number(-width / 2), number(length), number(width)
    return [_outlined_block(color) % (*box, number(0.1 * width), stroke, front)]


@lru_cache(maxsize=64)
def _outlined_block(color: str) -> str:
    """The drawing of a block, without its numbers."""
    outline = {"stroke": palette.INK, "stroke_width": "%s"}
    box = _numberless_box(rx="%s", fill=color, **outline)
    return box + element("polygon", points="%s", fill=palette.INK, fill_opacity=0.6)


def _numberless_box(**attributes: object) -> str:
    return element("rect", x="%s", y="%s", width="%s", height="%s", **attributes)


def _outline(width: float) -> dict[str, object]:
    return {"stroke": palette.INK, "stroke_width": _stroke_width(width)}


def _stroke_width(width: float) -> float:
    return min(max(0.05 * width, 0.4), 1.4)


def _box(
    x: float, y: float, length: float, width: float, radius: float, **attributes: object
) -> str:
    corner = float(radius) if radius else None
    return element("rect", x=x, y=y, width=length, height=width, rx=corner, **attributes)


def _quad(
    ahead: float, ahead_half: float, behind: float, behind_half: float, **attributes: object
) -> str:
    corners = [
        (ahead, -ahead_half), (ahead, ahead_half), (behind, behind_half), (behind, -behind_half)
    ]  # fmt: skip
    return _polygon(corners, **attributes)


def _headlights(half: float, width: float) -> str:
    lights = [
        f"M{half - 0.10 * width:.2f} {sign * 0.42 * width:.2f}v{-sign * 0.16 * width:.2f}"
        for sign in (1, -1)
    ]
    return element("path", d="".join(lights), stroke="#fff3bf", stroke_width=max(0.07 * width, 0.5))


def _line(x1: float, y1: float, x2: float, y2: float, **attributes: object) -> str:
    return element("line", x1=float(x1), y1=float(y1), x2=float(x2), y2=float(y2), **attributes)


def _polygon(points: list[tuple[float, float]], **attributes: object) -> str:
    listed = " ".join(f"{x:.2f},{y:.2f}" for x, y in points)
    return element("polygon", points=listed, **attributes)
