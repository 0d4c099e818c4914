"""Which road of a network: `longest`, `any`, `route(p, q)`, `road(id)`."""

from __future__ import annotations

from typing import Any

from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import build, evaluate
from ...evaluate.kind_instance import scalar
from ...geometry import Path, Step
from ...ir.scenario import ScenarioRoad
from ...ir.values import PassCall
from ...plugins.guard import wrong_result
from ..networks.networks import NetworkRoot


def selected(road: ScenarioRoad, root: NetworkRoot, candidates: CandidateBatch) -> Path:
    """The path through the network. Raises RL472 if there is none."""
    option = road.options.get("select")
    choice: Any = "longest" if option is None else evaluate(option, candidates)
    if isinstance(choice, PassCall):
        return _called(choice, root, candidates)
    if scalar(choice) == "any":
        return _any(road, root, candidates)
    return root.network.longest()


def _called(call: PassCall, root: NetworkRoot, candidates: CandidateBatch) -> Path:
    built = build(call, candidates, single=True)
    with built.guarded:
        path = built.kind.select(root.network)
    if not isinstance(path, Path):
        fault = f"gave a {type(path).__name__}, not a Path of the network"
        raise wrong_result(built.entry, call.span, fault)
    return path


def _any(road: ScenarioRoad, root: NetworkRoot, candidates: CandidateBatch) -> Path:
    share = float(candidates.uniform(f"{road.name}/select")[0, 0])
    edge = root.edges[min(int(share * len(root.edges)), len(root.edges) - 1)]
    return Path(root.network, (Step(edge.id, 0.0, edge.length),))
