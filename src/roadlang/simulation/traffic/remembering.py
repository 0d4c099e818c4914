"""What is remembered of the way to a junction: who goes without asking, who waits, who stopped."""

from __future__ import annotations

import numpy as np

from .approaches import OVER_LINE, SIGN_DISTANCE, SIGN_SPEED, braking_to_stop
from .crowd import Crowd
from .grants import FIRST, NEVER

INTERVAL = 0.1
"""Seconds from one look at the junctions to the next."""
WAITS_WITHIN, WAITS_SLOWER = 15.0, 1.0
"""An agent within this many meters of a line that is slower than this, in m/s, waits there."""
UNSTOPPABLE = 4.0
"""m/s^2: who would have to brake harder before a line, and does not obey, will cross it."""


def remember(crowd: Crowd) -> None:
    """Forget what is over; take back what signals forbid; note who goes without asking, and who
    waits."""
    grants, near = crowd.grants, crowd.near
    grants.forget(near.is_behind | ~crowd.present[:, None])
    obeys, speed, to_line = crowd.obeys[:, None], crowd.speed[:, None], near.to_line
    ahead = ~near.is_behind & crowd.is_moving[:, None]
    grants.order[near.must_stop & obeys] = NEVER
    grants.order[crowd.held & ~obeys & (to_line >= 0.0) & (speed < SIGN_SPEED)] = NEVER
    runs = ~obeys & (to_line >= 0.0) & (braking_to_stop(speed, to_line) > UNSTOPPABLE)
    grants.order[ahead & runs] = FIRST
    inside = ahead & ~crowd.held & (to_line < -OVER_LINE)
    grants.order[inside] = np.where(obeys, crowd.time, FIRST)[inside.nonzero()[0], 0]
    close = ahead & (to_line > -OVER_LINE) & (to_line < WAITS_WITHIN) & (speed < WAITS_SLOWER)
    grants.waiting[:] = np.where(close, grants.waiting + INTERVAL, 0.0)
    stops = close & (to_line < SIGN_DISTANCE) & (speed < SIGN_SPEED) & ~grants.has_stopped
    grants.has_stopped |= stops
    grants.arrival[stops & crowd.entrants.in_turn] = crowd.time
