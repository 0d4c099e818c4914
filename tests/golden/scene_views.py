"""What a scene file comes to, in lines: its scenes, figures, files and drives."""

from __future__ import annotations

import contextlib
import io
import json
import tempfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from roadlang import Drive, LoadedScenario, NoSceneError, SceneSet
from roadlang.cli.main import run
from roadlang.plugins.discovery import registry_of
from tests.golden.comparing import SCENES
from tests.golden.summaries import array, of_json, of_svg, of_text

SEED = 5


def loaded(name: str) -> LoadedScenario:
    """The scenario of `scenes/NAME.rl`, with the kinds in the wheel alone."""
    path = SCENES / f"{name}.rl"
    return LoadedScenario(path.read_text(encoding="utf-8"), path, {}, registry_of({}))


@cache
def sampled(name: str, count: int | None) -> SceneSet:
    """Its scenes, also those of a scenario that falls short of `count`: once for many cases."""
    try:
        return loaded(name).sample(count, seed=SEED)
    except NoSceneError as error:
        return error.result


def scene_lines(scenes: SceneSet) -> Iterator[str]:
    """The JSON of every scene, and how they were found."""
    yield f"{len(scenes)} scenes of {scenes.candidates} candidates"
    yield from of_text(scenes.rejection_table)
    for remark in scenes.remarks:
        yield f"remark: {remark}"
    for found in scenes.diagnostics:
        yield f"diagnostic: {found}"
    for expectation in scenes.expectations:
        yield f"expectation: {expectation}"
    first: list[str] = []
    for scene in scenes:
        yield f"--- scene {scene.index}" + (": what differs from the first" if first else "")
        document = json.loads(scene.to_json())
        document.pop("provenance", None)
        lines = list(of_json(document))
        yield from (line for line in lines if line not in first)
        first = first or lines


def figure_lines(scenes: SceneSet, **options: Any) -> Iterator[str]:
    """The figure of the first scene."""
    yield from of_svg(scenes[0].svg(**options))


def drive_lines(drive: Drive) -> Iterator[str]:
    """The columns of a drive, and its verdicts."""
    yield f"{drive.verdict} after {drive.duration:.4g} s"
    for name, column in drive.to_dict().items():
        yield f"{name}: {array([float(v) for v in column])}"
    for name, verdict in drive.verdicts.items():
        said = (verdict.domain, verdict.robustness, verdict.satisfied, verdict.violated)
        yield f"expect {name}: {said}"
    yield f"worst: {drive.worst and drive.worst.name}: {drive.worst_moment}"
    for found in drive.diagnostics:
        yield f"diagnostic: {found}"
    document = json.loads(drive.to_json())
    document.pop("provenance", None)
    yield from of_json({k: v for k, v in document.items() if k not in ("agents", "scene")})


def printed(*words: str) -> Iterator[str]:
    """The exit code of a command, and what it prints; folders are left out."""
    text = io.StringIO()
    with contextlib.redirect_stdout(text), contextlib.redirect_stderr(text):
        code = run(list(words))
    yield f"exit code {code}"
    out = words[words.index("-o") + 1] if "-o" in words else "OUT"
    for line in of_text(text.getvalue()):
        yield line.replace(out, "OUT").replace(str(SCENES), "SCENES")


def console_lines(name: str, *words: str) -> Iterator[str]:
    """What `roadlang compile` prints of a scene file, its files and their manifest."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        yield from printed("compile", str(SCENES / f"{name}.rl"), "-o", str(out), *words)
        for file in sorted(out.rglob("*")) if out.exists() else []:
            yield f"file {file.relative_to(out)}"
        manifest = out / "manifest.json"
        if manifest.exists():
            document = json.loads(manifest.read_text(encoding="utf-8"))
            document.pop("provenance", None)
            yield from of_json(document)
