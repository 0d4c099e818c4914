"""Seeded noise and textures, built from resized random grids."""

from __future__ import annotations

import cv2
import numpy as np

from training.rendering.frame import Frame, Layer


def smooth(rng: np.random.Generator, frame: Frame, wavelength: float) -> Layer:
    """Smooth noise of unit deviation whose features are about `wavelength` meters."""
    cell = max(1.0, frame.length(wavelength) / 2)
    count = int(frame.size / cell) + 4
    grid = rng.standard_normal((count, count)).astype(np.float32)
    zoom = np.array([[1 / cell, 0, rng.uniform(1, 2)], [0, 1 / cell, rng.uniform(1, 2)]])
    flags = cv2.INTER_CUBIC | cv2.WARP_INVERSE_MAP
    # `warpAffine` knows 32 positions between two cells: with more pixels, waves would have steps.
    coarse = max(1, int(cell / 16))
    size = -(-frame.size // coarse) + 2
    zoom[:, :2] *= coarse
    field = cv2.warpAffine(grid, zoom, (size, size), flags=flags, borderMode=cv2.BORDER_REFLECT)
    if coarse > 1:
        field = cv2.resize(field, None, fx=coarse, fy=coarse, interpolation=cv2.INTER_LINEAR)
    within = slice(coarse - 1, coarse - 1 + frame.size)
    field = field[within, within]
    return (field - field.mean()) / max(float(field.std()), 1e-6)


def fractal(
    rng: np.random.Generator, frame: Frame, wavelength: float, octaves: int = 4, gain: float = 0.6
) -> Layer:
    """Octaves of smooth noise, unit deviation."""
    total = np.zeros(frame.shape, np.float32)
    for octave in range(octaves):
        total += gain**octave * smooth(rng, frame, wavelength / 2**octave)
    return total / max(float(total.std()), 1e-6)


def streaks(rng: np.random.Generator, frame: Frame, length: float, angle: float) -> Layer:
    """White noise drawn out along `angle` (radians, picture axes) by `length` meters."""
    noise = rng.standard_normal(frame.shape).astype(np.float32)
    field = cv2.filter2D(noise, -1, line_kernel(frame.length(length), angle))
    return (field - field.mean()) / max(float(field.std()), 1e-6)


def line_kernel(length: float, angle: float) -> Layer:
    """A centered line of `length` pixels, summing to one."""
    reach = max(1, round(length / 2))
    kernel = np.zeros((2 * reach + 1, 2 * reach + 1), np.float32)
    dx, dy = np.cos(angle) * reach, np.sin(angle) * reach
    ends = np.round(np.array([[reach - dx, reach - dy], [reach + dx, reach + dy]]) * 16).astype(int)
    cv2.line(kernel, tuple(map(int, ends[0])), tuple(map(int, ends[1])), 1.0, 1, cv2.LINE_8, 4)
    return kernel / kernel.sum()


def relief(rng: np.random.Generator, frame: Frame, size: float, sun: float) -> Layer:
    """Crowns of about `size` meters lit from `sun` (radians): band-passed noise, embossed."""
    sigma = max(0.5, frame.length(size) / 4)
    noise = rng.standard_normal(frame.shape).astype(np.float32)
    near = cv2.GaussianBlur(noise, (0, 0), sigma)
    band = near - cv2.GaussianBlur(noise, (0, 0), 2 * sigma)
    step = max(1.0, sigma)
    shift = np.array([[1, 0, step * np.cos(sun)], [0, 1, step * np.sin(sun)]], np.float32)
    lit = band - cv2.warpAffine(band, shift, frame.shape[::-1], borderMode=cv2.BORDER_REFLECT)
    return lit / max(float(lit.std()), 1e-6)


def blend(image: Layer, color: Layer | tuple[float, ...], cover: Layer) -> None:
    """Lay a color over the picture in place, where `cover` (h, w) in 0..1 says."""
    image += cover[..., None] * (np.asarray(color, np.float32) - image)
