"""What the extractor is compared with: the paper's plain chain, the best threshold, ribbons."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import cv2
import numpy as np

from roadlang_standard.extraction.graphs.graph_cleanup import prune
from roadlang_standard.extraction.graphs.tracing import trace
from roadlang_standard.extraction.masks.mask_parts import without_specks
from roadlang_standard.extraction.masks.skeleton import skeleton
from roadlang_standard.extraction.photos.classical import roads_by_ribbons

Lines = list[np.ndarray]


def paper_chain(image: np.ndarray) -> Lines:
    """Contrast, sharpen, blur, Otsu, and the contours themselves as the curves."""
    gray = cv2.equalizeHist(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY))
    soft = cv2.GaussianBlur(gray, (0, 0), 2)
    sharp = cv2.GaussianBlur(cv2.addWeighted(gray, 1.5, soft, -0.5, 0), (5, 5), 0)
    _, mask = cv2.threshold(sharp, 0, 255, cv2.THRESH_BINARY | cv2.THRESH_OTSU)
    outlines, _ = cv2.findContours(mask, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    return [line[:, 0].astype(float) for line in outlines if len(line) > 50]


def best_threshold(image: np.ndarray, score: Callable[[Lines], float]) -> Lines:
    """The threshold and polarity of 26 that the truth itself likes best: a hand's upper bound."""
    gray = cv2.GaussianBlur(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY), (0, 0), 1.5)
    levels = np.quantile(gray, np.linspace(0.05, 0.98, 13))
    return max(_thresholded(gray, levels), key=score)


def _thresholded(gray: np.ndarray, levels: np.ndarray) -> Iterable[Lines]:
    for level in levels:
        for surface in (gray > level, gray <= level):
            graph = trace(skeleton(without_specks(surface, 200)))
            prune(graph, 20)
            yield [line.points for line in graph.lines]


def classical(image: np.ndarray) -> Lines:
    """The classical path: ribbons brighter or darker than both their sides."""
    return [road.points for road in roads_by_ribbons(image).roads]
