"""What esmini plays of `emit openscenario`: `python -m benchmarks.formats.esmini --esmini PROGRAM`.

Scenes are the examples and random networks with traffic, 15 s each. A vehicle is on its lane while
it is as far from the middle of a lane as it was at the start; no package of esmini exists: build
its source with `cmake -DUSE_OSG=OFF -DUSE_OSI=OFF -DUSE_SUMO=OFF -DUSE_GTEST=OFF -DUSE_IMPLOT=OFF`.
"""

from __future__ import annotations

import argparse
import csv
import itertools
import re
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

from roadlang.ir.scene import Scene
from roadlang_formats.emit_openscenario import OpenScenarioBackend

from .corpus import example_scenes, random_scenes

_SECONDS = 15.0
_AWAY = 0.5
"""Meters from where a vehicle was across its lane, from which on it has left it."""
_VEHICLES = {"car", "van", "bus", "truck", "motorcycle", "bicycle"}


def main() -> None:
    """Prints what left its lane, and the counts."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--esmini", required=True, type=Path, help="the program")
    parser.add_argument("--networks", type=int, default=1, help="of each kind")
    parser.add_argument("--seed", type=int, default=3)
    options = parser.parse_args()
    scenes = itertools.chain(
        example_scenes(options.seed),
        random_scenes(options.networks, options.seed, with_traffic=True),
    )
    played, vehicles, gone, worst = 0, 0, 0, 0.0
    for name, scene in scenes:
        if not scene.agents:
            continue
        away = moved_across(options.esmini.resolve(), scene)
        played += 1
        vehicles += len(away)
        left = {agent: round(far, 2) for agent, far in away.items() if far > _AWAY}
        gone += len(left)
        worst = max(worst, *away.values(), 0.0)
        if left:
            print(f"  {name}: {left}", flush=True)
    print(f"{played} scenes, {vehicles} vehicles, {gone} left their lanes, {worst:.2f} m at most")


def moved_across(program: Path, scene: Scene) -> dict[str, float]:
    """By vehicle, how far it got from its first offset across its lanes, meters. Raises
    CalledProcessError where esmini fails, and ValueError where it ends too early."""
    with tempfile.TemporaryDirectory() as folder:
        for ending, text in OpenScenarioBackend().files(scene).items():
            (Path(folder) / f"{scene.stem}.{ending}").write_text(text, encoding="utf-8")
        file, log = Path(folder) / f"{scene.stem}.xosc", Path(folder) / "log.csv"
        head, stop, tail = file.read_text(encoding="utf-8").rpartition("<StopTrigger")
        tail = re.sub(r'value="[^"]*"', f'value="{_SECONDS:g}"', tail, count=1)
        file.write_text(head + stop + tail, encoding="utf-8")
        command = [str(program), "--osc", file.name, "--headless", "--fixed_timestep", "0.05"]
        command += ["--csv_logger", str(log), "--disable_stdout"]
        subprocess.run(command, check=True, cwd=folder, capture_output=True, timeout=600)
        rows = list(csv.reader(log.open(encoding="utf-8")))
    driving = {agent.name for agent in scene.agents if agent.category in _VEHICLES}
    first: dict[str, float] = {}
    found: dict[str, float] = {}
    last = 0.0
    for time, name, offset in _offsets(rows):
        last = max(last, time)
        if name in driving:
            first.setdefault(name, offset)
            found[name] = max(found.get(name, 0.0), abs(offset - first[name]))
    if last < _SECONDS - 0.1:
        raise ValueError(f"esmini played {last:g} s alone")
    return found


def _offsets(rows: list[list[str]]) -> Iterator[tuple[float, str, float]]:
    """Time, agent, and its offset from the middle of a lane, meters, of each row of a log."""
    start = next(place for place, row in enumerate(rows) if row and row[0].startswith("Index"))
    names = [re.sub(r"^ ?#\d+ ?", "", column).strip() for column in rows[start]]
    at = [place for place, name in enumerate(names) if name.startswith("Entity_Name")]
    offset = names.index("lane_offset[m]") - at[0]
    for row in rows[start + 1 :]:
        for place in at:
            if place + offset < len(row) and row[place].strip():
                yield float(row[1]), row[place].strip(), float(row[place + offset])


if __name__ == "__main__":
    main()
