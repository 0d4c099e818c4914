"""Makes the pictures of the examples with roadlang's own renderer, and stores their exact truth.

Run it from anywhere: `python examples/make_pictures.py`. The same versions give the same bytes.
"""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np

from training.rendering.aerial import render_aerial
from training.rendering.frame import Rendering

HERE = Path(__file__).parent
JPEG_QUALITY = 92


def hairpin() -> Rendering:
    """A hairpin bend in open country: 240 m, half a meter a pixel."""
    return render_aerial("bend", seed=5, size=480, meters_per_pixel=0.5)


def village() -> Rendering:
    """A few streets that meet: 320 m, half a meter a pixel."""
    return render_aerial("village", seed=8, size=640, meters_per_pixel=0.5)


PHOTOS = {"hairpin": hairpin, "village": village}

WHITE, TREE, BUILDING, GRASS = (255, 255, 255), (50, 125, 46), (28, 28, 183), (160, 214, 197)


def drawn_town() -> np.ndarray:
    """A drawing of 96 x 64 pixels, one meter each: white roads, green trees, red buildings."""
    picture = np.full((64, 96, 3), GRASS, np.uint8)
    for start, end in (
        ((0, 20), (95, 20)),
        ((30, 0), (30, 63)),
        ((30, 48), (95, 48)),
        ((72, 20), (72, 48)),
    ):
        cv2.line(picture, start, end, WHITE, 6)
    for x, y in (
        (8, 8),
        (18, 10),
        (12, 34),
        (20, 44),
        (10, 54),
        (44, 56),
        (58, 58),
        (84, 36),
        (88, 10),
    ):
        cv2.circle(picture, (x, y), 2, TREE, -1)
    for corner in ((40, 6), (56, 5), (40, 28), (54, 32), (78, 54), (4, 40)):
        x, y = corner
        cv2.rectangle(picture, corner, (x + 8, y + 6), BUILDING, -1)
    return picture


def drawn_roundabout() -> np.ndarray:
    """A drawing of 240 x 200 pixels, one meter each: four white roads that meet at a ring."""
    picture = np.full((200, 240, 3), GRASS, np.uint8)
    middle = (120, 100)
    for end in ((0, 112), (128, 0), (239, 90), (110, 199)):
        cv2.line(picture, middle, end, WHITE, 7)
    cv2.circle(picture, middle, 25, GRASS, -1)
    cv2.circle(picture, middle, 22, WHITE, 6)
    for corner in ((30, 30), (60, 20), (170, 140), (190, 30), (40, 150)):
        x, y = corner
        cv2.rectangle(picture, corner, (x + 14, y + 10), BUILDING, -1)
    for x, y in ((120, 100), (116, 104), (125, 97), (70, 80), (160, 120), (90, 160), (150, 40)):
        cv2.circle(picture, (x, y), 2, TREE, -1)
    return picture


def truth_of(rendering: Rendering) -> dict[str, object]:
    """Center lines and widths in pixels (x right, y down; a pixel's center is a whole number)."""
    truth = rendering.truth
    return {
        "meters_per_pixel": truth.meters_per_pixel,
        "shape": list(truth.shape),
        "roads": [
            {
                "points": np.round(road.points, 2).tolist(),
                "width": round(road.width, 3),
                "closed": road.closed,
            }
            for road in truth.roads
        ],
    }


def main() -> None:
    """Render the photos with their truth files."""
    for name, make in PHOTOS.items():
        rendering = make()
        quality = [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY]
        cv2.imwrite(str(HERE / f"{name}.jpg"), rendering.image, quality)
        text = json.dumps(truth_of(rendering), separators=(",", ":"))
        (HERE / f"{name}.truth.json").write_text(text + "\n", encoding="utf-8")
    cv2.imwrite(str(HERE / "town.png"), drawn_town())
    cv2.imwrite(str(HERE / "roundabout.png"), drawn_roundabout())


if __name__ == "__main__":
    main()
