"""A worker that is killed while it writes a result."""

from __future__ import annotations

import multiprocessing
import os
import subprocess
import sys
from pathlib import Path

import pytest

from roadlang.search.worker_processes import _Results

SCRIPT = """
import os, signal, sys, time
from multiprocessing.connection import Connection
from pathlib import Path
from roadlang.search import worker_processes
from roadlang.search.worker_pool import WorkerPool, Workers

worker_processes._LOOK = 0.1


def cut_off(folder, job):
    if job == 1 and not (folder / "cut").exists():
        (folder / "cut").touch()

        def send(self, content, write=os.write):
            write(self.fileno(), bytes(content)[:2])
            os.kill(os.getpid(), signal.SIGKILL)

        Connection._send = send
    if job == 4:  # longer than it takes to see that a process died
        time.sleep(1.0)
    return job * 11


if __name__ == "__main__":
    with WorkerPool(Path(sys.argv[1]), Workers(2)) as pool:
        print([*pool.map(cut_off, range(6))])
"""


@pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")
def test_its_job_is_done_again(tmp_path: Path) -> None:
    """The executor itself would wait for the rest forever."""
    script = tmp_path / "cut_off.py"
    script.write_text(SCRIPT)
    command = [sys.executable, str(script), str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert (tmp_path / "cut").exists()
    assert done.stdout == "[0, 11, 22, 33, 44, 55]\n", done.stderr


def test_a_python_without_a_known_end_for_writing_does_not_fail(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The end for writing is a private attribute of the standard library."""
    results = _Results(ctx=multiprocessing.get_context())
    results.write_no_more()
    results.write_no_more()
    monkeypatch.delattr(results, "_writer")
    results.write_no_more()
