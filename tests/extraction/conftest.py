"""What the extraction tests share: no cache, and how a found line is compared with the true one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest


@pytest.fixture(autouse=True)
def no_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROADLANG_CACHE", "off")


@pytest.fixture
def distance_to() -> Any:
    """(n,) distances from points to a polyline."""

    def measure(points: Any, line: Any) -> Any:
        a, b = line[:-1], line[1:]
        step = b - a
        away = points[:, None] - a[None]
        share = np.clip((away * step).sum(-1) / np.maximum((step**2).sum(-1), 1e-12), 0, 1)
        return np.hypot(*np.moveaxis(away - share[..., None] * step, -1, 0)).min(axis=1)

    return measure
