"""SIGTERM ends the process as SIGTERM, also while plugin code runs that catches everything."""

from __future__ import annotations

import itertools
import os
import signal
from collections.abc import Callable
from types import FrameType


class Terminated(BaseException):
    """The process received SIGTERM. Nothing but the command line may catch it for good."""


_numbers = itertools.count(1)  # counted in one step: a signal may interrupt its own handler
_received = False


def end_on_sigterm(is_idle: Callable[[], bool] = lambda: False) -> None:
    """Raise `Terminated` in the main thread on SIGTERM, so that half-written files are removed and
    programs that were started end. A process that `is_idle` just ends."""

    def receive(number: int, frame: FrameType | None) -> None:
        if is_idle():
            os._exit(128 + number)
        _receive(number, frame)

    signal.signal(signal.SIGTERM, receive)


def stop_noticing_sigterm() -> None:
    """The process is ending: from here on SIGTERM ends it at once."""
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


def raise_if_terminated() -> None:
    """Raise `Terminated` again if other code has caught it."""
    if _received:
        raise Terminated


def _receive(number: int, frame: FrameType | None) -> None:
    global _received
    nth = next(_numbers)
    _received = True
    if nth == 1:
        raise Terminated
    # `timeout` sends the signal twice at once: the second must not interrupt the clean-up. Whoever
    # sends a third one wants the process gone.
    if nth > 2:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        os.kill(os.getpid(), signal.SIGTERM)
