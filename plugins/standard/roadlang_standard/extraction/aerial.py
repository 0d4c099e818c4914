"""From a photo to its road network: evidence at several scales, tracing, linking, drawing."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from .clean import contract, drop_crumbs, join, prune
from .drafting import Draft, draft, usual_width_of
from .evidence import Evidence, Layer, Predictor, evidence, road_net
from .found import FoundNetwork
from .graph import trace
from .hysteresis import hysteresis
from .masks import without_specks
from .skeleton import skeleton
from .tones import Image


@dataclass(frozen=True)
class Request:
    """What the user says, in pixels: all of it optional."""

    threshold: float | None = None
    width: float | None = None
    through: tuple[tuple[float, float], ...] = ()
    leave_out: tuple[tuple[tuple[float, float], ...], ...] = ()
    min_length: float | None = None
    metres_per_pixel: float | None = None


def roads_of_photo(
    image: Image, request: Request = Request(), predict: Predictor | None = None
) -> FoundNetwork:
    """The road network of a photo (h, w, 3)."""
    seen = evidence(image, predict or road_net())
    return roads_of_evidence(seen, request)


def roads_of_evidence(seen: Evidence, request: Request) -> FoundNetwork:
    """Trace what the net saw."""
    score = cv2.GaussianBlur((seen.surface + seen.line) / 2, (0, 0), 1.0)
    high = request.threshold if request.threshold is not None else 0.5
    mask = without_specks(hysteresis(score, high, 0.55 * high), 40)
    graph = trace(skeleton(mask))
    usual = usual_width_of(graph, mask)
    contract(graph, 1.2 * usual)
    prune(graph, request.min_length or max(14.0, 2.2 * usual), mask.shape)
    join(graph)
    drop_crumbs(graph, 40.0)
    manner = Draft(usual, fixed_width=request.width)
    return draft(graph, seen.surface, score, manner, "aerial")
