"""What looks at the clock: the stop rule by which what is found depends on the machine, and how
long rounds take, by which it does not.
"""

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


def now() -> float:
    """Seconds since some moment."""
    return time.monotonic()
