"""The way from light to pixels: haze, gain, gamma, blur, sharpening, noise, JPEG."""

from __future__ import annotations

import cv2
import numpy as np

from training.rendering.frame import Image, Layer


def expose(rng: np.random.Generator, light: Layer) -> Image:
    """A photograph (h, w, 3) uint8 of a picture in 0..1."""
    image = np.clip(light, 0, 1) ** rng.uniform(0.8, 1.25)
    haze = rng.uniform(0, 0.12)
    image = (1 - haze) * image + haze * np.array([0.75, 0.7, 0.65], np.float32)
    image = (image - 0.4) * rng.uniform(0.85, 1.3) + 0.42 + rng.normal(0, 0.04)
    image = image * rng.normal(1, 0.03, 3).astype(np.float32)
    image = cv2.GaussianBlur(image.astype(np.float32), (0, 0), rng.uniform(0.35, 0.85))
    if rng.random() < 0.6:
        soft = cv2.GaussianBlur(image, (0, 0), 1.2)
        image = image + rng.uniform(0.2, 1.2) * (image - soft)
    image = image + rng.uniform(0, 0.025) * rng.standard_normal(image.shape).astype(np.float32)
    picture = (np.clip(image, 0, 1) * 255 + 0.5).astype(np.uint8)
    if rng.random() < 0.5:
        _, code = cv2.imencode(
            ".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(45, 96))]
        )
        picture = cv2.imdecode(code, cv2.IMREAD_COLOR)
    return picture
