"""A folder of rendered scenes to train on: scene i depends on the seed and i alone."""

from __future__ import annotations

from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from training.rendering.aerial import render_aerial
from training.rendering.extras import extras_of
from training.rendering.sunlit.scene import render_sunlit

_PLANS = {
    "suburb": 0.22,
    "city": 0.17,
    "grid": 0.12,
    "motorway": 0.09,
    "boulevard": 0.07,
    "village": 0.10,
    "rural": 0.09,
    "curve": 0.06,
    "roundabout": 0.05,
    "bend": 0.03,
}
_RESOLUTIONS = ((0.8, 1.25, 0.55), (0.4, 0.7, 0.25), (0.25, 0.38, 0.20))
SIZE, SUNLIT_SIZE = 640, 512
_SUNLIT = 0.7
"""Share of the scenes in which single trees stand under one sun."""
_HIDDEN, _PLAIN = 0.2, 0.1
"""Shares of the scenes whose roads lie under crowns and shadows more than they would by chance,
and that show nothing but roads on open ground."""
_WITH_EXTRAS = 0.85


@dataclass(frozen=True)
class Scene:
    """A rendered picture (h, w, 3) and its roads: points in pixels (n, 2) and widths in pixels."""

    image: np.ndarray
    lines: tuple[np.ndarray, ...]
    widths: tuple[float, ...]


def render(folder: Path, seed: int, count: int, jobs: int) -> None:
    """Fill `folder` with scenes 0..count-1; those already there are kept."""
    folder.mkdir(parents=True, exist_ok=True)
    missing = [i for i in range(count) if not _path(folder, i).exists()]
    with ProcessPoolExecutor(jobs) as workers:
        for _ in workers.map(_render_one, [folder] * len(missing), [seed] * len(missing), missing):
            pass


def _path(folder: Path, index: int) -> Path:
    return folder / f"scene-{index:05d}.npz"


def _render_one(folder: Path, seed: int, index: int) -> None:
    rng = np.random.default_rng([seed, index])
    plan = str(rng.choice(list(_PLANS), p=list(_PLANS.values())))
    low, high, _ = _RESOLUTIONS[rng.choice(3, p=[share for *_, share in _RESOLUTIONS])]
    scene, resolution = int(rng.integers(2**31)), float(rng.uniform(low, high))
    if rng.random() < _SUNLIT:
        drawn = render_sunlit(plan, scene, SUNLIT_SIZE, resolution)
    else:
        hidden = float(rng.uniform(0.1, 0.4)) if rng.random() < _HIDDEN else None
        plain = bool(rng.random() < _PLAIN)
        extras = extras_of(rng) if not plain and rng.random() < _WITH_EXTRAS else None
        drawn = render_aerial(plan, scene, SIZE, resolution, hidden, plain=plain, extras=extras)
    roads = drawn.truth.roads
    _, code = cv2.imencode(".png", drawn.image)
    partial = _path(folder, index).with_suffix(".part.npz")
    np.savez(
        partial,
        image=code,
        points=np.vstack([road.points for road in roads]).astype(np.float32),
        counts=np.array([len(road.points) for road in roads]),
        widths=np.array([road.width for road in roads], np.float32),
    )
    partial.rename(_path(folder, index))


def load(path: Path) -> Scene:
    """One scene back from its file."""
    stored = np.load(path)
    image = cv2.imdecode(stored["image"], cv2.IMREAD_COLOR)
    lines = np.split(stored["points"], np.cumsum(stored["counts"])[:-1])
    return Scene(image, tuple(lines), tuple(map(float, stored["widths"])))


def scenes(folder: Path) -> list[Path]:
    """The scenes that are ready, in order."""
    return sorted(path for path in folder.glob("scene-*.npz") if ".part" not in path.name)
