"""The picture that a network was extracted from, under the roads of a drawing."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING

from .markup import element

if TYPE_CHECKING:
    from roadlang.api import Picture

    from .viewport import Viewport

_MOST_PIXELS = 1600
_QUALITY = 82


def beneath(picture: Picture, viewport: Viewport, fade: float) -> str:
    """The picture in its place; `fade` is the share of white that is mixed in, 0 to 1."""
    if picture.pixels is None:
        return ""
    if picture.north_up is not None:
        return _turned(picture, viewport, fade)
    corners = viewport.place([[0.0, picture.height * picture.scale], [0.0, 0.0]])
    left, top = corners[0].tolist()
    scale = picture.scale * viewport.pixels_per_meter
    return element(
        "image",
        x=left,
        y=top,
        width=picture.width * scale,
        height=picture.height * scale,
        preserveAspectRatio="none",
        opacity=1.0 - fade,
        href=f"data:image/jpeg;base64,{_encoded(picture)}",
    )


def _turned(picture: Picture, viewport: Viewport, fade: float) -> str:
    """One whose up is not north."""
    import numpy as np

    width, height = picture.width, picture.height
    corners = np.array([(0.0, 0.0), (width, 0.0), (0.0, height)]) - 0.5
    first, right, down = np.asarray(viewport.place(picture.to_world(corners)))
    matrix = [*(right - first) / width, *(down - first) / height, *first]
    return element(
        "image",
        width=width,
        height=height,
        transform=f"matrix({' '.join(f'{value:.6g}' for value in matrix)})",
        preserveAspectRatio="none",
        opacity=1.0 - fade,
        href=f"data:image/jpeg;base64,{_encoded(picture)}",
    )


def _encoded(picture: Picture) -> str:
    import cv2

    pixels = picture.pixels
    assert pixels is not None
    shrink = min(1.0, _MOST_PIXELS / max(picture.width, picture.height))
    if shrink < 1.0:
        pixels = cv2.resize(pixels, None, fx=shrink, fy=shrink, interpolation=cv2.INTER_AREA)
    fine, content = cv2.imencode(".jpg", pixels, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])
    return base64.b64encode(content.tobytes()).decode() if fine else ""
