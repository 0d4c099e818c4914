"""A kind with its options evaluated, and the plugin to name when it fails."""

from __future__ import annotations

import dataclasses
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..ir.values import PassCall
from ..plugins.guard import plugin_guard
from ..plugins.kinds import Kind
from ..plugins.registry import KindEntry


@dataclass(frozen=True)
class KindInstance:
    """A kind with concrete options, where it comes from, and the call that asked for it."""

    kind: Any
    entry: KindEntry
    call: PassCall

    @property
    def guarded(self) -> AbstractContextManager[None]:
        """What the kind raises inside is reported with the name of its plugin."""
        return plugin_guard(self.entry, self.call.span, self.call.option_spans)


def row_of_kind(kind: Any, row: int) -> Any:
    """The kind of one candidate of a batch: its columns become plain numbers and words."""
    picked = {
        field.name: _at_row(getattr(kind, field.name), row) for field in dataclasses.fields(kind)
    }
    return dataclasses.replace(kind, **picked)


def _at_row(value: Any, row: int) -> Any:
    """The value of one candidate, also of columns inside lists, points, maps and calls."""
    if isinstance(value, np.ndarray) and value.ndim == 2:
        return scalar(value[row : row + 1] if value.shape[0] > 1 else value)
    if isinstance(value, tuple):
        return tuple(_at_row(item, row) for item in value)
    if isinstance(value, dict):
        return {key: _at_row(item, row) for key, item in value.items()}
    return row_of_kind(value, row) if isinstance(value, Kind) else value


def scalar(value: Any) -> Any:
    """A value of a single candidate without its column: plain Python numbers and strings."""
    if isinstance(value, np.ndarray):
        return value.reshape(-1)[0].item() if value.dtype != object else value.reshape(-1)[0]
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, tuple | list):
        return tuple(scalar(item) for item in value)
    if isinstance(value, dict):
        return {key: scalar(item) for key, item in value.items()}
    return value
