"""The one stop rule that looks at the clock: what is found until then depends on the machine."""

from __future__ import annotations

import time
from collections.abc import Callable


def deadline(seconds: float | None) -> Callable[[], bool]:
    """A function that returns whether this many seconds have passed; always False without a
    number."""
    if seconds is None:
        return lambda: False
    end = time.monotonic() + seconds
    return lambda: time.monotonic() >= end
