"""What `roadlang extract` writes: JSON, a mask, and an overlay to look at."""

from __future__ import annotations

import base64
import json
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import cv2
import numpy as np

from ..geometry.arrays import Floats
from ..images.mapped_pixels import mapped
from ..ir.picture import Extraction, Picture
from ..version import __version__

SCHEMA = "roadlang.extraction/1"
_STEP = 2.0
_OVERLAY_SIDE = 1600
_LEVELS = 5
"""Colors of stretches of a road, beside that of 0 % sure."""


def as_json(
    picture: Picture,
    found: Extraction,
    is_scaled: bool,
    seconds: float,
    mask: str | None,
    tiles: Sequence[str] = (),
) -> str:
    """Polylines, nodes, widths, confidence: all in pixels of the file. `tiles`: the files that the
    picture was put together from. `is_scaled`: its scale is known."""
    roads = _roads(picture, found)
    nodes = _pixels(picture, np.array([n.position for n in found.network.nodes]).reshape(-1, 2))
    width, height = picture.file_size
    document: dict[str, Any] = {
        "schema": SCHEMA,
        "roadlang": __version__,
        "image": {"path": picture.path, "width": width, "height": height},
        "meters_per_pixel": picture.file_scale if is_scaled else None,
        "polylines": [line for line, _ in roads],
        "roads": [record for _, record in roads],
        "nodes": [
            {"id": node.id, "position": at.round(2).tolist()}
            for node, at in zip(found.network.nodes, nodes, strict=True)
        ],
        "objects": [_object(picture, item) for item in found.objects],
        "confidence": round(found.confidence, 4),
        "remarks": list(found.remarks),
        "time_s": round(seconds, 3),
    }
    if len(tiles) > 1:
        document["image"]["tiles"] = list(tiles)
    if mask is not None:
        document["mask"] = mask
    return json.dumps(document, allow_nan=False) + "\n"


def _roads(picture: Picture, found: Extraction) -> list[tuple[Any, dict[str, Any]]]:
    """Points of each road, and what is said of it."""
    roads = []
    for index, edge in enumerate(found.network.edges):
        line, widths = polyline(picture, edge)
        record = {
            "start": edge.start,
            "end": edge.end,
            "closed": bool(edge.curve.closed),
            "length": round(edge.length / picture.file_scale, 2),
            "widths": widths.round(2).tolist(),
            "confidence": round(float(edge.confidence), 4),
        }
        if index < len(found.width_errors) and np.isfinite(found.width_errors[index]):
            record["width_error"] = round(found.width_errors[index] / picture.file_scale, 3)
        if index < len(found.confidences):
            record["confidences"] = _along(found, index, len(line)).round(3).tolist()
        roads.append((line.round(2).tolist(), record))
    return roads


def polyline(picture: Picture, edge: Any) -> tuple[Floats, Floats]:
    """A road's points (n, 2) about two pixels apart, and its widths there, in pixels."""
    points, widths = in_meters(picture, edge)
    return _pixels(picture, points), widths / picture.file_scale


def in_meters(picture: Picture, edge: Any) -> tuple[Floats, Floats]:
    """The same points of a road in the picture's meters, and its widths there."""
    stations = edge.curve.stations(spacing=_STEP * picture.file_scale)
    points, widths = edge.curve.at(stations), np.asarray(edge.width.at(stations))
    if edge.curve.closed:
        points, widths = np.vstack([points, points[:1]]), np.r_[widths, widths[:1]]
    return points, widths


def _pixels(picture: Picture, points: Floats) -> Floats:
    """Of the file, where points (n, 2) in meters are."""
    return picture.to_file(picture.to_pixels(points))


def _along(found: Extraction, index: int, count: int) -> Floats:
    """How sure a road is at `count` points at even arc lengths, its ends included."""
    edge = found.network.edges[index]
    known = found.confidences[index] if index < len(found.confidences) else [edge.confidence]
    return np.interp(np.linspace(0, 1, count), np.linspace(0, 1, len(known)), known)


