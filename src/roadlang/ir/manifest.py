"""What a compilation wrote, from what, and how the requirements fared."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

MANIFEST_SCHEMA = "roadlang.manifest/1"


@dataclass(frozen=True, slots=True)
class OutputFile:
    """A file beside the manifest. `scene` is None for what was written once for all scenes."""

    path: str
    sha256: str
    bytes: int
    backend: str
    scene: int | None = None


@dataclass(frozen=True, slots=True)
class RequirementRecord:
    """How often a requirement was tested and refused a candidate."""

    name: str
    text: str
    tested: int
    rejected: int
    best_robustness: float | None = None
    """of the candidates tested; None where none was"""


@dataclass(frozen=True, slots=True)
class Manifest:
    """All of one run of `roadlang compile`. It does not depend on `--jobs`."""

    name: str
    title: str
    roadlang: str
    source: str
    seed: int
    scenes: int
    asked: int
    candidates: int
    inputs: Mapping[str, str] = field(default_factory=dict)
    """sha256 by path as written, the scene file and its includes among them"""
    plugins: Mapping[str, str] = field(default_factory=dict)
    overrides: Mapping[str, str] = field(default_factory=dict)
    requirements: tuple[RequirementRecord, ...] = ()
    files: tuple[OutputFile, ...] = ()
    schema: str = MANIFEST_SCHEMA
