"""What a compilation wrote, from what, and how the requirements fared."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

MANIFEST_FILE = "manifest.json"
MANIFEST_SCHEMA = "roadlang.manifest/2"


@dataclass(frozen=True, slots=True)
class OutputFile:
    """A file next to the manifest. `scene` is None for what was written once for all scenes."""

    path: str
    """beside the manifest"""
    sha256: str
    """of its contents"""
    bytes: int
    """its size"""
    backend: str
    """the kind that wrote it"""
    scene: int | None = None
    """number of the scene; null for what was written once for all"""


@dataclass(frozen=True, slots=True)
class RequirementRecord:
    """How often a requirement was tested and refused a candidate."""

    name: str
    """as declared"""
    text: str
    """the formula"""
    tested: int
    """candidates tested"""
    rejected: int
    """candidates that it rejected"""
    best_robustness: float | None = None
    """of the candidates tested; null where it was not computed, or only of rejected ones while
    bounds accepted others"""


@dataclass(frozen=True, slots=True)
class Manifest:
    """All of one run of `roadlang compile`. It does not depend on `--jobs`."""

    name: str
    """of the scenario"""
    title: str
    """of the scenario"""
    roadlang: str
    """version"""
    source: str
    """the scene file"""
    seed: int
    """of the run"""
    scenes: int
    """made"""
    requested: int
    """scenes requested"""
    candidates: int
    """tried"""
    diversity: float | None = None
    """mean distance of each scene's draws to the nearest other, in the unit cube of all draws; null
    for one scene"""
    expected_diversity: float | None = None
    """the same of as many even draws in a cube of the volume that the requirements leave"""
    inputs: Mapping[str, str] = field(default_factory=dict)
    """sha256 by path as written, the scene file and its includes among them"""
    plugins: Mapping[str, str] = field(default_factory=dict)
    """version by distribution"""
    overrides: Mapping[str, str] = field(default_factory=dict)
    """params set by the user, as written"""
    requirements: tuple[RequirementRecord, ...] = ()
    """how each fared"""
    files: tuple[OutputFile, ...] = ()
    """all that was written"""
    schema: str = MANIFEST_SCHEMA
    """version of this format"""
