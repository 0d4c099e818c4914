"""Runs tools of other projects for tests, each in an environment of its own.

roadlang's own environment never imports them. A test that needs one is skipped where it cannot be
installed, and fails with ROADLANG_REQUIRE_TOOLS=1. All such tests are `slow`.

    found = ask_tool("carla", "carla_lanes.py", {"files": [str(path) for path in paths]})

runs `tool_scripts/carla_lanes.py` with the Python of `requirements/carla.txt`. The script gets the
question as JSON on its standard input and prints its answer as JSON on its last line. Ask for many
files at once: most tools take seconds to start.
"""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.formats.tool_installation import ToolUnavailableError, installed_tool

_SCRIPTS = Path(__file__).parent / "tool_scripts"
_BYTES = 6_000_000_000
"""Address space of a tool: a file that netconvert cannot take has eaten all memory before now."""
_unavailable: dict[str, str] = {}


def tool_folder(name: str) -> Path:
    """The virtual environment of a tool, or the folder that holds its `node_modules`."""
    if name not in _unavailable:
        try:
            return installed_tool(name)
        except ToolUnavailableError as error:
            _unavailable[name] = f"{name} is not available: {error}"
    if os.environ.get("ROADLANG_REQUIRE_TOOLS", "") not in ("", "0"):
        pytest.fail(_unavailable[name])
    pytest.skip(_unavailable[name])


def tool_python(name: str) -> Path:
    """The Python of a tool's virtual environment."""
    return tool_folder(name) / "bin" / "python"


def tool_program(name: str, program: str) -> Path:
    """A program that a tool installs, such as `netconvert` of `sumo`."""
    return tool_folder(name) / "bin" / program


def run_tool(
    command: list[str | Path], *, stdin: str = "", folder: Path | None = None, seconds: float = 600
) -> subprocess.CompletedProcess[str]:
    """A program with a limit on its memory and time; the caller looks at its exit status."""
    limited = ["sh", "-c", f'ulimit -v {_BYTES // 1000}; exec "$@"', "sh", *map(str, command)]
    environment = {
        key: text for key, text in os.environ.items() if key not in ("PYTHONPATH", "VIRTUAL_ENV")
    }
    return subprocess.run(
        limited,
        input=stdin,
        capture_output=True,
        text=True,
        timeout=seconds,
        cwd=folder,
        env=environment,
    )


def ask_tool(name: str, script: str, question: Any) -> Any:
    """The answer of a script in `tool_scripts/` that runs in the environment of a tool."""
    done = run_tool([tool_python(name), _SCRIPTS / script], stdin=json.dumps(question))
    assert done.returncode == 0, f"{script} failed: {done.stderr[-2000:]}"
    return json.loads(done.stdout.splitlines()[-1])
