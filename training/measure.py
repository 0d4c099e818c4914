"""A quick score of the center-line map while training: relaxed F1 over pixels."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import torch

from roadlang_standard.extraction.photos.exposure import even_exposure
from training.net import RoadNet, has_half_precision
from training.pool import load, scenes

Case = tuple[np.ndarray, np.ndarray]
"""A picture (h, w, 3) and the mask of its center lines (h, w)."""


def photos(folder: Path) -> list[Case]:
    """Aerial photos with masks, listed by a manifest; enlarged ones at their own scale again."""
    cases = []
    for entry in json.loads((folder / "manifest.json").read_text())["images"]:
        if entry["kind"] == "track-drawing":
            continue
        image = cv2.imread(str(folder / entry["file"]))
        mask = cv2.imread(str(folder / entry["mask"]), cv2.IMREAD_GRAYSCALE)
        scale = 1 / entry.get("upsampled", 1)
        image = cv2.resize(image, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        mask = cv2.resize(mask, image.shape[1::-1], interpolation=cv2.INTER_AREA) > 127
        inner = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 5)
        cases.append((image, (inner >= 0.8 * cv2.dilate(inner, np.ones((7, 7)))) & mask))
    return cases


def renderings(folder: Path, count: int) -> list[Case]:
    """The first scenes of a pool."""
    cases = []
    for path in scenes(folder)[:count]:
        scene = load(path)
        line = np.zeros(scene.image.shape[:2], np.uint8)
        for points in scene.lines:
            cv2.polylines(
                line, [np.round(points * 16).astype(np.int32)], False, 1, 1, cv2.LINE_8, 4
            )
        cases.append((scene.image, line > 0))
    return cases


def relaxed_f1(net: RoadNet, cases: list[Case], radius: float = 3.0) -> float:
    """Mean relaxed F1 of the ridge of {surface and line > 0.5} against the center lines."""
    net.eval()
    scores = []
    for image, line in cases:
        maps = probabilities(net, image)
        score = maps.mean(axis=0)
        ridge = (score >= 0.98 * cv2.dilate(score, np.ones((5, 5)))) & (score > 0.4)
        to_line = cv2.distanceTransform((~line).astype(np.uint8), cv2.DIST_L2, 5)
        to_ridge = cv2.distanceTransform((~ridge).astype(np.uint8), cv2.DIST_L2, 5)
        p = float((to_line[ridge] <= radius).mean()) if ridge.any() else 0.0
        r = float((to_ridge[line] <= radius).mean()) if line.any() else 0.0
        scores.append(2 * p * r / (p + r) if p + r else 0.0)
    return float(np.mean(scores))


def probabilities(net: RoadNet, image: np.ndarray) -> np.ndarray:
    """The two maps (2, h, w) at the picture's own size."""
    height, width = image.shape[:2]
    even = even_exposure(image)
    padded = cv2.copyMakeBorder(even, 0, -height % 32, 0, -width % 32, cv2.BORDER_REFLECT_101)
    tensor = torch.from_numpy(np.ascontiguousarray(padded[..., ::-1], np.float32)).permute(2, 0, 1)[
        None
    ]
    with torch.no_grad(), torch.autocast("cpu", torch.bfloat16, enabled=has_half_precision()):
        maps = net(tensor).float().numpy()[0]
    return np.stack(
        [
            cv2.resize(m, padded.shape[1::-1], interpolation=cv2.INTER_LINEAR)[:height, :width]
            for m in maps
        ]
    )
