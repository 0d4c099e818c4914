"""`--print-after PASS`: what passes make of each scene, in a few lines."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import click

from ..diagnostics import Code, DiagnosticError, diagnose, did_you_mean
from ..ir.values import PassCall

if TYPE_CHECKING:
    from ..ir.scenario import Scenario

ALL = "all"


class PassPrinter:
    """Prints to stderr what passes make. `name` is a kind (`sine`), a place (`bent/perturb 1`), or
    `all`. Raises `DiagnosticError` RL930 where the scenario has no such pass."""

    def __init__(self, scenario: Scenario, name: str) -> None:
        self._name = name
        known = list(dict.fromkeys(text for call in _passes(scenario) for text in _names(call)))
        if name != ALL and name not in known:
            hints = did_you_mean(name, known) or (f"the passes are {', '.join(known)} and all",)
            raise DiagnosticError(diagnose(Code.UNKNOWN_CHOICE, what="pass", name=name, help=hints))

    def __call__(self, scene: int, call: PassCall, result: Any) -> None:
        """Print one pass of one scene."""
        if self._name == ALL or self._name in _names(call):
            kind = f"{call.verb} with {_names(call)[0]}"
            line = f"scene {scene}, after {call.place} ({kind}): {_described(result)}"
            click.echo(line, err=True)


def _passes(scenario: Scenario) -> Iterator[PassCall]:
    for image in scenario.images:
        yield from image.passes
    for network in scenario.networks:
        yield from network.passes
    for road in scenario.roads:
        yield from road.passes


def _names(call: PassCall) -> tuple[str, str]:
    return call.kind.rpartition(".")[2], call.place


def _described(result: Any) -> str:
    from ..geometry import Curve
    from ..ir.batch import RoadBatch
    from ..ir.picture import Extraction, Picture

    if isinstance(result, RoadBatch):
        return _of_road(result)
    if isinstance(result, Picture):
        mean = "" if result.pixels is None else f", mean gray {float(result.pixels.mean()):.1f}"
        return f"{result.width} x {result.height} px{mean}"
    if isinstance(result, Extraction):
        edges = result.network.edges
        length = sum(edge.curve.length for edge in edges)
        objects = f", {len(result.objects)} objects" if result.objects else ""
        sure = f"confidence {result.confidence:.2f}"
        return f"{len(edges)} roads, {length:.1f} m in all, {sure}{objects}"
    if isinstance(result, Curve):
        return f"{result.length:.2f} m{', closed' if result.closed else ''}"
    return type(result).__name__


def _of_road(road: Any) -> str:
    import numpy as np

    length, width = float(road.length[0, 0]), np.atleast_2d(road.width)[0]
    displaced = float(np.abs(road.displacement[0]).max())
    sharpest = float(np.abs(road.curvature[0]).max())
    return (
        f"`{road.name}`, {length:.2f} m at {len(road.stations)} stations, displaced by up to"
        f" {displaced:.3g} m, curvature up to {sharpest:.3g}/m, width {width.min():.3g} to"
        f" {width.max():.3g} m"
    )
