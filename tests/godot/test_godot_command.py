"""`roadlang godot`: an engine that listens until it is ended."""

from __future__ import annotations

import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from roadlang_godot.engines import engine as engines
from tests.godot.godot_engines import require_engine

pytestmark = [
    pytest.mark.godot,
    pytest.mark.skipif(sys.platform != "linux", reason="looks at the processes of Linux"),
]


def _children(pid: int) -> Iterator[list[str]]:
    """The command lines of a process's children."""
    for task in Path(f"/proc/{pid}/task").glob("*/children"):
        for child in task.read_text().split():
            command = Path(f"/proc/{child}/cmdline").read_bytes().split(b"\0")
            yield [word.decode() for word in command]


def _heeds_ctrl_c() -> None:
    """Tests that a script runs in the background inherit a SIGINT that is ignored."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def test_it_listens_without_a_window_where_it_is_told_to(tmp_path: Path) -> None:
    require_engine()
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [sys.executable, "-u", "-m", "roadlang", "godot", "--headless"]
    command += ["--port", str(port), "--transport", "websocket"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, preexec_fn=_heeds_ctrl_c)
    try:
        assert process.stdout is not None
        line = process.stdout.readline()
        assert line == f"Godot listens on 127.0.0.1:{port} (websocket); Ctrl-C stops it\n"
        (engine,) = (words for words in _children(process.pid) if str(engines.project()) in words)
        assert "--headless" in engine
        after = engine[engine.index("--") + 1 :]
        assert after[after.index("--port") + 1] == str(port)
        assert after[after.index("--transport") + 1] == "websocket"
        assert "--quit-idle" not in after
        process.send_signal(signal.SIGINT)
        assert process.wait() == 130
    finally:
        process.kill()
        process.wait()
