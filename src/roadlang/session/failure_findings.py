"""What `roadlang shrink` and `roadlang explain` find of a failure, as files beside it."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any

from ..files.writing import write_all, write_file
from ..ir.result_files import EXPLANATION, SCENE, SHRUNK, is_scene_file_name
from ..report.units import robustness_unit
from .falsification import Failure

EXPLANATION_SCHEMA = "roadlang.explanation/1"


def write_shrunk(simple: Failure, file: Path, target: Path | None = None) -> Path:
    """Write the simplest scene that still fails, and its figure, beside the `file` of the failure
    or into `target`, whose name ends in `.json` then. Raises `DiagnosticError` RL460."""
    path = (_beside(file, SHRUNK) if target is None else target).absolute()
    if not is_scene_file_name(path.name):  # `run` reads anything else as a scene file
        path = path.with_name(path.name + SCENE)
    figure = path.with_suffix(".svg").name
    write_all(path.parent, {path.name: simple.scene.to_json(), figure: simple.drive.svg()})
    return path


def reported_draws(failure: Failure) -> list[str]:
    """The draws that are not at their simplest values."""
    places = zip(failure.axes, failure.outcome.point, failure.simplest, strict=True)
    return [name for name, at, simplest in places if at != simplest]


def explanation(failure: Failure) -> dict[str, Any]:
    """Which draws matter, the most important first, and the moment it went wrong."""
    outcome = failure.outcome
    name = outcome.violated[0]
    return {
        "schema": EXPLANATION_SCHEMA,
        "expectation": name,
        "text": failure.scene.expectations[name].text,
        "robustness": outcome.expectations[name],
        "unit": unit_of(failure),
        "moment": None if outcome.moment is None else dataclasses.asdict(outcome.moment),
        "medians": [dataclasses.asdict(found) for found in failure.influences],
    }


def unit_of(failure: Failure) -> str:
    """The unit of the robustness of what is violated; empty where it has none."""
    verdict = failure.scene.expectations[failure.outcome.violated[0]]
    return robustness_unit(verdict, failure.scene.registry)


def write_explanation(record: dict[str, Any], file: Path) -> Path:
    """Write an explanation beside the `file` of the failure. Raises `DiagnosticError` RL460."""
    text = json.dumps(record, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    return write_file(_beside(file, EXPLANATION).absolute(), text)


def _beside(file: Path, ending: str) -> Path:
    return file.with_name(file.stem + ending)
