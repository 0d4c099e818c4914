"""Scores of road center lines: Mnih's relaxed F1, Wiedemann's quality, connectivity like APLS."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

from roadlang_standard.extraction.masks.skeleton import skeleton

COLUMNS = ("P@3", "R@3", "F1@3", "F1@5", "complete", "correct", "quality", "path", "s/Mpx")
_BUFFER, _PAIRS = 5.0, 24


@dataclass(frozen=True)
class Case:
    """A picture and the pixels (h, w) of its true center lines; radii are times `scale`."""

    image: np.ndarray
    line: np.ndarray
    scale: float = 1.0

    @classmethod
    def of_mask(cls, image: np.ndarray, mask: np.ndarray, scale: float) -> Case:
        """The truth is the skeleton of a road mask (255 = road)."""
        return cls(image, skeleton(mask > 127), scale)

    @classmethod
    def of_lines(cls, image: np.ndarray, lines: list[np.ndarray]) -> Case:
        """The truth is polylines in pixels."""
        return cls(image, raster(lines, image.shape[:2]))


def raster(lines: list[np.ndarray], shape: tuple[int, ...]) -> np.ndarray:
    """One pixel wide (h, w) bool; a line drawn twice counts once."""
    canvas = np.zeros(shape[:2], np.uint8)
    for line in lines:
        fixed = np.round(np.clip(line, -1e4, 1e4) * 16).astype(np.int32)
        cv2.polylines(canvas, [fixed], False, 1, 1, cv2.LINE_8, 4)
    return canvas > 0


def score(case: Case, lines: list[np.ndarray]) -> dict[str, float]:
    """All columns but the time."""
    found = raster(lines, case.line.shape)
    to_true, to_found = _distance(case.line), _distance(found)
    scores: dict[str, float] = {}
    for radius in (3, 5):
        p = _share(found, to_true <= radius * case.scale)
        r = _share(case.line, to_found <= radius * case.scale)
        scores |= {f"P@{radius}": p, f"R@{radius}": r, f"F1@{radius}": _harmonic(p, r)}
    buffer = _BUFFER * case.scale
    hit, extra = _split(found, to_true <= buffer)
    matched, missed = _split(case.line, to_found <= buffer)
    scores["correct"] = hit / max(1, hit + extra)
    scores["complete"] = matched / max(1, matched + missed)
    scores["quality"] = min(hit, matched) / max(1, min(hit, matched) + extra + missed)
    there = _paths(case.line, found, 2 * buffer)
    back = _paths(found, case.line, 2 * buffer)
    return {**scores, "path": _harmonic(there, back)}


def relaxed_f1(case: Case, lines: list[np.ndarray], radius: float = 3.0) -> float:
    """F1 at one radius alone: what a threshold is chosen by."""
    found = raster(lines, case.line.shape)
    p = _share(found, _distance(case.line) <= radius * case.scale)
    return _harmonic(p, _share(case.line, _distance(found) <= radius * case.scale))


def _distance(line: np.ndarray) -> np.ndarray:
    return ndimage.distance_transform_edt(~line) if line.any() else np.full(line.shape, 1e6)


def _share(line: np.ndarray, near: np.ndarray) -> float:
    return float(near[line].mean()) if line.any() else 0.0


def _harmonic(a: float, b: float) -> float:
    return 2 * a * b / (a + b) if a + b else 0.0


def _split(line: np.ndarray, near: np.ndarray) -> tuple[int, int]:
    return int((line & near).sum()), int((line & ~near).sum())


def _paths(a: np.ndarray, b: np.ndarray, tolerance: float) -> float:
    """How well shortest ways of `a` are kept in `b`: mean of 1 - |difference| / length."""
    if not a.any() or not b.any():
        return 0.0
    wide = cv2.dilate(b.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    rng = np.random.default_rng(0)
    pixels = np.argwhere(a)
    starts = rng.choice(len(pixels), min(_PAIRS, len(pixels)), replace=False)
    goals = rng.choice(len(pixels), min(200, len(pixels)), replace=False)
    true = dijkstra(_graph(a), directed=False, indices=starts)[:, goals]
    snapped = [_snap(wide, pixels[chosen], tolerance) for chosen in (starts, goals)]
    far = dijkstra(_graph(wide), directed=False, indices=np.maximum(snapped[0], 0))
    found = far[:, np.maximum(snapped[1], 0)]
    found[snapped[0] < 0, :] = np.inf
    found[:, snapped[1] < 0] = np.inf
    counted = np.isfinite(true) & (true > 4 * tolerance)
    if not counted.any():
        return 0.0
    error = np.minimum(1, np.abs(true[counted] - found[counted]) / true[counted])
    return float(1 - error.mean())


def _graph(line: np.ndarray) -> coo_matrix:
    index = np.full(np.array(line.shape) + 2, -1)
    pixels = np.argwhere(line)
    index[1:-1, 1:-1][line] = np.arange(len(pixels))
    rows, columns, lengths = [], [], []
    for dy, dx in ((0, 1), (1, 0), (1, 1), (1, -1)):
        other = index[pixels[:, 0] + 1 + dy, pixels[:, 1] + 1 + dx]
        kept = np.flatnonzero(other >= 0)
        rows.append(kept)
        columns.append(other[kept])
        lengths.append(np.full(len(kept), np.hypot(dy, dx)))
    parts = (np.concatenate(lengths), (np.concatenate(rows), np.concatenate(columns)))
    return coo_matrix(parts, shape=(len(pixels),) * 2).tocsr()


def _snap(line: np.ndarray, pixels: np.ndarray, tolerance: float) -> np.ndarray:
    """Index of the nearest pixel of the line, -1 where it is too far."""
    distance, (rows, columns) = ndimage.distance_transform_edt(~line, return_indices=True)
    index = np.full(line.shape, -1)
    index[line] = np.arange(int(line.sum()))
    y, x = pixels.T
    return np.where(distance[y, x] <= tolerance, index[rows[y, x], columns[y, x]], -1)
