"""A network of which only a part is kept: its option `within`."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from ...diagnostics import Code, DiagnosticError, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import build, evaluate
from ...evaluate.kind_instance import KindInstance
from ...geometry import Booleans, Floats, GeometryError
from ...geometry.networks.clipping import clipped
from ...ir.picture import Extraction, Picture
from ...ir.scenario import ScenarioNetwork
from ...ir.values import PassCall
from ...plugins.guard import wrong_result


def clipped_network(
    network: ScenarioNetwork, found: Extraction, scale: float | None, candidates: CandidateBatch
) -> Extraction:
    """The roads, objects and pixels of what was found that lie `within`; everything without it.

    `scale`: meters per pixel of the mask. Raises RL472 for roads that cannot be cut.
    """
    option = network.options.get("within")
    if option is None:
        return found
    call: Any = evaluate(option, candidates)
    assert isinstance(call, PassCall)
    region = build(call, candidates, single=True)

    def contains(points: Floats) -> Booleans:
        return _contained(region, points)

    try:
        kept = clipped(found.network, contains)
    except GeometryError as error:
        what = f"{network.name}.within"
        raise DiagnosticError(
            diagnose(Code.IMPOSSIBLE_GEOMETRY, call.span, what=what, reason=str(error))
        ) from error
    middles = np.array([(each.x, each.y) for each in found.objects]).reshape(-1, 2)
    inside = contains(middles) if len(middles) else ()
    objects = tuple(each for each, kept in zip(found.objects, inside, strict=True) if kept)
    mask = found.mask
    if mask is not None and scale is not None:
        rows, columns = np.nonzero(mask)
        pixels = np.column_stack([columns, rows]).astype(np.float64)
        points = Picture(mask, scale).to_world(pixels)  # type: ignore[arg-type]
        mask = np.zeros_like(mask)
        inside = contains(points)
        mask[rows[inside], columns[inside]] = True
    return replace(found, network=kept, objects=objects, mask=mask, width_errors=(), confidences=())


def _contained(region: KindInstance, points: Floats) -> Booleans:
    with region.guarded:
        inside = np.asarray(region.kind.contains(points.copy()))
    if inside.shape != (len(points),) or inside.dtype != np.bool_:
        shape = f"{inside.dtype} of shape {inside.shape}, not bool of shape {(len(points),)}"
        raise wrong_result(region.entry, region.call.span, f"gave {shape}")
    return inside
