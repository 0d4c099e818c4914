"""Values for params from Python and from `--set`, as texts of the language."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from ..diagnostics import Code, Diagnostic, DiagnosticError, Source, diagnose
from ..diagnostics.arguments import wrong_type

ParamValue = str | int | float | bool | Sequence[Any] | Source
"""Text as in the language (`"12m"`), a number without unit, true or false, or a list of such; a
`Source` is a text with its place."""


def param_sources(params: Mapping[str, ParamValue]) -> dict[str, Source]:
    """Each value as text of the language, with the name that diagnostics give its place: that of a
    `Source`, else the argument in Python.

    Raises `TypeError` for what is no such value, `ValueError` for numbers that are not finite.
    """
    return {
        name: value if isinstance(value, Source) else Source(f"argument {name}", _text(name, value))
        for name, value in params.items()
    }


def param_texts(params: Mapping[str, ParamValue]) -> dict[str, str]:
    """Each value as it would be written after `--set name=`.

    Raises `TypeError` for what is no such value, `ValueError` for numbers that are not finite.
    """
    return {name: _text(name, value) for name, value in params.items()}


def _text(name: str, value: Any) -> str:
    value = value.item() if hasattr(value, "item") and not getattr(value, "shape", ()) else value
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        if not math.isfinite(value):
            raise ValueError(f"the value of `{name}` is {value}")
        return repr(value)
    if isinstance(value, list | tuple):
        return "[" + ", ".join(_text(name, item) for item in value) + "]"
    raise wrong_type(name, 'a number, or a text as in the language, such as "12m"', value)


def parse_overrides(settings: Iterable[str]) -> dict[str, Source]:
    """`--set name=value` as a map, for `with_params`. Raises `DiagnosticError` RL924."""
    overrides: dict[str, Source] = {}
    faults: list[Diagnostic] = []
    for setting in settings:
        name, sign, value = (part.strip() for part in setting.partition("="))
        if not sign or not is_param_name(name) or not value:
            faults.append(
                diagnose(Code.MALFORMED_SET_OPTION, text=setting, help="write `--set reach=12m`")
            )
        overrides[name] = Source(f"--set {name}", value)
    if faults:
        raise DiagnosticError(*faults)
    return overrides


def is_param_name(text: str) -> bool:
    """`reach`, or `left.reach` of a file that is included as `left`."""
    return all(part.isidentifier() for part in text.split("."))
