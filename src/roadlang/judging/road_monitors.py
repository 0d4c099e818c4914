"""The robustness that a monitor plugin gives to roads, and why it rejects one."""

from __future__ import annotations

from functools import partial

import numpy as np

from ..evaluate.candidates import CandidateBatch
from ..evaluate.evaluation import build
from ..geometry.arrays import Floats
from ..ir.values import PassCall
from ..plugins.guard import wrong_result
from ..plugins.results import robustness_values
from ..world.signals import axes_of


def monitor_rho(call: PassCall, candidates: CandidateBatch) -> Floats:
    """(V,) robustness that a monitor plugin gives; of networks, on their worst road."""
    worst = np.full(candidates.count, np.inf)
    for axis in axes_of(call, candidates):
        built = build(call, candidates, resolve=partial(axis.resolve, candidates=candidates))
        with built.guarded:
            result = built.kind.robustness()
        rho = robustness_values(result, built.entry, call.span).reshape(-1)
        if rho.shape[0] not in (1, candidates.count):
            fault = f"gave a robustness of shape {rho.shape}, not ({candidates.count},)"
            raise wrong_result(built.entry, call.span, fault)
        worst = np.minimum(worst, rho)
    return worst


def monitor_blame(name: str, call: PassCall, candidates: CandidateBatch) -> str | None:
    """Why a monitor rejects the first candidate, in the words of its plugin, if it has any."""
    for axis in axes_of(call, candidates):
        built = build(call, candidates, resolve=partial(axis.resolve, candidates=candidates))
        with built.guarded:
            rejected = np.ravel(built.kind.robustness())[0] < 0.0
            reason = built.kind.reason() if rejected else None
        if not isinstance(reason, str | None):
            raise wrong_result(built.entry, call.span, f"gave the reason {reason!r}, not a text")
        if reason:
            return f"`{name}`: {reason}"
    return None
