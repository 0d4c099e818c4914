"""A figure of a drive: the roads, the paths of agents, and where robustness was lost."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from html import escape

import numpy as np

from ..geometry.arrays import Floats
from ..ir.category import GREENERY
from ..ir.scene import Scene, SceneActor
from ..ir.trace import AgentTrace, Trace
from ..scenes.figure_colors import FIGURE_COLORS, object_color
from .drawn_roads import drawn_roads
from .figure_key import Shown, figure_key
from .robustness_colors import OTHER, color_shares, robustness_color

_SIZE, _MARGIN, _HEAD, _FOOT = 900.0, 24.0, 34.0, 20.0


def drive_figure(
    scene: Scene, trace: Trace, name: str, robustness: Floats | None, title: str, at: int | None
) -> str:
    """An SVG document.

    The path of agent `name` is green where `robustness` (T,) is large, yellow at 0 and red below;
    the sample `at` is marked. Meters are scaled to the width of the figure; y is up. A key at the
    foot has the colors and a scale bar.
    """
    agents = [_while_there(a) for a in trace.agents.values() if np.isfinite(a.x).any()]
    roads = [road for road in scene.roads if road.derived] or list(scene.roads)
    x = np.concatenate([[0.0], *(np.array(r.x) for r in roads), *(a.x for a in agents)])
    y = np.concatenate([[0.0], *(np.array(r.y) for r in roads), *(a.y for a in agents)])
    if roads or agents:
        x, y = x[1:], y[1:]
    left, top = float(np.nanmin(x)), float(np.nanmax(y))
    wide, high = float(np.nanmax(x)) - left, top - float(np.nanmin(y))
    scale = (_SIZE - 2 * _MARGIN) / max(wide, high, 1.0)

    def place(px: Floats, py: Floats) -> Floats:
        columns = (_MARGIN + (px - left) * scale, _HEAD + _MARGIN + (top - py) * scale)
        return np.stack(columns, axis=-1)

    height = _HEAD + 2 * _MARGIN + high * scale + _FOOT
    parts = [f'<rect width="{_SIZE:.0f}" height="{height:.0f}" fill="{FIGURE_COLORS.ground}"/>']
    parts += drawn_roads(scene, roads, place, scale)
    parts += (_footprint(object_, place, scale) for object_ in scene.objects)
    judged = name if robustness is not None and any(a.name == name for a in agents) else ""
    parts += _paths(agents, judged, robustness, place, scale)
    marked = trace.agents.get(name)
    if marked is not None and at is not None:
        parts.append(_mark(place(marked.x, marked.y)[at], marked, at))
    parts.append(_text(title))
    if roads or agents:
        names = [agent.name for agent in agents if agent.name != judged]
        shown = Shown(judged, bool(names), marked is not None and at is not None)
        parts.append(figure_key(shown, scale, (_MARGIN, _SIZE - _MARGIN), height - 10.0))
    body = "\n".join(parts)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_SIZE:.0f}" height="{height:.0f}"'
        f' viewBox="0 0 {_SIZE:.0f} {height:.0f}">\n{body}\n</svg>\n'
    )


def _paths(
    agents: Sequence[AgentTrace],
    judged: str,
    robustness: Floats | None,
    place: Callable[[Floats, Floats], Floats],
    scale: float,
) -> Iterator[str]:
    """The path of the agent that is `judged` above all others."""
    for agent in sorted(agents, key=lambda agent: agent.name == judged):
        line = place(agent.x, agent.y)
        if robustness is not None and agent.name == judged:
            yield from _colored(line, robustness, max(0.35 * agent.width * scale, 2.0))
        else:
            yield _polyline(line, OTHER, 1.5)


def _while_there(agent: AgentTrace) -> AgentTrace:
    """Without the places to which it is recorded after it has left."""
    left = agent.has_left
    if not left.any() or left.all():
        return agent
    return replace(agent, x=np.where(left, np.nan, agent.x), y=np.where(left, np.nan, agent.y))


def _footprint(actor: SceneActor, place: Callable[[Floats, Floats], Floats], scale: float) -> str:
    x, y = place(np.array(actor.x), np.array(actor.y)).tolist()
    long, wide = actor.length * scale, actor.width * scale
    title = f"<title>{escape(actor.name, quote=False)}</title>"
    color = object_color(actor.category)
    if actor.category in GREENERY:
        crown = f'cx="{x:.1f}" cy="{y:.1f}" r="{max(long, wide) / 2:.1f}"'
        return f'<circle {crown} fill="{color}">{title}</circle>'
    turn = f"translate({x:.1f} {y:.1f}) rotate({-np.degrees(actor.heading):.1f})"
    return (
        f'<rect x="{-long / 2:.1f}" y="{-wide / 2:.1f}" width="{long:.1f}" height="{wide:.1f}"'
        f' transform="{turn}" fill="{color}">{title}</rect>'
    )


def _text(content: str) -> str:
    return (
        f'<text x="{_MARGIN:.0f}" y="{_HEAD - 8:.0f}" fill="{FIGURE_COLORS.ink}" font-size="15"'
        f' font-family="Helvetica, Arial, sans-serif">{escape(content, quote=False)}</text>'
    )


def _polyline(line: Floats, color: str, width: float) -> str:
    return _joined(_points(line[np.isfinite(line).all(axis=1)]), color, width)


def _joined(points: Sequence[str], color: str, width: float) -> str:
    return (
        f'<polyline points="{" ".join(points)}" fill="none" stroke="{color}"'
        f' stroke-width="{width:.1f}" stroke-linejoin="round"/>'
    )


def _points(line: Floats) -> list[str]:
    return ("%.1f,%.1f " * len(line) % tuple(line.ravel().tolist())).split()


def _colored(line: Floats, robustness: Floats, width: float) -> Iterator[str]:
    """Runs of samples of one color."""
    is_there = np.isfinite(line).all(axis=1)
    points, shares = _points(line[is_there]), color_shares(robustness[is_there])
    edges = np.flatnonzero(np.diff(shares)) + 1
    begins = [0, *edges.tolist()]
    for first, end in zip(begins, [*begins[1:], len(shares)], strict=True):
        color = robustness_color(float(shares[first]))
        yield _joined(points[first : end + 1], color, width)


def _mark(point: Floats, agent: AgentTrace, at: int) -> str:
    x, y = point.tolist()
    label = escape(f"{agent.name} at {float(agent.time[at]):.1f} s", quote=False)
    return (
        f'<circle cx="{x:.1f}" cy="{y:.1f}" r="9" fill="none" stroke="{FIGURE_COLORS.ink}"'
        ' stroke-width="2">'
        f"<title>{label}</title></circle>"
    )
