"""Roads: drawn, read or selected of a network, then perturbed, in many variants."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..diagnostics import DiagnosticError, diagnose
from ..geometry import Curve, Frame, Path, WidthProfile
from ..geometry import Road as RoadShape
from ..ir.batch import RoadBatch
from ..ir.scenario import FileSource, Network, Road
from ..ir.values import PassCall
from .blame import wrong_result
from .building import build
from .evaluation import evaluate, scalar
from .networks import edge_batch, network_root
from .perturbation import displaced, perturbed
from .plan import Plan
from .reading import read_by_name, read_with
from .selection import selected
from .stations import stations_of, still
from .variants import Variants

Floats = NDArray[np.float64]
USUAL_WIDTH = 7.0
USUAL_LANES = 2


@dataclass(frozen=True, eq=False)
class RoadRoot:
    """A road before any `perturb`. `path`: its way through a network, where it comes of one."""

    id: str
    frame: Frame
    width: WidthProfile | None = None
    lanes: int | None = None
    path: Path | None = None
    network: Network | None = None


def road_batch(name: str, variants: Variants) -> RoadBatch:
    """A road in all variants, after all its passes."""
    road = variants.plan.roads[name]

    def make() -> RoadBatch:
        origin = variants.plan.source_of(road)
        if isinstance(origin, Road):
            batch = road_batch(origin.name, variants)
        else:
            batch = _carried(road, variants)
        batch = replace(batch, name=name, width=_width(road, batch, variants))
        for call in road.passes:
            if call.verb == "perturb":
                batch = perturbed(batch, call, variants)
        return batch

    return variants.once(("road", name), make)


def road_root(name: str, variants: Variants) -> RoadRoot:
    """What a road is before anything was perturbed."""
    plan = variants.plan
    bottom = list(_roads(plan.roads[name], plan))[-1]
    if plan.is_varying(bottom.name):
        return variants.once(("road root", bottom.name), lambda: _root(bottom, variants))
    return plan.once(("road root", bottom.name), lambda: _root(bottom, plan.fixed))


def lanes_of(name: str, variants: Variants) -> int:
    """How many lanes a road of a single candidate has."""
    plan = variants.plan
    for link in _roads(plan.roads[name], plan):
        given = dict(link.options).get("lanes")
        if given is not None:
            return max(1, round(float(scalar(evaluate(given, variants)))))
    return road_root(name, variants).lanes or USUAL_LANES


def _roads(road: Road, plan: Plan) -> Iterator[Road]:
    return (link for link in plan.chain(road) if isinstance(link, Road))


def _width(road: Road, before: RoadBatch, variants: Variants) -> Floats:
    given = dict(road.options).get("width")
    if given is None:
        return before.width
    value = np.atleast_2d(np.asarray(evaluate(given, variants), float))
    if not (value > 0).all() or not np.isfinite(value).all():
        raise DiagnosticError(
            diagnose("RL415", road.span, name=road.name, width=f"{float(value.min()):g}m")
        )
    return value


def _carried(road: Road, variants: Variants) -> RoadBatch:
    """A root road, or the way through a network that has been perturbed before."""
    root = road_root(road.name, variants)
    stations = root.frame.stations
    width = np.full((1, 1), USUAL_WIDTH) if root.width is None else root.width.at(stations)[None, :]
    batch = still(road.name, root.id, root.frame, width)
    network = root.network
    if network is None or root.path is None or not _is_bent(network, variants.plan):
        return batch
    return displaced(batch, _along_path(root, network, variants))


def _is_bent(network: Network, plan: Plan) -> bool:
    return any(call.verb == "perturb" for link in plan.chain(network) for call in link.passes)


def _along_path(root: RoadRoot, network: Network, variants: Variants) -> Floats:
    """(V, S) displacements of the edges under a path, at the stations of the path."""
    assert root.path is not None
    travelled = root.frame.stations * (root.path.length / root.frame.curve.length)
    ends = np.cumsum([step.length for step in root.path.steps])
    moves = np.zeros((1, len(travelled)))
    before = 0.0
    for index, step in enumerate(root.path.steps):
        last = index == len(root.path.steps) - 1
        here = (travelled >= before) & (travelled < ends[index] if not last else True)
        batch = edge_batch(network, step.edge, variants)
        way = 1.0 if step.stop >= step.start else -1.0
        at = step.start + way * (travelled[here] - before)
        part = way * _interpolated(batch, at)
        if part.shape[0] > moves.shape[0]:
            moves = np.repeat(moves, part.shape[0], axis=0)
        moves[:, here] = part
        before = float(ends[index])
    return moves


def _interpolated(batch: RoadBatch, at: Floats) -> Floats:
    """(V, n) displacements of an edge at arc lengths between its stations."""
    stations, moves = batch.stations, batch.displacement
    if batch.period is not None:
        stations = np.append(stations, batch.period)
        moves = np.concatenate([moves, moves[:, :1]], axis=1)
    right = np.clip(np.searchsorted(stations, at), 1, len(stations) - 1)
    gap = stations[right] - stations[right - 1]
    share = np.clip((at - stations[right - 1]) / gap, 0.0, 1.0)
    return moves[:, right - 1] * (1.0 - share) + moves[:, right] * share


def _root(road: Road, variants: Variants) -> RoadRoot:
    plan = variants.plan
    if road.source is None:
        curve = _drawn(road, variants)
        return RoadRoot(road.name, Frame.of(curve, stations_of(curve)))
    if isinstance(road.source, FileSource):
        return _from_file(road, road.source, variants)
    network = plan.source_of(road)
    assert isinstance(network, Network)
    root = network_root(network, variants)
    path = selected(road, root, variants)
    steps = path.steps
    if len(steps) == 1 and steps[0].start == 0.0 and steps[0].length >= path.length:
        edge = root.network.edge(steps[0].edge)
        if steps[0].stop >= edge.length:
            id = f"{root.name}/{edge.id}"
            return RoadRoot(id, root.frame(edge.id), edge.width, None, path, network)
    return _way(root.name, path, network, variants)


def _way(name: str, path: Path, network: Network, variants: Variants) -> RoadRoot:
    """The same way through the same network is one root, whichever road statement names it."""
    steps = "+".join(f"{step.edge}:{step.start:.6g}:{step.stop:.6g}" for step in path.steps)
    keeper = variants if variants.plan.is_varying(network.name) else variants.plan

    def frame() -> Frame:
        return Frame.of(path.curve, stations_of(path.curve))

    id = f"{name}/{steps}"
    return RoadRoot(id, keeper.once(("way", id), frame), path.width, None, path, network)


def _drawn(road: Road, variants: Variants) -> Curve:
    calls = [call for call in road.passes if call.verb == "draw"]
    if not calls:
        raise DiagnosticError(diagnose("RL416", road.span, name=road.name))
    closed = _is_closed(road, variants)
    built = build(calls[0], variants, single=True)
    with built.blamed:
        curve = built.kind.draw(closed)
    if not isinstance(curve, Curve):
        fault = f"gave a {type(curve).__name__}, not a Curve"
        raise wrong_result(built.entry, calls[0].span, fault)
    return _checked(curve, road, calls[0])


def _from_file(road: Road, source: FileSource, variants: Variants) -> RoadRoot:
    plan = variants.plan
    reading = [call for call in road.passes if call.verb == "read"]
    if reading:
        found = read_with(reading[0], source, "road", plan, road.span)
    else:
        found, _ = read_by_name(source, "road", plan, road.span)
    curve = found.curve if isinstance(found, RoadShape) else found
    width = found.width if isinstance(found, RoadShape) else None
    lanes = found.lanes if isinstance(found, RoadShape) else None
    closed = dict(road.options).get("closed")
    if closed is not None and bool(scalar(evaluate(closed, variants))) != curve.closed:
        curve = Curve.through(curve.points, not curve.closed)
        width = None if width is None else WidthProfile.even(width.widths, curve.length)
    curve = _checked(curve, road, reading[0] if reading else None)
    return RoadRoot(road.name, Frame.of(curve, stations_of(curve)), width, lanes)


def _is_closed(road: Road, variants: Variants) -> bool:
    given = dict(road.options).get("closed")
    return given is not None and bool(scalar(evaluate(given, variants)))


def _checked(curve: Any, road: Road, call: PassCall | None) -> Curve:
    span = call.span if call is not None else road.span
    usable = isinstance(curve, Curve) and np.isfinite(curve.points).all() and 0 < curve.length < 1e7
    if not usable:
        raise DiagnosticError(diagnose("RL417", span, name=road.name))
    checked: Curve = curve
    return checked
