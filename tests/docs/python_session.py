"""A Python that runs the pieces of one program as they come, each once."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

_LOOP = """
import json, os, sys, traceback
answers = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
for piece in sys.stdin:
    fault = ""
    try:
        exec(compile(json.loads(piece), "page", "exec"), sys.modules["__main__"].__dict__)
    except BaseException:
        fault = traceback.format_exc()
    print(json.dumps(fault), file=answers, flush=True)
"""


class PythonSession:
    """A process of Python in a folder."""

    def __init__(self, folder: Path, environment: Mapping[str, str]) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-c", _LOOP],
            cwd=folder,
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )

    def run(self, piece: str) -> str:
        """The traceback of the next piece of the program, or nothing where it succeeds."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps(piece) + "\n")
        self._process.stdin.flush()
        answer = self._process.stdout.readline()
        fault: str = json.loads(answer) if answer else "the process has ended"
        return fault

    def close(self) -> None:
        """The program is over: wait until its process has ended well."""
        self._process.communicate()
        assert self._process.returncode == 0
