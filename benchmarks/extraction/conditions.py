"""How much of the score of clean renderings is left in snow, in infrared, blurred and so on.

    python -m benchmarks.extraction.conditions            # 16 scenes of 512 pixels
    python -m benchmarks.extraction.conditions --scenes 4 --seed 89000

For each condition: how many pictures `extract with auto` takes for photos, F1 at 3 m, its share
of that of the clean pictures, and path. No network was trained on these conditions.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable

import cv2
import numpy as np

from benchmarks.extraction.__main__ import _PLANS
from benchmarks.extraction.scores import Case, score
from roadlang_standard.extraction.colors.tones import Image, Layer
from roadlang_standard.extraction.paper.paper import roads_on_paper
from roadlang_standard.extraction.photos.aerial import Request
from roadlang_standard.extraction.photos.crosscheck import checked_roads
from roadlang_standard.extraction.photos.road_net import road_net
from roadlang_standard.extraction.picture_kinds.picture_kind import picture_kind
from training.rendering.aerial import render_aerial
from training.rendering.frame import Rendering

_SEED = 88_000


def snow(
    rendering: Rendering, seed: int, deep: float = 0.92, plowed: float = 1.0, patchy: float = 0.0
) -> Image:
    """The scene with snow that hides a share `deep` of the ground, less of crowns, and none of the
    road where it was plowed; `patchy` is how much that varies from place to place."""
    rng = np.random.default_rng(seed)
    image = rendering.image.astype(np.float32)
    cover = deep + patchy * _field(rng, image.shape[:2])
    cover *= (1 - 0.55 * _crowns(image)) * (1 - plowed * _road(rendering, 1.2))
    share = np.clip(cover, 0, 0.97)[..., None]
    white = image * (1 - share) + (245 - 45 * deep**8 + 0.2 * (1 - deep) * image) * share
    return _with_noise(rng, white)


def gray_infrared(rendering: Rendering, seed: int) -> Image:
    """The scene in infrared light, in which plants are bright, as one gray channel."""
    rng = np.random.default_rng(seed)
    # The color of what is green, without the blocks of JPEG.
    light, *colors = cv2.split(cv2.cvtColor(rendering.image, cv2.COLOR_BGR2YCrCb))
    smooth = [cv2.GaussianBlur(color, (0, 0), 2.5) for color in colors]
    image = cv2.cvtColor(cv2.merge([light, *smooth]), cv2.COLOR_YCrCb2BGR).astype(np.float32)
    plants = _green(image) * (1 - 0.8 * _road(rendering, 1.5))
    bright = 0.75 * image[..., 1] + 100 * plants
    return _with_noise(rng, np.dstack([bright] * 3))


def color_infrared(rendering: Rendering, seed: int) -> Image:
    """Infrared, red and green shown as red, green and blue."""
    image = rendering.image.astype(np.float32)
    _, green, red = cv2.split(image)
    infrared = np.clip(0.8 * green + 110 * _green(image), 0, 255)
    return np.dstack([green, red, infrared]).astype(np.uint8)


def desert(rendering: Rendering, seed: int) -> Image:
    """The scene with the tint of sand, more of it where plants were."""
    image = rendering.image.astype(np.float32)
    sand = image.mean(axis=2, keepdims=True) * np.array([0.95, 1.25, 1.5]) + 20
    share = np.clip(0.25 + _green(image), 0, 1)[..., None]
    mixed: Image = np.clip(image * (1 - share) + sand * share, 0, 255).astype(np.uint8)
    return mixed


CONDITIONS: dict[str, Callable[[Rendering, int], Image]] = {
    "clean": lambda rendering, seed: rendering.image,
    "snow, roads plowed": snow,
    "snow, patches": lambda r, seed: snow(r, seed, deep=0.5, plowed=0.9, patchy=0.35),
    "snow, roads half white": lambda r, seed: snow(r, seed, plowed=0.65, patchy=0.03),
    "snow, roads packed": lambda r, seed: snow(r, seed, plowed=0.28),
    "deep snow, roads black": lambda r, seed: snow(r, seed, deep=0.99),
    "gray infrared": gray_infrared,
    "color infrared": color_infrared,
    "gray": lambda r, seed: np.dstack([r.image.mean(axis=2)] * 3).astype(np.uint8),
    "desert": desert,
    "blurred by 2 px": lambda r, seed: cv2.GaussianBlur(r.image, (0, 0), 2.0),
    "2 m per pixel": lambda r, seed: cv2.resize(r.image, None, None, 0.5, 0.5, cv2.INTER_AREA),
}


def main() -> None:
    """Print a row for each condition."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.extraction.conditions")
    parser.add_argument("--scenes", type=int, default=16)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--seed", type=int, default=_SEED)
    told = parser.parse_args()
    cv2.setNumThreads(1)
    plans = [_PLANS[index % len(_PLANS)] for index in range(told.scenes)]
    scenes = [render_aerial(plan, told.seed + i, told.size) for i, plan in enumerate(plans)]
    clean = 0.0
    print(f"{'condition':24s}{'photos':>8s}{'F1@3':>8s}{'of clean':>10s}{'path':>8s}")
    for name, seen_as in CONDITIONS.items():
        pictures = [np.ascontiguousarray(seen_as(r, i)) for i, r in enumerate(scenes)]
        rows = [_scores(*pair) for pair in zip(pictures, scenes, strict=True)]
        photos, f1, path = (float(np.mean(column)) for column in zip(*rows, strict=True))
        clean = clean or f1
        print(f"{name:24s}{photos:8.0%}{f1:8.3f}{f1 / clean:10.3f}{path:8.3f}", flush=True)


