"""Who goes first at the junctions of a network, as the signals and signs of its map say."""

from __future__ import annotations

from collections.abc import Sequence

from ...geometry import MapControl, signal_phases
from ...geometry.networks.junction_model import Junction, JunctionPlan
from ...ir.scene_junctions import SignalPhase
from ...plugins.kinds import RightOfWay

_GREEN, _YELLOW, _ALL_RED = 20.0, 3.0, 2.0
"""Seconds: maps do not say how long; the defaults of `control with signals`."""


def mapped_rules(controls: Sequence[MapControl], plan: JunctionPlan) -> dict[int, RightOfWay]:
    """By the ids of junctions that a map says something of."""
    if not controls:
        return {}
    found = {junction.id: _rule(junction, controls) for junction in plan.junctions}
    return {id: rule for id, rule in found.items() if rule is not None}


def _rule(junction: Junction, controls: Sequence[MapControl]) -> RightOfWay | None:
    """Signals before signs; stop signs on all sides make an all-way stop."""
    arms = {(arm.edge, arm.end) for arm in junction.arms}
    here = [control for control in controls if not arms.isdisjoint(control.arms)]
    if junction.kind != "junction" or not here or not junction.connections:
        return None
    rules = {control.rule for control in here}
    if "signals" in rules:
        phases = tuple(
            SignalPhase(group, _GREEN, _YELLOW, _ALL_RED) for group in signal_phases(junction)
        )
        return RightOfWay("signals", (), phases)
    minor = {arm for control in here for arm in control.arms if arm in arms}
    edges = tuple(sorted({edge for edge, _ in minor}))
    leaving = {(item.source.edge, item.source.end) for item in junction.connections}
    if leaving <= minor:
        return RightOfWay("all_way_stop") if rules == {"stop"} else None
    return RightOfWay("stop" if "stop" in rules else "yield", edges)
