"""Scene files of which no scene can be made, as they declare nothing."""

from __future__ import annotations

from pathlib import Path

from ..diagnostics import Code, Diagnostic, diagnose
from ..ir.scenario import Scenario

_START = "`roadlang init FILE` writes a scene file to start with"


def empty_file(scenario: Scenario, path: Path) -> Diagnostic | None:
    """RL116 for a file without roads, images, agents, values and all else that scenes hold."""
    declared = (
        scenario.values,
        scenario.images,
        scenario.networks,
        scenario.roads,
        scenario.signals,
        scenario.requirements,
        scenario.expectations,
        scenario.agents,
        scenario.objects,
        scenario.world,
    )
    if any(declared):
        return None
    return diagnose(Code.EMPTY_SCENE_FILE, path=str(path), where=f"`{path.name}`", help=_START)
