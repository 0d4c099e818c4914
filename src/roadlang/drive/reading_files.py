"""The readings of sensors as files beside the trace."""

from __future__ import annotations

import io
from collections.abc import Iterable
from typing import Any

import numpy as np

from ..ir.readings import SensorRecord


def reading_files(records: Iterable[SensorRecord]) -> dict[str, bytes]:
    """By file ending, `ego.front.npz`: the times of measurement and of arrival, and the arrays."""
    files = {}
    for record in records:
        buffer = io.BytesIO()
        arrays: dict[str, Any] = {"time": record.time, "arrival": record.arrival, **record.arrays}
        np.savez_compressed(buffer, **arrays)
        ending = f"{record.agent}.{record.sensor}.npz".replace("/", "-")
        files[ending] = buffer.getvalue()
    return files
