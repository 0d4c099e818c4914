"""How commands end when the world fails: closed pipes, full devices, signals, bugs."""

from __future__ import annotations

import io
import subprocess
import sys
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path
from typing import Any

import pytest

from roadlang.cli.machine_faults import machine_fault
from tests.cli.command_lines import roadlang


def test_a_closed_pipe_ends_quietly(tmp_path: Path) -> None:
    done = subprocess.run(
        ["bash", "-c", f"{sys.executable} -m roadlang schema scenario | head -n 1"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
    )
    assert done.stdout == "{\n"
    assert done.stderr == ""


def test_an_interruption_ends_quietly(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from roadlang.cli import explain
    from roadlang.cli.main import run

    def interrupted() -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(explain, "codes", interrupted)
    assert run(["explain"]) == 130
    assert capsys.readouterr().err.strip() == "interrupted"


def test_a_bug_that_was_never_raised_has_no_place() -> None:
    from roadlang.cli.bug import describe_bug

    assert "an unknown place" in str(describe_bug(ValueError("one\ntwo")))


def test_a_bug_is_a_short_report_and_exit_70(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from roadlang.cli import explain
    from roadlang.cli.main import run

    def broken() -> None:
        raise RuntimeError("the moon is full" + 400 * "~")

    monkeypatch.setattr(explain, "codes", broken)
    assert run(["explain"]) == 70
    words = capsys.readouterr().err
    assert "RL900" in words
    assert "the moon is full" in words
    assert words.count("~") == 300 - len("RuntimeError: the moon is full")
    assert "Traceback" not in words
    monkeypatch.setenv("ROADLANG_TRACEBACK", "1")
    with pytest.raises(RuntimeError):
        run(["explain"])


@pytest.mark.parametrize("words", ["schema scene", "explain", "compile scene.rl --json", "--help"])
def test_a_full_device_behind_standard_output_is_said(words: str, folder: Path) -> None:
    with open("/dev/full", "w") as full:
        command = [sys.executable, "-m", "roadlang", *words.split()]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, cwd=folder)
    assert done.returncode == 2
    assert "RL927" in done.stderr
    assert "standard output" in done.stderr
    assert "Traceback" not in done.stderr
    assert "Exception ignored" not in done.stderr


@pytest.mark.parametrize("closed", [">&-", "2>&-", "<&- >&- 2>&-"])
def test_closed_streams_change_nothing(closed: str, folder: Path) -> None:
    """As some daemons start their jobs."""
    line = f"{sys.executable} -m roadlang compile scene.rl -o out {closed}"
    done = subprocess.run(["bash", "-c", line], capture_output=True, text=True, cwd=folder)
    assert (done.returncode, "Traceback" in done.stderr) == (0, False)
    assert (folder / "out" / "manifest.json").exists()


@pytest.mark.parametrize(
    ("error", "says"),
    [
        (OSError(28, "No space left on device", "a.json"), ("a.json", "no space left on device")),
        (OSError(122, "Disk quota exceeded"), ("standard output", "disk quota exceeded")),
        (OSError(5, None, "b.json"), ("b.json", "no room")),
    ],
)
def test_what_has_no_room_and_why_is_said(error: OSError, says: tuple[str, str]) -> None:
    found = machine_fault(error)
    assert found is not None
    assert all(part in found.message for part in says)


@pytest.mark.parametrize(
    ("error", "code", "status"),
    [
        (MemoryError(), "RL933", 5),
        (ImportError("libx.so: failed to map segment from shared object"), "RL933", 5),
        (OSError(28, "No space left on device", "a.json"), "RL927", 2),
        (BrokenProcessPool("ended abruptly"), "RL934", 5),
        (OSError(2, "No such file"), "RL900", 70),
        (ValueError("no number"), "RL900", 70),
    ],
)
def test_what_the_machine_refuses_is_no_bug(
    error: Any,
    code: str,
    status: int,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    from roadlang.cli import explain
    from roadlang.cli.main import run

    def refused() -> None:
        raise error

    monkeypatch.setattr(explain, "codes", refused)
    assert run(["explain"]) == status
    assert f"[{code}]" in capsys.readouterr().err


def test_little_memory_leaves_nothing_written(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from roadlang_standard.emit_svg import Svg

    def drawn(self: Svg, scene: object) -> None:
        bytearray(1 << 62)

    monkeypatch.setattr(Svg, "files", drawn)
    done = roadlang("compile", "scene.rl", "-o", "out", cwd=folder)
    assert (done.returncode, "too little memory" in done.stderr) == (5, True), done.stderr
    assert not (folder / "out").exists()


def test_what_libraries_in_c_print_does_not_mix_with_results() -> None:
    program = (
        "import os\n"
        "from roadlang.cli.standard_output import claim_standard_output\n"
        "claim_standard_output()\n"
        "os.write(1, b'a library\\n')\n"
        "print('a result', flush=True)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("a result\n", "a library\n")


def test_standard_output_that_is_no_file_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """As in a notebook, or in a test."""
    from roadlang.cli.standard_output import claim_standard_output

    ours = io.StringIO()
    monkeypatch.setattr(sys, "stdout", ours)
    claim_standard_output()
    assert sys.stdout is ours
