"""Scenes driven in the simulators of others: who arrives, and how far off."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from xml.etree.ElementTree import fromstring, parse

from roadlang.ir.scene import Scene
from roadlang_formats.emit_mujoco import MujocoBackend
from roadlang_formats.emit_sumo import SumoBackend

_ROOT = Path(__file__).parents[2]
_DRIVER = _ROOT / "docs" / "examples" / "mujoco_driver.py"
_DRIVES = _ROOT / "tests" / "formats" / "tool_scripts" / "mujoco_drives.py"
_AWAY, _SHARE = 0.5, 0.95
"""Meters from its line that the car of MuJoCo may get, and how much of it it drives at least."""
_OPTIONS = ("--no-step-log", "--end", "3600", "--statistic-output", "statistics.xml")


def driven_in_sumo(program: str | Path, scene: Scene, folder: Path) -> list[str]:
    """Warnings of a run, teleports, collisions, and whether vehicles or persons are missing at its
    end. Files are written into the folder."""
    files = SumoBackend(objects=True).files(scene)
    for ending, content in files.items():
        (folder / f"{scene.stem}.{ending}").write_text(content, encoding="utf-8")
    command = [str(program), "-c", f"{scene.stem}.sumocfg", *_OPTIONS]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    found = [line for line in done.stderr.splitlines() if line.startswith(("Warning", "Error"))]
    if done.returncode:
        return [*found, f"exit {done.returncode}"]
    root = parse(folder / "statistics.xml").getroot()
    numbers = {element.tag: element.attrib for element in root}
    routes = fromstring(files["rou.xml"])
    for tag, statistics in (("vehicle", "vehicles"), ("person", "persons")):
        wanted = len(list(routes.iter(tag)))
        counts = {name: int(count) for name, count in numbers[statistics].items()}
        inside = {name: counts.get(name, 0) for name in ("running", "waiting", "jammed")}
        if counts.get("inserted", counts["loaded"]) != wanted or any(inside.values()):
            found.append(f"{counts} of {wanted} {statistics}")
    for statistics, name in (("teleports", "total"), ("safety", "collisions")):
        if numbers[statistics][name] != "0":
            found.append(f"{numbers[statistics][name]} {statistics}")
    return found


def driven_in_mujoco(python: str | Path, scene: Scene, folder: Path) -> list[str]:
    """Whether the car of a scene leaves its line. `python` has the package `mujoco`."""
    model = folder / "scene.mjcf.xml"
    model.write_text(MujocoBackend().files(scene)["mjcf.xml"], encoding="utf-8")
    question = json.dumps({"driver": str(_DRIVER), "models": [str(model)]})
    command = [str(python), str(_DRIVES)]
    done = subprocess.run(command, input=question, capture_output=True, text=True)
    if done.returncode:
        return [f"MuJoCo: {done.stderr.strip()[-200:]}"]
    ((away, share),) = json.loads(done.stdout.splitlines()[-1]).values()
    if away < _AWAY and share > _SHARE:
        return []
    return [f"MuJoCo: {away:.2f} m from its line, {share:.0%} of it driven"]
