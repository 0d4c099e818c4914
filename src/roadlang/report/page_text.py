"""The page: one HTML document with its style, its scripts and its data."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from string import Template
from typing import Any

from ..drive.robustness_colors import COLOR_STEPS, robustness_color
from ..ir.result_files import REPORT_GENERATOR
from ..plugins.registry import Registry
from .drive_records import DriveView, drive_record, samples_per_drive, view
from .elements import text
from .results import Results
from .sections import (
    coverage,
    facts,
    galleries,
    heading,
    headline,
    progress,
    provenance,
    random_values,
)
from .tables import table_record

_PAGE = Path(__file__).parent / "page"
_SCRIPTS = ("charts.js", "viewer.js", "table.js")


def page_text(results: Results, registry: Registry) -> str:
    """The document. The same results give the same bytes."""
    views = [view(drive, registry) for drive in results.drives]
    record = results.record
    parts = {
        "title": text(record.title or record.name or record.source),
        "heading": heading(results),
        "headline": headline(results),
        "facts": facts(results, views),
        "progress": progress(results, views),
        "galleries": galleries(results, views),
        "coverage": coverage(results),
        "apart": random_values(results, views),
        "provenance": provenance(results),
        "version": text(record.roadlang),
        "style": _file("page.css"),
        "script": "\n".join(map(_file, _SCRIPTS)),
        "generator": REPORT_GENERATOR,
        "data": embedded(_data(results, views)),
    }
    return Template(_file("page.html")).substitute(parts)


def embedded(value: Any) -> str:
    """JSON for a `<script>`: nothing in it ends the element, or is read as markup."""
    written = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    for character in "<>&\u2028\u2029":
        written = written.replace(character, f"\\u{ord(character):04x}")
    return written


def _data(results: Results, views: Sequence[DriveView]) -> dict[str, Any]:
    roads: dict[str, int] = {}
    samples = samples_per_drive(views)
    drives = [drive_record(found, roads, samples) for found in views]
    rows = {found.drive.row: number for number, found in enumerate(views)}
    shades = [robustness_color(step / COLOR_STEPS) for step in range(-COLOR_STEPS, COLOR_STEPS + 1)]
    return {
        "drives": drives,
        "roads": [json.loads(road) for road in roads],
        "shades": shades,
        "table": table_record(results, _units(views), rows),
    }


def _units(views: Sequence[DriveView]) -> Mapping[str, str]:
    """SI units of params, draws and expectations."""
    found: dict[str, str] = {}
    for shown in views:
        found |= shown.drive.scene.units
        found |= {judged.verdict.name: judged.unit for judged in shown.judged}
    return found


def _file(name: str) -> str:
    return (_PAGE / name).read_text(encoding="utf-8")
