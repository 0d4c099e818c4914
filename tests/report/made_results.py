"""Folders of results for tests: a run and a search, made once."""

from __future__ import annotations

from pathlib import Path

from roadlang.cli.main import run

BEND = """
scenario bend "A bend"
road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (90m, 25m), (90m, 80m)] }, width: 7m }
agent ego is car on main at 5m { drive with pure_pursuit { speed: 6m/s..16m/s } }
agent lead is car on main at 30m { drive with pure_pursuit { speed: 5m/s..9m/s } }
object oak is tree on main at 50m { side: right, offset: 2m..4m }
expect slow: always (ego.speed < 11m/s)
expect apart: always (gap(ego, lead) > 1m)
simulate with builtin { duration: 8s, control_step: 0.1s }
falsify with random { evaluations: 40, random: 0% }
"""  # noqa: E501


def made(command: str, folder: Path, *words: str, text: str = BEND) -> Path:
    """The folder `out` that a command wrote of a scene file in `folder`."""
    source = folder / "bend.rl"
    source.write_text(text, encoding="utf-8")
    run([command, str(source), "-o", str(folder / "out"), *words])
    return folder / "out"
