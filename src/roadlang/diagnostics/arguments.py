"""Arguments that a program hands over, checked where it does: not deep in what they are for.

All raise `TypeError` for what is of another type and `ValueError` for what makes no sense, with the
name of the argument.
"""

from __future__ import annotations

import operator
import os
from collections.abc import Iterable, Mapping, Sequence
from numbers import Real
from pathlib import Path
from typing import Any


def whole_number(
    name: str, value: Any, *, least: int | None = None, most: int | None = None
) -> int:
    """An integer of Python or numpy from `least` to `most`; True and False are none."""
    try:
        number = operator.index(value)
    except TypeError:
        number = None
    if number is None or isinstance(value, bool):
        raise wrong_type(name, "an integer", value) from None
    if least is not None and number < least:
        raise ValueError(f"`{name}` must be at least {least}, not {number}")
    if most is not None and number > most:
        raise ValueError(f"`{name}` must be at most {most}, not {number}")
    return number


def number(name: str, value: Any) -> float:
    """A number of Python or numpy; True and False are none."""
    if not isinstance(value, Real) or isinstance(value, bool):
        raise wrong_type(name, "a number", value)
    return float(value)


def text(name: str, value: Any) -> str:
    """A string."""
    if not isinstance(value, str):
        raise wrong_type(name, "text", value)
    return value


def text_or_none(name: str, value: Any) -> str | None:
    """A string, or None where nothing is given."""
    return None if value is None else text(name, value)


def texts(name: str, value: Any) -> tuple[str, ...]:
    """One string, or a sequence of them."""
    if isinstance(value, str):
        return (value,)
    if not isinstance(value, Sequence) or not all(isinstance(item, str) for item in value):
        raise wrong_type(name, "text or a list of texts", value)
    return tuple(value)


def path(name: str, value: Any) -> Path:
    """The path of a file or folder, as text or as `pathlib` has it."""
    found = value if isinstance(value, str) else None
    if isinstance(value, os.PathLike):
        found = os.fspath(value)
    if not isinstance(found, str):
        raise wrong_type(name, "a path, as text or a `pathlib.Path`", value)
    return Path(found)


def file_to_write(name: str, value: Any) -> Path:
    """The path of a file that can be made: it has a name."""
    found = path(name, value)
    if not found.name:
        raise ValueError(f"`{name}` must name a file, not {str(value)!r}")
    return found


def function(name: str, value: Any) -> Any:
    """Something that can be called, or None."""
    if value is not None and not callable(value):
        raise wrong_type(name, "a function", value)
    return value


def mapping(name: str, value: Any, keys: Iterable[str] | None = None) -> Mapping[str, Any]:
    """A map whose keys are texts, or a table of pandas. With `keys`, those that are looked up, its
    own are looked at where one of these is missing."""
    if not (hasattr(value, "keys") and hasattr(value, "items")):
        raise wrong_type(name, "a map, such as a dict", value)
    found: Mapping[str, Any] = value
    if keys is None or not all(key in found for key in keys):
        for key in found:
            if not isinstance(key, str):
                raise wrong_type(name, "a map whose keys are texts", key)
    return found


def wrong_type(name: str, expected: str, value: Any) -> TypeError:
    """For the caller to raise: what is expected of an argument, and what it is instead."""
    return TypeError(f"`{name}` must be {expected}, not {shown(value)}")


def shown(value: Any) -> str:
    """A short value as Python writes it, of others their type."""
    written = repr(value)
    return written if len(written) <= 40 else f"something of type `{type(value).__name__}`"
