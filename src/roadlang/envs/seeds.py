"""Seeds of resets: gymnasium takes those of Python alone."""

from __future__ import annotations

from typing import Any

from ..diagnostics.arguments import whole_number


def seed_of(seed: Any) -> int | None:
    """An integer of Python or numpy as one of Python; None stays. Raises TypeError and ValueError
    for what is no seed."""
    return None if seed is None else whole_number("seed", seed, least=0)
