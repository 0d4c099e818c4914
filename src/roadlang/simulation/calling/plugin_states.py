"""What controllers and sensors remember of agents, as their kinds begin it."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...diagnostics import Span
from ...plugins.guard import plugin_guard, wrong_result
from ...plugins.kinds import Controller, Sensor
from ...plugins.registry import KindEntry


def first_state(entry: KindEntry, span: Span | None, built: Controller | Sensor, count: int) -> Any:
    """The state of `count` agents at the start: an array (count, ...), or None. Raises RL470,
    RL474."""
    with plugin_guard(entry, span):
        state: Any = built.start(count)
    if state is not None and (not isinstance(state, np.ndarray) or state.shape[:1] != (count,)):
        raise wrong_result(entry, span, f"gave a state that is not an array of {count} rows")
    return state
