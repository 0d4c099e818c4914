"""Colors of a drawing: calm ground, gray road, strong colors only for what must be noticed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from roadlang.api import FIGURE_COLORS

if TYPE_CHECKING:
    from roadlang.api import geometry

GROUND = FIGURE_COLORS.ground
GROUND_EDGE = "#d9d5c9"
CASING = "#3f454c"
SURFACE = FIGURE_COLORS.surface
MARKING = FIGURE_COLORS.marking
FAINT_MARKING = FIGURE_COLORS.faint_marking
CURB = FIGURE_COLORS.curb
RAISED = FIGURE_COLORS.raised
LANES = {
    "bus": "#7d7470",
    "bike": "#93716c",
    "parking": FIGURE_COLORS.beside,
    "shoulder": "#6c7279",
    "sidewalk": RAISED,
    "median": "#aeb0a4",
    "grass": "#a9bd8c",
}
GHOST_FILL = "#9db4cf"
GHOST_LINE = "#3f6ea5"
CONTEXT = "#d3d0c6"
INK = FIGURE_COLORS.ink
MUTED_INK = "#6c7177"
SATISFIED = "#2b8a3e"
UNKNOWN = "#8b8f94"
VIOLATIONS = ("#d6336c", "#e8590c", "#9c36b5", "#c92a2a", "#a07000")
AGENTS = ("#1c7ed6", "#e8590c", "#2f9e44", "#9c36b5", "#c2255c", "#0c8599")
LEAVES = ("#7fb069", FIGURE_COLORS.leaves, "#497d40")
TRUNK = "#38612f"
ROOF_LIGHT = "#cda58b"
ROOF_DARK = FIGURE_COLORS.roof
ROOF_LINE = "#7d5a45"
OBJECT = FIGURE_COLORS.thing
LIGHTS = {"red": "#e03131", "yellow": "#fcc419", "green": "#37b24d"}
TIGHT = "#b35c00"

FONT = "Helvetica, Arial, 'Liberation Sans', sans-serif"


def lane_color(lane: geometry.Lane) -> str:
    """The color of its kind; of one that a plugin brings as in figures of drives, which know no
    kinds."""
    return LANES.get(lane.kind) or FIGURE_COLORS.of_lane(drivable=lane.drivable, raised=lane.raised)


def violation_color(index: int) -> str:
    """The color of the `index`-th violated constraint of a scene."""
    return VIOLATIONS[index % len(VIOLATIONS)]


def agent_color(index: int) -> str:
    """The color of the `index`-th agent group of a scene."""
    return AGENTS[index % len(AGENTS)]