def _scores(image: Image, rendering: Rendering) -> tuple[float, float, float]:
    """Whether it is taken for a photo; F1 and path of its roads, 0 if it is not."""
    kind = picture_kind(image)
    if kind.drawn or (not kind.exact and roads_on_paper(image, textured=True) is not None):
        return 0.0, 0.0, 0.0
    scale = rendering.image.shape[1] / image.shape[1]
    found = checked_roads(image, Request(meters_per_pixel=scale if scale > 1 else None), road_net())
    lines = [np.asarray(line) for line in rendering.truth.polylines()]
    roads = [scale * road.points + (scale - 1) / 2 for road in found.roads]
    scores = score(Case.of_lines(rendering.image, lines), roads)
    return 1.0, scores["F1@3"], scores["path"]


def _green(image: Layer) -> Layer:
    blue, green, red = cv2.split(image)
    return np.asarray(np.clip((2 * green - blue - red) / 40, 0, 1), np.float32)


def _road(rendering: Rendering, blur: float) -> Layer:
    surface = (rendering.truth.mask() > 0).astype(np.float32)
    return np.asarray(cv2.GaussianBlur(surface, (0, 0), blur), np.float32)


def _crowns(image: Layer) -> Layer:
    """What is dark and rough (h, w), 0..1."""
    gray = cv2.cvtColor(np.clip(image, 0, 255).astype(np.uint8), cv2.COLOR_BGR2GRAY)
    light = gray.astype(np.float32)
    smooth = cv2.GaussianBlur(light, (0, 0), 2)
    rough = cv2.GaussianBlur(np.abs(light - smooth), (0, 0), 3)
    return np.asarray(np.clip((rough - 7) / 6, 0, 1) * np.clip((120 - smooth) / 40, 0, 1))


def _field(rng: np.random.Generator, shape: tuple[int, ...]) -> Layer:
    """Smooth noise (h, w) with a deviation of 1."""
    field = cv2.GaussianBlur(rng.standard_normal(shape).astype(np.float32), (0, 0), 9)
    return np.asarray(field / field.std(), np.float32)


def _with_noise(rng: np.random.Generator, image: Layer) -> Image:
    noisy = image + 2 * rng.standard_normal(image.shape)
    return np.asarray(np.clip(noisy, 0, 255), np.uint8)


if __name__ == "__main__":
    main()
