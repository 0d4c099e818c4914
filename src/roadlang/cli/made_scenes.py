"""Scenes of a scene file, for the commands that drive or show them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from .scene_files import read_scene_file

if TYPE_CHECKING:
    from ..ir.scenario import Scenario
    from ..ir.scene import Scene
    from ..plugins.registry import Registry


@dataclass(frozen=True)
class MadeScenes:
    """`warnings`: what the check had to say beside errors."""

    scenario: Scenario
    registry: Registry
    scenes: tuple[Scene, ...]
    warnings: tuple[Diagnostic, ...]


def make_scenes(
    file: str,
    overrides: dict[str, str],
    count: int | None = None,
    seed: int = 0,
    text: str | None = None,
) -> MadeScenes:
    """Check a file, or `text` in its place, and make its scenes.

    Raises `DiagnosticError` where there is none to have.
    """
    from ..plugins.discovery import load_registry
    from ..scenes.sampling import sample_scenes
    from ..semantics import check_text

    registry = load_registry()
    written = read_scene_file(file) if text is None else text
    scenario, found = check_text(written, Path(file), overrides, registry)
    if scenario is None or any(diagnostic.is_error for diagnostic in found):
        raise DiagnosticError(*found)
    result = sample_scenes(scenario, registry, count, seed, 1, None, overrides)
    if not result.scenes:
        if result.impossible:
            which = "; ".join(result.impossible)
            raise DiagnosticError(diagnose(Code.IMPOSSIBLE_REQUIREMENTS, path=file, which=which))
        raise DiagnosticError(
            diagnose(Code.NO_SCENE_FOUND, path=file, tried=f"{result.candidates:,}")
        )
    return MadeScenes(scenario, registry, tuple(result.scenes), tuple(found))
