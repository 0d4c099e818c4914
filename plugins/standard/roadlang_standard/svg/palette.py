"""Colors of a drawing: calm ground, gray road, strong colors only for what must be noticed."""

from __future__ import annotations

GROUND = "#f4f2ec"
GROUND_EDGE = "#d9d5c9"
CASING = "#3f454c"
SURFACE = "#757b83"
MARKING = "#fbfaf5"
FAINT_MARKING = "#b9bcbf"
CURB = "#dedace"
LANES = {
    "bus": "#7d7470",
    "bike": "#93716c",
    "parking": "#868b92",
    "shoulder": "#6c7279",
    "sidewalk": "#b9b6ac",
    "median": "#aeb0a4",
    "grass": "#a9bd8c",
}
RAISED = "#b9b6ac"
SURFACES = {
    "wet": "#56626f",
    "snow": "#dfe4ea",
    "ice": "#b7d3e2",
    "gravel": "#a3937c",
    "turf": "#a9bd8c",
}
"""What roads are covered by; asphalt is `SURFACE`."""
GHOST_FILL = "#9db4cf"
GHOST_LINE = "#3f6ea5"
CONTEXT = "#d3d0c6"
INK = "#23272b"
MUTED_INK = "#6c7177"
SATISFIED = "#2b8a3e"
UNKNOWN = "#8b8f94"
VIOLATIONS = ("#d6336c", "#e8590c", "#9c36b5", "#c92a2a", "#a07000")
AGENTS = ("#1c7ed6", "#e8590c", "#2f9e44", "#9c36b5", "#c2255c", "#0c8599")
LEAVES = ("#7fb069", "#5d9550", "#497d40")
TRUNK = "#38612f"
ROOF_LIGHT = "#cda58b"
ROOF_DARK = "#b98b6e"
ROOF_LINE = "#7d5a45"
OBJECT = "#c9a227"
LIGHTS = {"red": "#e03131", "yellow": "#fcc419", "green": "#37b24d"}
TIGHT = "#b35c00"

FONT = "Helvetica, Arial, 'Liberation Sans', sans-serif"


def lane_color(kind: str, *, raised: bool) -> str:
    """The color of a kind of lane; of one that a plugin brings by whether it is raised."""
    return LANES.get(kind, RAISED if raised else SURFACE)


def violation_color(index: int) -> str:
    """The color of the `index`-th violated constraint of a scene."""
    return VIOLATIONS[index % len(VIOLATIONS)]


def agent_color(index: int) -> str:
    """The color of the `index`-th agent group of a scene."""
    return AGENTS[index % len(AGENTS)]
