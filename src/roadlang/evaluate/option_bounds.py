"""Whether numbers that are drawn or computed keep the bounds of their options.

Constants are checked with the file, and so are draws as far as it is known what they can be. What
nothing bounds, such as `normal(...)`, is checked as it is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, Span, diagnose
from ..ir.values import PassCall
from ..plugins.common_options import common_options
from ..plugins.options import OptionSchema, schema_of


def options_of(kind: type, verb: str) -> Mapping[str, OptionSchema]:
    """The options of a kind and those of its verb, by name."""
    return _options_of(kind, verb)


@cache
def common_option(verb: str, name: str) -> OptionSchema:
    """An option that all kinds of a verb have."""
    return next(option for option in common_options(verb) if option.name == name)


@cache
def _options_of(kind: Any, verb: str) -> Mapping[str, OptionSchema]:
    return {option.name: option for option in (*common_options(verb), *schema_of(kind))}


def check_bounds(option: OptionSchema, value: Any, call: PassCall) -> None:
    """A number (or a column of them) in an option of a call. Raises RL473."""
    span = call.option_spans.get(option.name, call.span)
    check_number(option, value, call.kind.rpartition(".")[2], span)


def check_number(option: OptionSchema, value: Any, owner: str, span: Span | None) -> None:
    """The same in an option of an `owner`. What is no number has no bounds. Raises RL473."""
    limits = option.constraints
    if isinstance(value, float | int) and not math.isnan(value) and limits.allow(value):
        return
    if not isinstance(value, float | int | np.ndarray) or isinstance(value, bool):
        return
    numbers = np.asarray(value)
    if numbers.dtype.kind not in "fiu":
        return
    wrong = np.isnan(numbers)
    for bound, outside in (
        (limits.least, np.less),
        (limits.most, np.greater),
        (limits.above, np.less_equal),
        (limits.below, np.greater_equal),
    ):
        if bound is not None:
            wrong = wrong | outside(numbers, bound)
    if wrong.any():
        found = float(numbers[wrong].reshape(-1)[0])
        raise DiagnosticError(
            diagnose(
                Code.DRAWN_VALUE_OUT_OF_BOUNDS,
                span,
                option=option.name,
                kind=owner,
                value=f"{found:g}",
            )
        )
