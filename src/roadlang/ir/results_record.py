"""Where the results in a folder come from: enough to make them again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

RESULTS_FILE = "provenance.json"
RESULTS_SCHEMA = "roadlang.provenance/1"


@dataclass(frozen=True, slots=True)
class ResultsRecord:
    """Of a folder of `roadlang run` or `roadlang falsify`. It does not depend on `--jobs`."""

    command: str
    """`run` or `falsify`"""
    again: str
    """the command line that makes the same results"""
    name: str
    """of the scenario"""
    title: str
    """of the scenario"""
    source: str
    """the scene file, as it was written on the command line"""
    seed: int | None
    """of the run; null where one concrete scene was driven"""
    roadlang: str
    """version"""
    engine: str | None = None
    """the simulator that was named; null for that of the scene file"""
    options: Mapping[str, Any] = field(default_factory=dict)
    """of the simulator, in place of those of the scene file, SI units"""
    sampler: str = ""
    """the kind that chose the scenes"""
    expects: tuple[str, ...] = ()
    """of a search: the expectations to violate, the most important first"""
    params: Mapping[str, str] = field(default_factory=dict)
    """values of params set by the user, as written"""
    inputs: Mapping[str, str] = field(default_factory=dict)
    """sha256 by path as written, the scene file and its includes among them"""
    plugins: Mapping[str, str] = field(default_factory=dict)
    """version by distribution"""
    schema: str = RESULTS_SCHEMA
    """version of this format"""

    @property
    def is_random_sample(self) -> bool:
        """Whether its scenes were drawn at random, each on its own."""
        return self.sampler.rpartition(".")[2] == "random" and self.seed is not None
