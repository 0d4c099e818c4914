"""A network from a picture, corrected by hand: its options `drawn`, `dismissed`, `confirmed`."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from ...diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import evaluate
from ...evaluate.kind_instance import scalar
from ...geometry import Floats, GeometryError
from ...geometry.networks.corrections import Corrections, corrected
from ...ir.picture import Extraction, Picture
from ...ir.scenario import ScenarioNetwork
from ...ir.values import Value

OPTIONS = ("drawn", "dismissed", "confirmed")


def corrected_extraction(
    network: ScenarioNetwork, found: Extraction, picture: Picture, candidates: CandidateBatch
) -> Extraction:
    """What was found, with the roads that the options draw, dismiss and confirm.

    The mask is lost where roads change. Warns (RL434) of points that are on no road; raises
    DiagnosticError RL472 for points that are no curve.
    """
    options = network.options
    what = f"{network.name}.drawn"
    if not any(name in options for name in OPTIONS):
        return found
    drawn, dismissed = (_lines(options.get(name), picture, candidates) for name in OPTIONS[:2])
    confirmed = options.get("confirmed")
    points = np.zeros((0, 2)) if confirmed is None else _points(confirmed, picture, candidates)
    try:
        _check_drawn(drawn, picture)
        after = corrected(found.network, Corrections(drawn, dismissed, points))
    except GeometryError as error:
        raise DiagnosticError(
            diagnose(Code.IMPOSSIBLE_GEOMETRY, network.span, what=what, reason=str(error))
        ) from error
    missed = tuple(_missed(network, at, picture) for at in after.missed)
    lengths = [edge.length for edge in after.network.edges]
    sure = [edge.confidence for edge in after.network.edges]
    return replace(
        found,
        network=after.network,
        confidence=float(np.average(sure, weights=lengths)) if sure else 0.0,
        mask=found.mask if not (drawn or dismissed) else None,
        width_errors=(),
        confidences=(),
        warnings=(*found.warnings, *missed),
    )


def _check_drawn(lines: tuple[Floats, ...], picture: Picture) -> None:
    """A drawn road may lead out of the picture, but no farther than the picture is long.

    Raises GeometryError.
    """
    size = np.array(picture.file_size)
    for line in lines:
        points = picture.to_file(picture.to_pixels(line))
        outside = np.maximum(-points, points - size).max(axis=1)
        x, y = points[outside.argmax()]
        if outside.max() > size.max():
            width, height = size
            raise GeometryError(
                f"({x:.7g}px, {y:.7g}px) is far outside of the picture of {width} x {height} px"
            )


def _missed(network: ScenarioNetwork, at: tuple[float, float], picture: Picture) -> Diagnostic:
    x, y = picture.to_file(picture.to_pixels(np.array(at)))
    place = f"({x:.4g}px, {y:.4g}px)"
    return diagnose(Code.NO_ROAD_TO_CORRECT, network.span, name=network.name, place=place)


def _lines(value: Value | None, picture: Picture, candidates: CandidateBatch) -> tuple[Floats, ...]:
    if value is None:
        return ()
    return tuple(_world(line, picture) for line in evaluate(value, candidates))


def _points(value: Value, picture: Picture, candidates: CandidateBatch) -> Floats:
    return _world(evaluate(value, candidates), picture)


def _world(points: Iterable[tuple[Any, Any]], picture: Picture) -> Floats:
    pixels = [(float(scalar(x)), float(scalar(y))) for x, y in points]
    return picture.to_world(picture.from_file(np.array(pixels)))
