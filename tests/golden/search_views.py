"""What searches, their reports and environments come to, in lines."""

from __future__ import annotations

import csv
import json
import re
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from gymnasium.spaces import Box

from roadlang.envs import EnvSettings, SceneEnv, SceneVectorEnv
from roadlang.plugins.discovery import registry_of
from roadlang.report.report import report
from tests.golden.comparing import SCENES
from tests.golden.scene_views import SEED, drive_lines, loaded, printed
from tests.golden.summaries import array, of_json, of_svg, of_text, runs

_DATA = re.compile(r"<script[^>]*application/json[^>]*>(.*?)</script>", re.DOTALL)
_PICTURE = re.compile(r"<svg.*?</svg>", re.DOTALL)
_SCRIPT = re.compile(r"<(script|style).*?</\1>", re.DOTALL)


def _jsonable(value: Any) -> Any:
    return json.loads(json.dumps(value, default=lambda v: getattr(v, "__dict__", None) or str(v)))


def search_lines(name: str, worst: bool, **options: Any) -> Iterator[str]:
    """A search: its rows, statistics and failures, with `worst` all about the first of these."""
    found = loaded(name).falsify(seed=SEED, **options)
    yield repr(found)
    yield from of_json(_jsonable(found.rows()), "row")
    yield f"rate: {found.rate}"
    for key, coverage in found.coverage.items():
        yield f"coverage {key}: {coverage}"
    for key, best in found.best.items():
        yield f"best {key}: {array([float(v) for pair in best for v in pair])}"
    for failure in found.failures[:4]:
        yield f"failure: {failure!r}"
    if worst:
        failure = found.failures[0]
        yield from drive_lines(failure.drive)
        yield f"explained: {failure.explain()}"
        shrunk = failure.shrink()
        yield f"shrunk: {shrunk!r}"
        yield from of_json(_jsonable(dict(shrunk.scene.draws)), "shrunk")


def command_lines(*words: str) -> Iterator[str]:
    """What `roadlang run` or `falsify` prints of `search.rl`, its files, and their page."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        command, *rest = words
        yield from printed(command, str(SCENES / "search.rl"), "-o", str(out), *rest)
        yield from folder_lines(out)


def folder_lines(folder: Path) -> Iterator[str]:
    """The files of a folder of results, and the page of `roadlang report`."""
    traces = sorted(folder.rglob("*.trace.csv"))
    for file in sorted(folder.rglob("*")):
        yield f"file {file.relative_to(folder)}"
        if file.suffix == ".csv" and file not in traces[1:]:
            yield from table_lines(file.read_text(encoding="utf-8"))
    yield from page_lines(report(folder, registry_of({})))


def table_lines(text: str) -> Iterator[str]:
    """A line for each column of a table."""
    head, *rows = csv.reader(text.splitlines())
    for index, name in enumerate(head):
        column = [row[index] for row in rows]
        try:
            yield f"  {name}: {array([float(value or 'nan') for value in column])}"
        except ValueError:
            yield f"  {name}: {' '.join(runs(column))}"


def page_lines(page: str) -> Iterator[str]:
    """The words, pictures and data of a page."""
    for data in _DATA.findall(page):
        yield from of_json(json.loads(data), "data")
    for picture in _PICTURE.findall(page):
        yield from of_svg(picture)
    rest = _PICTURE.sub("<svg/>", _SCRIPT.sub("", page))
    yield from (line.strip() for line in of_text(rest.replace("><", ">\n<")) if line.strip())


def environment_lines(name: str, **settings: Any) -> Iterator[str]:
    """Ten seconds of an environment under actions that are the same each time."""
    env = SceneEnv(loaded(name), EnvSettings(**settings))
    for space in (env.observation_space, env.action_space):
        assert isinstance(space, Box)
        yield f"from {array(space.low.tolist())} to {array(space.high.tolist())}"
    observed, info = env.reset(seed=SEED)
    rows, rewards = [observed], []
    for step in range(250):
        action = np.array([0.2 * np.sin(step / 9), 0.2 + 0.8 * np.cos(step / 20)], dtype=np.float32)
        observed, reward, terminated, truncated, info = env.step(action)
        rows.append(observed)
        rewards.append(reward)
        if terminated or truncated:
            yield f"ended after {step + 1} steps: {terminated} {truncated}"
            break
    for index, column in enumerate(np.array(rows, dtype=float).T):
        yield f"observation {index}: {array(column.tolist())}"
    yield f"rewards: {array([float(r) for r in rewards])}"
    yield from of_json(_jsonable(info), "info")


def vector_lines(name: str, count: int, **settings: Any) -> Iterator[str]:
    """Environments side by side."""
    env = SceneVectorEnv(loaded(name), count, EnvSettings(**settings))
    observed, _ = env.reset(seed=SEED)
    total = np.zeros(count)
    for step in range(120):
        angles = 0.1 * np.sin(step / 9 + np.arange(count))
        actions = np.stack([angles, np.full(count, 0.7)], axis=1).astype(np.float32)
        observed, rewards, ended, cut, info = env.step(actions)
        total += rewards
        if np.any(ended) or np.any(cut):
            yield f"step {step}: ended {ended.tolist()} cut {cut.tolist()} {sorted(info)}"
    yield f"observed: {array(observed.astype(float).ravel().tolist())}"
    yield f"rewards: {array(total.tolist())}"
