"""A drive that the page shows: its files, judged again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ..ir.encoding import scene_from_json
from ..ir.result_files import EXPLANATION, SHRUNK
from ..ir.scene import Scene
from ..judging.drives import judge
from ..plugins.registry import Registry
from .explained import FailureExplanation
from .numbers import shown_unit
from .reading import parsed, read_drive, read_typed
from .results import ShownDrive

MOST_FAILING, MOST_SAFE = 100, 12
"""Drives that are shown in full."""
MOST_INFLUENCES = 8
"""Random values, and pairs of them, that are listed with a failure."""


def shown_drive(
    folder: Path,
    name: str,
    label: str,
    row: int,
    has_failed: bool,
    registry: Registry,
    expects: tuple[str, ...] = (),
) -> ShownDrive:
    """The drive with the files `folder/name.*`. Raises `DiagnosticError` RL721."""
    stem = folder / name
    scene, trace = read_drive(stem)
    verdicts = judge(scene, trace, registry).verdicts
    found = _shrunk(stem, scene), _explained(stem)
    return ShownDrive(name, label, row, scene, trace, verdicts, has_failed, expects, *found)


def _shrunk(stem: Path, scene: Scene) -> dict[str, Any] | None:
    """Of the simplest scene that still fails: the draws that are as they were, with their units,
    and how many are not."""
    path = stem.with_name(f"{stem.name}{SHRUNK}")
    if not path.is_file():
        return None
    simple = parsed(path, scene_from_json)
    same = [name for name, value in simple.draws.items() if scene.draws.get(name) == value]
    return {
        "draws": [[name, *_shown(simple.draws[name], scene.units.get(name, ""))] for name in same],
        "others": len(simple.draws) - len(same),
    }


def _explained(stem: Path) -> dict[str, Any] | None:
    path = stem.with_name(f"{stem.name}{EXPLANATION}")
    if not path.is_file():
        return None
    found = read_typed(path, FailureExplanation)
    listed = [*found.singles[:MOST_INFLUENCES], *found.pairs[:MOST_INFLUENCES]]
    medians = [
        (" + ".join(item.draws), _shown(item.robustness, found.unit)[0], item.holds)
        for item in listed
    ]
    return {
        "expectation": found.expectation,
        "unit": shown_unit(found.unit)[1],
        "medians": medians,
        "others": len(found.without_effect),
    }


def _shown(value: Any, unit: str) -> tuple[Any, str]:
    factor, text = shown_unit(unit)
    return (value * factor if isinstance(value, float) else value), text
