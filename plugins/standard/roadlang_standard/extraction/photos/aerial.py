"""From a photo to its road network: evidence at several scales, tracing, linking, drawing."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang.geometry import Floats

from ..colors.tones import Image, Layer
from ..curves.smoothing import stations
from ..graphs.dead_end_extension import extend_dead_ends
from ..graphs.dead_ends import dead_ends
from ..graphs.evidence_pruning import drop_unworthy, prune_by_discounted_length
from ..graphs.graph import Graph
from ..graphs.graph_cleanup import contract, drop_loops, extend_to_border, join, prune
from ..graphs.linking import link
from ..graphs.tracing import trace
from ..masks.hysteresis import hysteresis
from ..masks.mask_parts import without_holes, without_specks
from ..masks.skeleton import skeleton
from ..networks.drafting import Draft, draft, typical_width_of
from ..networks.found_network import FoundNetwork
from .chroma import mean_chroma
from .divided_roads import with_medians
from .hints import leave_out, paint, paths_through
from .negative import exposures
from .photo_confidence import CHROMA
from .photo_evidence import Seen, look, typical_width
from .road_net import Net, road_net
from .scale import resized, view_scales

_LITTLE = 0.4
"""Where the roads are shorter than this share of the picture's side, fainter ones are sought."""
_RELAXED = (0.64, 0.36)
_CARRIED = 0.45
"""Share of the cutoffs that counts where a road may go on."""
_FAINTER, _FEW = 0.75, 12
"""Share of the cutoffs that is tried for the whole picture, and up to how many roads in it."""
_GAP = 6.0
"""Gaps of so many widths are bridged where the evidence lets them."""
_LONGER = 0.2
"""Exposures are compared by confidence times length to this power: in deep snow, the negative shows
all roads, and the photo itself two of them more clearly."""
_EDGE_LEVEL, _SURE, _EDGE_BLUR = 0.5, 0.8, 3.5
"""Evidence at the road's edge, in its middle where its width is measured, and the blur in pixels
that widens narrow roads: on renderings."""


@dataclass(frozen=True)
class Request:
    """What the user says, in pixels of the picture; all of it optional.

    `threshold` is the least evidence of a road, 0..1; `through` points (x, y) that roads pass
    through, in order along a road; `only_through` drops all other roads; `leave_out` boxes given by
    corners.
    """

    threshold: float | None = None
    width: float | None = None
    through: tuple[tuple[float, float], ...] = ()
    leave_out: tuple[tuple[tuple[float, float], ...], ...] = ()
    only_through: bool = False
    min_length: float | None = None
    meters_per_pixel: float | None = None

    def at(self, scale: float) -> Request:
        """The same in a picture `scale` times as large."""

        def moved(point: tuple[float, float]) -> tuple[float, float]:
            return ((point[0] + 0.5) * scale - 0.5, (point[1] + 0.5) * scale - 0.5)

        return replace(
            self,
            width=None if self.width is None else self.width * scale,
            min_length=None if self.min_length is None else self.min_length * scale,
            through=tuple(moved(p) for p in self.through),
            leave_out=tuple(tuple(moved(p) for p in box) for box in self.leave_out),
        )


@dataclass(frozen=True)
class Cutoffs:
    """Where evidence counts: strong starts a road, weak carries it on; lengths in pixels."""

    strong: float = 0.61
    weak: float = 0.365
    shortest_branch: float = 36.0
    """a dead end is worth more, in pixels of certain evidence, or is cut"""
    smallest_fragment: float = 60.0
    """a part that nothing joins is worth more, or is dropped"""
    floor: float = 0.35
    """evidence that is worth nothing"""
    link_distance: float = 50.0
    """dead ends this close may be linked"""
    link_cost: float = 1.14
    """of a link, for each of its pixels, at most"""

    def stricter(self, shown: float) -> Cutoffs:
        """For a picture of which the user has shown roads, the shortest of `shown` pixels."""
        branch, fragment = (
            min(2.5 * self.shortest_branch, 0.8 * shown),
            min(4 * self.smallest_fragment, 0.8 * shown),
        )
        return replace(self, shortest_branch=branch, smallest_fragment=fragment, floor=0.75)

    def relaxed(self, share: float) -> Cutoffs:
        """The same with all cutoffs on evidence lowered to a share."""
        strong, weak, floor = (share * x for x in (self.strong, self.weak, self.floor))
        return replace(
            self, strong=strong, weak=weak, floor=floor, link_cost=self.link_cost / share
        )


def roads_of_photo(
    image: Image, request: Request = Request(), net: Net | None = None
) -> FoundNetwork:
    """The road network of a photo (h, w, 3)."""
    net = net or road_net()
    scales = view_scales(image, request.meters_per_pixel)
    shown = []
    for exposure in exposures(image):
        views = [_view(exposure, scale, request, net) for scale in scales]
        # A smaller view has to show roads more clearly: the net misses narrow roads in it.
        shown.append(max(views, key=lambda found: found.confidence))
    best = max(shown, key=_worth)
    return replace(best, scores={**best.scores, CHROMA: round(mean_chroma(image), 2)})


def _worth(found: FoundNetwork) -> float:
    """By what one exposure is better than another one: how sure its roads are, and how long."""
    length = sum(road.length for road in found.roads)
    return float(found.confidence * length**_LONGER)


def _view(image: Image, scale: float, request: Request, net: Net) -> FoundNetwork:
    """What is found in a photo that is resized by the factor `scale`."""
    view, told = resized(image, scale), request.at(scale)
    seen = look(view, net)
    found = roads_of_evidence(seen, told)
    divided = with_medians(view, seen, found)
    if divided is not None:
        found = roads_of_evidence(divided, told)
    found = found if scale == 1 else found.scaled(1 / scale, image.shape[:2])
    return replace(found, scores={**found.scores, "scale": round(scale, 4)})


