"""Which controllers the engine has, and what is sent to it of a call."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from roadlang.api import Call

IN_ENGINE = frozenset(
    {"pure_pursuit", "stanley", "lane_follow", "car_follow", "brake", "crossing", "manual"}
)

EMBEDDED_ONLY = {"traffic": "right of way"}
"""Controllers that drive in the embedded engine alone, and what they need of it."""


def plain_name(kind: str) -> str:
    """`pure_pursuit` of `roadlang.pure_pursuit` or `standard.pure_pursuit`; a stranger's name
    stays whole."""
    plugin, _, name = kind.rpartition(".")
    return name if plugin in ("", "roadlang", "standard") else kind


def option_values(call: Call) -> dict[str, Any]:
    """The options that are numbers or words; an engine knows nothing else."""
    out: dict[str, Any] = {}
    for key, value in call.options.items():
        if isinstance(value, str) or (isinstance(value, (int, float)) and math.isfinite(value)):
            out[key] = value if isinstance(value, (str, bool)) else float(value)
    return out
