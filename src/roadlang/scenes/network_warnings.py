"""What could not be built of networks and joined roads as they are drawn or mapped, as warnings."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ..diagnostics import Code, Diagnostic, diagnose
from ..evaluate.candidates import CandidateBatch
from ..geometry.networks.junction_model import NO_JUNCTION, JunctionPlan, Problem
from ..ir.scenario import ScenarioNetwork, ScenarioRoad
from ..world.networks.networks import network_root
from ..world.roads.roads import road_root
from .origin_warnings import origin_warnings

_MOST = 6


def network_warnings(
    networks: Sequence[ScenarioNetwork], candidates: CandidateBatch
) -> tuple[Diagnostic, ...]:
    """What was said of their sources, and one for each junction or pair of roads; networks with
    the same junctions are one. Roads that pass above others matter where agents drive on level
    ground. One for each network with another origin on Earth than the first."""
    found: list[Diagnostic] = []
    seen: list[JunctionPlan] = []
    simulator = _with_level_ground(candidates)
    for network in networks:
        root = network_root(network, candidates)
        found += [warning for warning in root.warnings if warning not in found]
        plan = root.junctions.plans[network.name]
        if plan not in seen:
            seen.append(plan)
            found += _of_plan(network, plan)
            above = [problem for problem in plan.problems if problem.kind == "level"]
            if above and simulator:
                found.append(_on_levels(network, above, simulator))
    return (*found, *origin_warnings(networks, candidates))


def joined_road_warnings(
    roads: Iterable[ScenarioRoad], candidates: CandidateBatch
) -> tuple[Diagnostic, ...]:
    """The warnings about roads that are joined end to end."""
    joined = (road for road in roads if "then" in road.options)
    return tuple(said for road in joined for said in road_root(road.name, candidates).warnings)


def _of_plan(network: ScenarioNetwork, plan: JunctionPlan) -> Iterator[Diagnostic]:
    for junction in sorted({problem.junction for problem in plan.problems}):
        problems = [problem for problem in plan.problems if problem.junction == junction]
        turns = [p for p in problems if p.kind in ("refused", "sweep")]
        if turns:
            yield _turns(network, junction, turns, problems)
        for problem in problems:
            if problem.kind == "overlap":
                yield _overlap(network, problem)
            elif problem.kind == "vanished":
                yield _inside(network, problem)
        misses = [p for p in problems if p.kind == "outside"]
        if misses:
            yield _misfit(network, junction, misses)


def _turns(
    network: ScenarioNetwork, junction: int, turns: list[Problem], problems: list[Problem]
) -> Diagnostic:
    pairs = dict.fromkeys(f"{p.edges[0]} to {p.edges[1]}" for p in turns)
    stuck = [str(p.edges[0]) for p in problems if p.kind == "stuck"]
    help_ = [f"no lane leads on from {_roads(dict.fromkeys(stuck))}"] if stuck else []
    return diagnose(
        Code.TURNS_NOT_CONNECTED,
        network.span,
        junction=junction,
        network=network.name,
        turns=f"the turn{'s' if len(pairs) > 1 else ''} from road {_listed(pairs)}",
        help=help_,
    )


def _overlap(network: ScenarioNetwork, problem: Problem) -> Diagnostic:
    first, second = problem.edges
    beyond = f"beyond junction {problem.junction}"
    return diagnose(
        Code.ROADS_OVERLAP,
        network.span,
        first=first,
        second=second,
        network=network.name,
        length=f"{problem.amount:.1f}m",
        place="where no junction is" if problem.junction == NO_JUNCTION else beyond,
    )


def _with_level_ground(candidates: CandidateBatch) -> str:
    """The simulator that the scene file names, if agents drive in it and it knows no levels."""
    scenario = candidates.scenario
    call = scenario.source.simulate
    if call is None or not scenario.source.agents:
        return ""
    entry, kind = scenario.kind(call)
    return "" if kind.knows_levels else entry.recorded  # type: ignore[attr-defined]


def _on_levels(network: ScenarioNetwork, above: list[Problem], simulator: str) -> Diagnostic:
    pairs = (f"{problem.edges[0]} and {problem.edges[1]}" for problem in above)
    return diagnose(
        Code.ROADS_ON_LEVELS,
        network.span,
        network=network.name,
        simulator=simulator,
        roads=_listed(list(pairs)),
        help=[
            "vehicles on one road brake for those on the other, and collide with them",
            "write `simulate with builtin`, or keep a part of the map with `within: box(...)`",
        ],
    )


def _inside(network: ScenarioNetwork, problem: Problem) -> Diagnostic:
    return diagnose(
        Code.ROAD_INSIDE_JUNCTION,
        network.span,
        road=problem.edges[0],
        network=network.name,
        length=f"{problem.amount:.1f}m",
        junction=problem.junction,
    )


def _misfit(network: ScenarioNetwork, junction: int, misses: list[Problem]) -> Diagnostic:
    edges = dict.fromkeys(str(edge) for problem in misses for edge in problem.edges)
    return diagnose(
        Code.JUNCTION_DOES_NOT_FIT,
        network.span,
        junction=junction,
        network=network.name,
        roads=_roads(edges),
        amount=f"{max(problem.amount for problem in misses):.2f}m",
    )


def _roads(ids: Iterable[str]) -> str:
    shown = list(ids)
    return f"road{'s' if len(shown) > 1 else ''} {_listed(shown)}"


def _listed(items: Iterable[str]) -> str:
    shown = list(items)
    more = f" and {len(shown) - _MOST} more" if len(shown) > _MOST else ""
    return ", ".join(shown[:_MOST]) + more
