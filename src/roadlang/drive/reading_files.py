"""The readings of sensors as files beside the trace."""

from __future__ import annotations

import io
from collections.abc import Iterable
from typing import Any

import numpy as np

from ..ir.readings import ARRAYS_ENDING, SensorRecord


def reading_files(records: Iterable[SensorRecord]) -> dict[str, bytes]:
    """By file ending, `ego.front.npz`: the times of measurement and of arrival, and the arrays;
    and what the kinds of the sensors write of them."""
    files = {}
    for record in records:
        buffer = io.BytesIO()
        arrays: dict[str, Any] = {"time": record.time, "arrival": record.arrival, **record.arrays}
        np.savez_compressed(buffer, **arrays)
        stem = f"{record.agent}.{record.sensor}".replace("/", "-")
        files[f"{stem}.{ARRAYS_ENDING}"] = buffer.getvalue()
        files |= {f"{stem}.{ending}": content for ending, content in record.files.items()}
    return files