def _object(picture: Picture, item: Any) -> dict[str, Any]:
    x, y = _pixels(picture, np.array([[item.x, item.y]]))[0]
    scale = picture.file_scale
    sides = {"length": item.length / scale, "width": item.width / scale}
    return {"kind": item.kind, "position": [round(x, 2), round(y, 2)], **sides}


def as_mask(picture: Picture, found: Extraction) -> bytes:
    """The road surface as a PNG: 255 is road."""
    width, height = picture.file_size
    canvas = np.zeros((height, width), np.uint8)
    if found.mask is not None and found.mask.shape == (picture.height, picture.width):
        covered = np.where(found.mask, np.uint8(255), np.uint8(0))
        canvas = mapped(covered, picture.file, blends=False)
    else:
        for edge in found.network.edges:
            points, widths = polyline(picture, edge)
            at = [np.round(points * 16).astype(np.int32)]
            cv2.polylines(canvas, at, False, 255, max(1, round(float(np.median(widths)))), 8, 4)
    return bytes(cv2.imencode(".png", canvas)[1].tobytes())


def as_overlay(picture: Picture, found: Extraction) -> str:
    """An SVG: the picture, the roads colored by confidence, their nodes."""
    width, height = picture.file_size
    view = f'viewBox="-0.5 -0.5 {width} {height}" width="{width}" height="{height}"'
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" {view}>', _backdrop(picture)]
    parts.append('<g fill="none" stroke-linecap="round" stroke-linejoin="round">')
    for index, edge in enumerate(found.network.edges):
        points, widths = polyline(picture, edge)
        road = f"{float(np.median(widths)):.2f}"
        parts.append(
            f'<path d="{_path(points)}" stroke="{_color(edge.confidence)}" stroke-opacity="0.35"'
            f' stroke-width="{road}"/>'
        )
        parts += _stretches(points, _along(found, index, len(points)), edge.confidence)
    parts.append('</g><g fill="#ffffff" stroke="#1a237e" stroke-width="1">')
    for node in found.network.nodes:
        x, y = _pixels(picture, np.array([node.position]))[0]
        parts.append(f'<circle cx="{x:.2f}" cy="{y:.2f}" r="2.6"/>')
    return "\n".join([*parts, "</g>", "</svg>", ""])


def _stretches(points: Floats, sure: Floats, whole: float) -> list[str]:
    """A road's center line in paths of one color each, with how sure they are."""
    level = np.round(sure * _LEVELS).astype(int)
    cuts = [0, *(np.flatnonzero(np.diff(level)) + 1), len(points) - 1]
    return [
        f'<path d="{_path(points[first : last + 1])}" stroke="{_color(level[first] / _LEVELS)}"'
        f' stroke-width="1.6"><title>{float(sure[first : last + 1].mean()):.0%} sure here,'
        f" {whole:.0%} overall</title></path>"
        for first, last in pairwise(cuts)
        if last > first
    ]


def _backdrop(picture: Picture) -> str:
    if picture.pixels is None:
        return ""
    width, height = picture.file_size
    factor = min(1.0, _OVERLAY_SIDE / max(height, width))
    size = (max(1, round(width * factor)), max(1, round(height * factor)))
    shown = mapped(picture.pixels, picture.file)
    small = cv2.resize(shown, size, interpolation=cv2.INTER_AREA)
    code = cv2.imencode(".jpg", small, [cv2.IMWRITE_JPEG_QUALITY, 85])[1].tobytes()
    data = base64.b64encode(code).decode("ascii")
    place = f'x="-0.5" y="-0.5" width="{width}" height="{height}"'
    return f'<image {place} href="data:image/jpeg;base64,{data}"/>'


def _path(points: Floats) -> str:
    return "M" + " L".join(f"{x:.1f},{y:.1f}" for x, y in points)


def _color(sure: float) -> str:
    """From red (doubtful) over amber to cyan (sure)."""
    stops = ((0.0, (229, 57, 53)), (0.6, (255, 179, 0)), (1.0, (0, 229, 255)))
    for (low, a), (high, b) in pairwise(stops):
        if sure <= high:
            t = (sure - low) / (high - low)
            return "#" + "".join(f"{round(p + t * (q - p)):02x}" for p, q in zip(a, b, strict=True))
    return "#00e5ff"
