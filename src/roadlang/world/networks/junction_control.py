"""Who goes first at the junctions of a network, as its `control` passes say."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterable
from typing import get_args

from ...diagnostics import Code, DiagnosticError, Span, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import build, evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...evaluate.kind_instance import KindInstance, scalar
from ...geometry.networks.junction_model import Junction, JunctionPlan
from ...ir.scenario import ScenarioNetwork
from ...ir.scene_junctions import ControlRule
from ...ir.values import PassCall
from ...plugins.guard import wrong_result
from ...plugins.kinds import RightOfWay
from .mapped_control import mapped_rules
from .networks import network_root

_RULES = get_args(ControlRule)
FARTHEST = 30.0
"""Meters from a junction that a point may be that stands for it"""


def right_of_way_rules(
    network: ScenarioNetwork, candidates: CandidateBatch
) -> dict[int, RightOfWay]:
    """By the ids of junctions, of a single candidate: what the map says, unless a pass names the
    junction; the last one counts.

    What is drawn is drawn anew for each junction. Raises RL429 for a junction that is not there,
    RL411 and RL430 for a road that is not there, or not there.
    """
    root = network_root(network, candidates)
    plan = root.junctions.plans[network.name]
    edges = [edge.id for edge in root.edges]
    found = mapped_rules(root.network.controls, plan)
    for call in controls_of(network, candidates.scenario):
        junctions = _chosen(call, plan, candidates)
        for junction in junctions:
            built = build(call, candidates, junction.id, single=True)
            with built.guarded:
                rule = built.kind.right_of_way(junction)
            _check(rule, junction, built)
            found[junction.id] = rule
        _check_roads(call, junctions, edges, candidates)
    return found


def controls_of(network: ScenarioNetwork, scenario: IndexedScenario) -> list[PassCall]:
    """The `control` passes of a network; those of what it is made from come first."""
    chain = [link for link in scenario.chain(network) if hasattr(link, "passes")]
    return [call for link in reversed(chain) for call in link.passes if call.verb == "control"]


def _chosen(call: PassCall, plan: JunctionPlan, candidates: CandidateBatch) -> list[Junction]:
    """The junctions that a pass is about."""
    option, near = call.common.get("junctions"), call.common.get("near")
    if option is None and near is None:
        return [junction for junction in plan.junctions if junction.kind == "junction"]
    wanted = [] if option is None else _numbers(evaluate(option, candidates))
    known = {node: junction for junction in plan.junctions for node in junction.nodes}
    for id in wanted:
        if id not in known:
            raise _no_such_junction(id, plan, _place_of(call, "junctions", id))
    chosen = [known[id] for id in wanted]
    points = () if near is None else evaluate(near, candidates)
    chosen += [_nearest(scalar(point), plan, call.span) for point in points]
    return list({junction.id: junction for junction in chosen}.values())


def _nearest(point: tuple[float, float], plan: JunctionPlan, span: Span | None) -> Junction:
    """The junction whose middle is nearest to a point. Raises RL429 for one that is far away."""
    away = {j.id: math.dist(point, _middle(j)) - _radius(j) for j in plan.junctions}
    id = min(away, key=lambda id: (away[id], id), default=None)
    if id is None or away[id] > FARTHEST:
        x, y = point
        raise _unknown(f"near ({x:g}m, {y:g}m)", plan, span)
    return next(junction for junction in plan.junctions if junction.id == id)


def _middle(junction: Junction) -> tuple[float, float]:
    x, y = zip(*junction.area, strict=True)
    return sum(x) / len(x), sum(y) / len(y)


def _radius(junction: Junction) -> float:
    return max(math.dist(corner, _middle(junction)) for corner in junction.area)


def _numbers(value: object) -> list[int]:
    ids = scalar(value)
    return [round(id) for id in (ids if isinstance(ids, tuple) else (ids,))]


def _no_such_junction(id: int, plan: JunctionPlan, span: Span | None) -> DiagnosticError:
    ids = [junction.id for junction in plan.junctions]
    near = min(ids, key=lambda other: (abs(other - id), other), default=None)
    return _unknown(str(id), plan, span, () if near is None else (f"did you mean `{near}`?",))


def _unknown(
    what: str, plan: JunctionPlan, span: Span | None, more: tuple[str, ...] = ()
) -> DiagnosticError:
    places = [(junction.id, *_middle(junction)) for junction in plan.junctions[:12]]
    known = ", ".join(f"{id} at ({x:.0f}m, {y:.0f}m)" for id, x, y in places)
    help_ = (f"its junctions are {known or 'none: no roads meet'}", *more)
    return DiagnosticError(diagnose(Code.UNKNOWN_JUNCTION_ID, span, id=what, help=list(help_)))


def _check_roads(
    call: PassCall,
    junctions: Iterable[Junction],
    edges: Collection[int],
    candidates: CandidateBatch,
) -> None:
    """Whether the roads that a pass names are there, and end at one of its junctions."""
    option = call.options.get("roads")
    if option is None:
        return
    at_junctions = sorted({arm.edge for junction in junctions for arm in junction.arms})
    known = ", ".join(map(str, at_junctions[:20]))
    for id in _numbers(evaluate(option, candidates)):
        if id in at_junctions:
            continue
        help_ = f"the roads that end there are {known}"
        code = Code.ROAD_NOT_AT_JUNCTION if id in edges else Code.UNKNOWN_ROAD_ID
        raise DiagnosticError(diagnose(code, _place_of(call, "roads", id), id=id, help=help_))


def _place_of(call: PassCall, option: str, id: int) -> Span | None:
    """Where a pass names a junction or road, if it is written there; else the pass."""
    span = call.span
    found = span and re.search(rf"\b{option}\s*:[^:]*?\b({id})\b", span.text)
    if not span or not found:
        return span
    return span.source.span(span.start + found.start(1), span.start + found.end(1))


def _check(rule: object, junction: Junction, built: KindInstance) -> None:
    """Raises RL474 for what is no right of way at the junction."""
    span = built.call.span
    if not isinstance(rule, RightOfWay):
        raise wrong_result(built.entry, span, f"gave a {type(rule).__name__}, not a RightOfWay")
    if rule.rule not in _RULES:
        raise wrong_result(built.entry, span, f"gave the rule {rule.rule!r}, not one of {_RULES}")
    if not set(rule.minor) <= {arm.edge for arm in junction.arms}:
        raise wrong_result(built.entry, span, "gave minor roads that do not end at the junction")
    connections = {connection.id for connection in junction.connections}
    if not all(connections.issuperset(phase.connections) for phase in rule.phases):
        raise wrong_result(built.entry, span, "gave phases of connections that are not there")
    if (rule.rule == "signals") != bool(rule.phases) and junction.connections:
        raise wrong_result(built.entry, span, "gave phases and another rule than `signals`")
