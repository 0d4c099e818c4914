"""Files that `read` kinds turn into roads, networks and images."""

from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...diagnostics import Span
from ...evaluate.candidates import fixed_candidate
from ...evaluate.evaluation import build
from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry import Curve, Road, RoadNetwork
from ...ir.picture import Extraction
from ...ir.scenario import FileSource, Input
from ...ir.values import PassCall
from ...plugins.guard import plugin_guard, wrong_result
from ...plugins.registry import KindEntry


@dataclass(frozen=True, eq=False)
class FileContent:
    """What a reader made of a file, and the files that it read with their digests."""

    value: Any
    inputs: tuple[Input, ...]


def read_file(
    source: FileSource,
    reads: str,
    passes: tuple[PassCall, ...],
    scenario: IndexedScenario,
    span: Span | None,
) -> FileContent:
    """What the `read with` among `passes` makes of a file.

    `reads` is what the statement declares: "image", "network" or "road". Raises RL400 and RL401
    for a file that cannot be read, RL474 for a wrong result.
    """
    call = next(call for call in passes if call.verb == "read")
    file = _input_of(source, scenario, call.span or span)
    built = build(call, fixed_candidate(scenario), single=True)
    path = Path(source.resolved)
    place = call.span or span
    with plugin_guard(built.entry, place):
        names = [str(name) for name in built.kind.companions(path)]
    others = [
        FileSource(os.path.join(os.path.dirname(source.path), name), str(path.parent / name))
        for name in names
    ]
    inputs = (file, *(_input_of(other, scenario, place) for other in others))
    with plugin_guard(built.entry, place):
        found = built.kind.read(path)
    _check_content(found, reads, built.entry, place)
    return FileContent(found, inputs)


def _check_content(found: Any, reads: str, entry: KindEntry, span: Span | None) -> None:
    """Raises RL474 where a reader returned what its statement cannot use."""
    if reads == "road":
        fits, expected = isinstance(found, Curve | Road), "a Curve or a Road"
    elif reads == "network":
        fits, expected = isinstance(found, RoadNetwork | Extraction), "a RoadNetwork"
    else:
        fits, expected = (
            _is_picture(found),
            "an array (height, width, 3) or (height, width) of uint8",
        )
    if not fits:
        raise wrong_result(entry, span, f"gave {_described(found)}, not {expected}")


def _is_picture(found: Any) -> bool:
    if not isinstance(found, np.ndarray) or found.dtype != np.uint8 or 0 in found.shape:
        return False
    return found.ndim == 2 or (found.ndim == 3 and found.shape[2] == 3)


def _described(found: Any) -> str:
    if isinstance(found, np.ndarray):
        return f"an array {found.shape} of {found.dtype}"
    return f"a {type(found).__name__}"


def _input_of(source: FileSource, scenario: IndexedScenario, span: Span | None) -> Input:
    """The file with its sha256, read once for all candidates."""

    def make() -> Input:
        from ...images.image_file import read_input  # it loads OpenCV

        content = read_input(Path(source.resolved), source.path, span)
        return Input(source.path, hashlib.sha256(content).hexdigest())

    return scenario.once(("input", source.resolved), make)
