"""A network of which places were moved by hand: its options `moved_at`, `moved_by`."""

from __future__ import annotations

from ...diagnostics import Code, DiagnosticError, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import evaluate
from ...evaluate.kind_instance import scalar
from ...geometry import GeometryError, RoadNetwork
from ...geometry.networks.warp import Warp
from ...ir.scenario import ScenarioNetwork
from ...ir.values import Value


def moved_network(
    network: ScenarioNetwork, found: RoadNetwork, candidates: CandidateBatch
) -> RoadNetwork:
    """The network as it was found, with its places moved. Raises RL472 where it would fold."""
    options = network.options
    at, by = options.get("moved_at"), options.get("moved_by")
    if at is None and by is None:
        return found
    radius = options.get("moved_radius")
    try:
        warp = Warp.of(
            _points(at, candidates),
            _points(by, candidates),
            None if radius is None else float(scalar(evaluate(radius, candidates))),
        )
        return warp.network(found)
    except GeometryError as error:
        what = f"{network.name}.moved_by"
        raise DiagnosticError(
            diagnose(Code.IMPOSSIBLE_GEOMETRY, network.span, what=what, reason=str(error))
        ) from error


def _points(value: Value | None, candidates: CandidateBatch) -> list[tuple[float, float]]:
    if value is None:
        return []
    return [(float(scalar(x)), float(scalar(y))) for x, y in evaluate(value, candidates)]
