"""What agents and objects look like in glTF files, part by part, beside what is said of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from roadlang_formats.gltf.meshes import Faces
from roadlang_formats.gltf.shapes import _SHAPES, _block, body

Row = tuple[Any, ...]
# A wheel: along and across (from, to), its radius. Other parts: height (from, to), the least and
# the greatest x, the greatest y, and how far forward they reach at their bottom and top.
# fmt: off
PARTS: list[tuple[str, tuple[float, float, float], list[Row]]] = [
    ("car", (4.0, 2.0, 1.5), [
         ("wheel", -1.2, -1.0, -0.75, 0.345),
         ("wheel", -1.2, 0.75, 1.0, 0.345),
         ("wheel", 1.2, -1.0, -0.75, 0.345),
         ("wheel", 1.2, 0.75, 1.0, 0.345),
         ("paint", 0.27, 0.9, -2.0, 2.0, 0.98, 2.0, 2.0),
         ("glass", 0.9, 1.395, -1.56, 0.88, 0.862, 0.88, 0.88),
         ("paint", 1.395, 1.5, -1.44, 0.72, 0.843, 0.72, 0.72),
    ]),
    ("car", (2.0, 1.0, 3.0), [
         ("wheel", -0.6, -0.5, -0.3, 0.3),
         ("wheel", -0.6, 0.3, 0.5, 0.3),
         ("wheel", 0.6, -0.5, -0.3, 0.3),
         ("wheel", 0.6, 0.3, 0.5, 0.3),
         ("paint", 0.54, 1.8, -1.0, 1.0, 0.49, 1.0, 1.0),
         ("glass", 1.8, 2.79, -0.78, 0.44, 0.431, 0.44, 0.44),
         ("paint", 2.79, 3.0, -0.72, 0.36, 0.421, 0.36, 0.36),
    ]),
    ("van", (4.0, 2.0, 2.0), [
         ("wheel", -1.2, -1.0, -0.75, 0.46),
         ("wheel", -1.2, 0.75, 1.0, 0.46),
         ("wheel", 1.2, -1.0, -0.75, 0.46),
         ("wheel", 1.2, 0.75, 1.0, 0.46),
         ("paint", 0.32, 2.0, -2.0, 0.8, 0.98, 0.8, 0.8),
         ("paint", 0.32, 1.0, 0.8, 2.0, 0.98, 2.0, 2.0),
         ("glass", 1.0, 1.7, 0.8, 1.9, 0.902, 1.9, 1.9),
    ]),
    ("bus", (12.0, 2.5, 3.0), [
         ("wheel", -3.6, -1.25, -1.0, 0.5),
         ("wheel", -3.6, 1.0, 1.25, 0.5),
         ("wheel", 3.6, -1.25, -1.0, 0.5),
         ("wheel", 3.6, 1.0, 1.25, 0.5),
         ("paint", 0.48, 3.0, -6.0, 4.4, 1.225, 4.4, 4.4),
         ("paint", 0.48, 1.5, 4.4, 6.0, 1.225, 6.0, 6.0),
         ("glass", 1.5, 2.55, 4.4, 5.7, 1.127, 5.7, 5.7),
    ]),
    ("bicycle", (1.8, 0.6, 1.7), [
         ("wheel", -0.55, -0.04, 0.04, 0.35),
         ("wheel", 0.55, -0.04, 0.04, 0.35),
         ("paint", 0.42, 0.504, -0.55, 0.55, 0.06, 0.55, 0.55),
         ("metal", 0.546, 0.588, 0.385, 0.55, 0.3, 0.55, 0.55),
         ("paint", 0.504, 1.7, -0.36, 0.18, 0.18, 0.18, 0.18),
    ]),
    ("motorcycle", (1.0, 0.8, 1.0), [
         ("wheel", -0.3, -0.04, 0.04, 0.2),
         ("wheel", 0.3, -0.04, 0.04, 0.2),
         ("paint", 0.24, 0.288, -0.3, 0.3, 0.06, 0.3, 0.3),
         ("metal", 0.312, 0.336, 0.21, 0.3, 0.4, 0.3, 0.3),
         ("paint", 0.288, 1.0, -0.2, 0.1, 0.24, 0.1, 0.1),
    ]),
    ("pedestrian", (0.4, 0.6, 1.8), [
         ("tire", 0.0, 0.864, -0.12, 0.12, 0.21, 0.12, 0.12),
         ("paint", 0.864, 1.53, -0.2, 0.2, 0.3, 0.2, 0.2),
         ("skin", 1.53, 1.8, -0.12, 0.12, 0.15, 0.12, 0.12),
    ]),
    ("animal", (1.0, 0.4, 0.8), [
         ("paint", 0.32, 0.68, -0.5, 0.35, 0.2, 0.35, 0.35),
         ("paint", 0.44, 0.8, 0.3, 0.5, 0.12, 0.5, 0.5),
         ("paint", 0.0, 0.32, -0.4, -0.3, 0.16, -0.3, -0.3),
         ("paint", 0.0, 0.32, 0.25, 0.35, 0.16, 0.35, 0.35),
    ]),
    ("tree", (6.0, 5.0, 10.0), [
         ("trunk", 0.0, 3.0, -0.39, 0.39, 0.39, 0.39, 0.3),
         ("paint", 2.2, 6.0, -3.0, 3.0, 2.5, 3.0, 1.05),
         ("paint", 5.0, 8.0, -2.25, 2.25, 1.875, 2.25, 0.6),
         ("paint", 7.0, 10.0, -1.5, 1.5, 1.25, 1.5, 0.06),
    ]),
    ("bush", (2.0, 1.0, 1.0), [
         ("paint", 0.0, 0.45, -1.0, 1.0, 0.5, 0.8, 1.0),
         ("paint", 0.45, 1.0, -1.0, 1.0, 0.5, 1.0, 0.5),
    ]),
    ("building", (10.0, 8.0, 7.0), [
         ("paint", 0.0, 6.7, -4.95, 4.95, 3.96, 4.95, 4.95),
         ("roof", 6.7, 7.0, -5.0, 5.0, 4.0, 5.0, 5.0),
         ("glass", 1.0, 2.2, -5.0, 5.0, 3.2, 5.0, 5.0),
         ("glass", 1.0, 2.2, -4.0, 4.0, 4.0, 4.0, 4.0),
         ("glass", 4.0, 5.2, -5.0, 5.0, 3.2, 5.0, 5.0),
         ("glass", 4.0, 5.2, -4.0, 4.0, 4.0, 4.0, 4.0),
    ]),
    ("building", (10.0, 8.0, 2.0), [
         ("paint", 0.0, 1.8, -4.95, 4.95, 3.96, 4.95, 4.95),
         ("roof", 1.8, 2.0, -5.0, 5.0, 4.0, 5.0, 5.0),
    ]),
    ("pole", (0.2, 0.4, 5.0), [
         ("metal", 0.0, 4.5, -0.06, 0.06, 0.12, 0.06, 0.04),
         ("metal", 4.5, 5.0, -0.1, 0.1, 0.2, 0.1, 0.1),
    ]),
    ("cone", (0.4, 0.4, 1.0), [
         ("paint", 0.0, 0.06, -0.2, 0.2, 0.2, 0.2, 0.2),
         ("paint", 0.06, 1.0, -0.14, 0.14, 0.14, 0.14, 0.024),
    ]),
    ("rock", (1.0, 2.0, 3.0), [
         ("paint", 0.0, 3.0, -0.5, 0.5, 1.0, 0.5, 0.5),
    ]),
]
# fmt: on


def row(part: Faces) -> Row:
    x, y, z = np.asarray(part.points).reshape(-1, 3).T
    bottom, top = z.min(), z.max()
    if part.material == "tire" and len(np.unique(z.round(6))) > 2:
        return "wheel", (x.min() + x.max()) / 2, y.min(), y.max(), top / 2
    ends = x[z < bottom + 1e-5].max(), x[z > top - 1e-5].max()
    return part.material, bottom, top, x.min(), x.max(), y.max(), *ends


@pytest.mark.parametrize(("category", "size", "parts"), PARTS)
def test_a_body_is_made_of_its_parts(
    category: str, size: tuple[float, float, float], parts: list[Row]
) -> None:
    found = [row(part) for part in _SHAPES.get(category, _block)("paint", *size)]
    assert [part[0] for part in found] == [part[0] for part in parts]
    for one, other in zip(found, parts, strict=True):
        np.testing.assert_allclose(one[1:], other[1:], atol=2e-3)


@pytest.mark.parametrize("size", [(4.5, 1.9, 1.5), (0.3, 0.4, 6.0), (14.0, 9.0, 12.0)])
@pytest.mark.parametrize("category", ["something", *_SHAPES])
def test_a_body_is_as_large_as_it_says(category: str, size: tuple[float, float, float]) -> None:
    points = np.concatenate([part.points for part in body(category, "paint", *size)])
    length, width, height = size
    low, high = points.min(axis=0), points.max(axis=0)
    np.testing.assert_allclose(low, [-length / 2, -width / 2, 0.0], atol=1e-6)
    np.testing.assert_allclose(high, [length / 2, width / 2, height], atol=1e-6)
