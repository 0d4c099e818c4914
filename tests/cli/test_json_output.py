"""JSON that people read: what commands print and write is indented, and ends with a line break."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.command_lines import roadlang

TITLE = "Caf\N{LATIN SMALL LETTER E WITH ACUTE}"
SCENE = """scenario cafe "TITLE"
road main { draw with segments { pieces: [straight(90m)] } }
agent ego is car on main at 9m..20m { drive with lane_follow { speed: 9m/s } }
expect slow: always (ego.speed < 8m/s)
simulate with builtin { duration: 1s, step: 0.2s }
"""
FAULTY = "road main { draw with segments { pieces: [straight(90s)] } }\n"
COMMANDS = {
    "check": "check faulty.rl --json",
    "check --scenario": "check scene.rl --scenario",
    "plugins": "plugins --verb piece --json",
    "plugins show": "plugins show car --json",
    "schema": "schema json",
    "compile": "compile scene.rl -o c -n 2 --json",
    "compile of a faulty file": "compile faulty.rl -o c --json",
    "run": "run scene.rl -o r --json",
    "falsify": "falsify scene.rl -o f --evaluations 4 --batch 4 --json",
    "monitor": "monitor (ego.speed<8) r/scene-0000.trace.csv --json",
    "mine": "mine always(ego.speed<top) r/scene-0000.trace.csv --param top=0..40 --json",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("documents")
    (place / "scene.rl").write_text(SCENE.replace("TITLE", TITLE), encoding="utf-8")
    (place / "faulty.rl").write_text(FAULTY, encoding="utf-8")
    return place


def test_what_commands_print_and_write(folder: Path) -> None:
    for name, line in COMMANDS.items():
        printed = roadlang(*line.split(), cwd=folder).stdout
        assert printed == json.dumps(json.loads(printed), indent=2) + "\n", name
    written = sorted(folder.rglob("*.json"))
    assert {path.parent.name for path in written} >= {"c", "r", "f", "failures"}
    for path in written:
        text = path.read_bytes().decode("utf-8")
        assert text.endswith("}\n"), path
        assert '"title"' not in text or TITLE in text, path
        # Traces are long: they are for programs.
        assert text.startswith('{"' if path.name.endswith(".trace.json") else '{\n  "'), path
