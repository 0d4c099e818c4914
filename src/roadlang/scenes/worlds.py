"""The light, weather and friction of scenes."""

from __future__ import annotations

from functools import cache
from typing import Any

from ..evaluate.evaluation import evaluate
from ..evaluate.option_bounds import check_number
from ..ir.times_of_day import TIMES_OF_DAY
from ..ir.values import ConstantValue, Value
from ..plugins.common_options import schema_of_common
from ..plugins.options import OptionSchema
from ..plugins.world_options import WorldOptions
from .scene_rows import SceneRows


def world_columns(rows: SceneRows) -> dict[str, list[Any]]:
    """Of each option of `world`, its value in each scene; parts of the day as seconds. Raises RL473
    for a number that is drawn or computed and out of bounds."""
    options = rows.scenario.source.world
    found = {name: _column(name, value, rows) for name, value in options.items()}
    if "time_of_day" in found:
        found["time_of_day"] = [TIMES_OF_DAY.get(time, time) for time in found["time_of_day"]]
    return found


def _column(name: str, value: Value, rows: SceneRows) -> list[Any]:
    found = evaluate(value, rows.candidates)
    if not isinstance(value, ConstantValue):
        draws = rows.scenario.dependencies.draws(value)
        check_number(_option(name), found, "world", draws[0].call.span if draws else None)
    return rows.plain(found)


@cache
def _option(name: str) -> OptionSchema:
    options = schema_of_common(WorldOptions)
    return next(option for option in options if option.name == name)
