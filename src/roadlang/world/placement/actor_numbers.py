"""Numbers in options of agents and objects, for many copies at once."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...evaluate.copies import CopyBatch
from ...evaluate.evaluation import evaluate
from ...evaluate.option_bounds import check_number, common_option
from ...geometry.arrays import Floats
from ...ir.scenario import ScenarioActor
from ...ir.values import ConstantValue
from .copies import element_of


def number_of_copies(actor: ScenarioActor, name: str, copies: CopyBatch, default: float) -> Floats:
    """(R,) an option, `default` where it is not written. Raises RL473 for a number that is drawn or
    computed and out of bounds."""
    value = actor.options.get(name)
    if value is None:
        return np.full(copies.count, default)
    found = column(evaluate(value, copies, element_of(actor)), copies)
    if not isinstance(value, ConstantValue):
        # The options of objects are among those of agents.
        check_number(common_option("agent", name), found, actor.name, actor.span_of(name))
    return found


def column(value: Any, copies: CopyBatch) -> Floats:
    """A value of the copies as numbers (R,)."""
    return np.broadcast_to(np.asarray(value, dtype=np.float64).reshape(-1), (copies.count,))