def roads_of_evidence(
    seen: Seen, request: Request = Request(), cutoffs: Cutoffs = Cutoffs()
) -> FoundNetwork:
    """Trace, tidy, link and draw what the net saw; the hints are those of `request`."""
    if request.threshold is not None:
        strong = request.threshold + 0.5 * (1 - request.threshold)
        cutoffs = replace(
            cutoffs, strong=strong, weak=request.threshold, floor=0.8 * request.threshold
        )
    if request.min_length is not None:
        cutoffs = replace(cutoffs, shortest_branch=request.min_length)
    surface = seen.surface.copy()
    score = cv2.GaussianBlur(seen.blend, (0, 0), 1.0)
    leave_out([surface, score], request.leave_out)
    paths = _paths_between(request.through, score, cutoffs.strong)
    if paths:
        if request.only_through:
            _forget_others([surface, score], score, paths, cutoffs.weak)
        for path in paths:
            paint(surface, score, path, request.width or max(5.0, typical_width(seen.surface)))
        cutoffs = cutoffs.stricter(min(float(stations(path)[-1]) for path in paths))
    graph, mask = _traced(score, cutoffs)
    if request.threshold is None and len(graph.lines) <= _FEW:
        fainter = _traced(score, cutoffs.relaxed(_FAINTER))
        if _is_tidier(fainter[0], graph, score):
            graph, mask = fainter
    for share in _RELAXED if request.threshold is None else ():
        if _length(graph) >= _LITTLE * max(score.shape):
            break
        graph, mask = _traced(score, cutoffs.relaxed(share))
    width = typical_width_of(graph, mask)
    extend_to_border(graph, (score.shape[0], score.shape[1]), 0.7 * width + 3)
    settings = Draft(
        width, fixed_width=request.width, level=_EDGE_LEVEL, sure=_SURE, blur=_EDGE_BLUR
    )
    return draft(graph, surface, score, settings, "aerial")


def _traced(score: Layer, cutoffs: Cutoffs) -> tuple[Graph, NDArray[np.bool_]]:
    """The tidy graph of the evidence, and the mask that it was traced from."""
    mask = without_specks(hysteresis(score, cutoffs.strong, cutoffs.weak), 40)
    graph = trace(skeleton(mask))
    width = typical_width_of(graph, mask)
    filled = without_holes(mask, width**2)
    if filled is not mask:
        mask, graph = filled, trace(skeleton(filled))
    _tidy(graph, score, width, cutoffs)
    return graph, mask


def _is_tidier(fainter: Graph, graph: Graph, score: Layer) -> bool:
    """Whether fainter evidence gives more road without more loose ends or junctions.

    Then it closes gaps and lengthens roads; drives and noise would add stubs.
    """
    ends, ends_fainter = (len(dead_ends(g, score.shape)) for g in (graph, fainter))
    meets, meets_fainter = (sum(n > 2 for n in g.degree().values()) for g in (graph, fainter))
    longer = _length(fainter) > _length(graph)
    return longer and ends_fainter <= ends and meets_fainter <= meets


def _length(graph: Graph) -> float:
    return sum(line.length for line in graph.lines)


def _paths_between(
    points: tuple[tuple[float, float], ...], score: Layer, strong: float
) -> list[Floats]:
    """The paths from each of the points to the next; of one point alone, to the nearest pixel that
    is surely road, or as surely as any."""
    if not points:
        return []
    polyline = np.array(points, float).reshape(-1, 2)
    road = score > min(strong, 0.9 * float(score.max()))
    if len(polyline) == 1 and road.any():
        seen = np.argwhere(road)[:, ::-1]
        polyline = np.vstack([polyline, seen[np.argmin(np.hypot(*(seen - polyline[0]).T))]])
    return paths_through(score, polyline)


def _forget_others(layers: list[Layer], score: Layer, paths: list[Floats], weak: float) -> None:
    """Clear all evidence that lies off the paths, in place."""
    inner = cv2.distanceTransform((score > weak).astype(np.uint8), cv2.DIST_L2, 5)
    x, y = np.clip(np.round(np.vstack(paths)).astype(int), 0, np.array(score.shape[::-1]) - 1).T
    width = max(5.0, 2.0 * float(np.median(inner[y, x])))
    near = np.zeros_like(score)
    for path in paths:
        paint(near, near, path, width)
    for layer in layers:
        layer[near <= 0] = 0


def _tidy(graph: Graph, score: np.ndarray, road_width: float, cutoffs: Cutoffs) -> None:
    shape = (score.shape[0], score.shape[1])
    contract(graph, 1.2 * road_width)
    prune(graph, 1.2 * road_width, shape)
    join(graph)
    drop_unworthy(graph, score, cutoffs.smallest_fragment / 3, cutoffs.floor)
    link_distance = max(cutoffs.link_distance, _GAP * road_width)
    faint = (_CARRIED * cutoffs.strong, _CARRIED * cutoffs.weak)
    extend_dead_ends(graph, score, faint, road_width, link_distance)
    link(graph, score, link_distance, cutoffs.link_cost, road_width)
    drop_loops(graph, 6 * road_width)
    prune_by_discounted_length(graph, score, cutoffs.shortest_branch, cutoffs.floor)
    drop_unworthy(graph, score, cutoffs.smallest_fragment, cutoffs.floor)
    contract(graph, 1.2 * road_width)
    drop_loops(graph, 6 * road_width)
