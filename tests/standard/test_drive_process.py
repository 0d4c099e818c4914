"""Programs that drive: their lines, and how everything that can go wrong with them ends."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path
from typing import Any

import pytest

import roadlang
from roadlang import testing
from roadlang.diagnostics import Diagnostic
from roadlang_standard.process.program import ControllerProcess, ProgramFailed

GREETING = 'print(json.dumps({"protocol": "roadlang.drive/1"}), flush=True)'
GOOD = """
    sys.stdin.readline()
    GREET
    for line in sys.stdin:
        seen = json.loads(line)
        answer = {"steering": 0.08 * seen["path"][1][1], "acceleration": 5.0 - seen["speed"]}
        print(json.dumps(answer), flush=True)
"""


def program(folder: Path, body: str, name: str = "program.py") -> Path:
    path = folder / name
    text = textwrap.dedent(body).replace("GREET", GREETING)
    path.write_text(f"import json, os, sys, time\n{text}")
    return path


def scene(path: Path, options: str = "", others: str = "") -> str:
    command = json.dumps([sys.executable, str(path)])
    if "timeout" not in options:
        options += ", timeout: 100s"  # a busy machine is no fault
    return f"""
    road main {{ draw with waypoints {{ points: [(0m, 0m), (60m, 10m), (120m, 0m)] }}, width: 8m }}
    agent ego is car on main at 5m {{ drive with process {{ command: {command}{options} }} }}
    {others}
    expect near: always (abs(ego.cross_track_error) < 2m)
    """


def written(fault: Diagnostic) -> str:
    """What the file has where a fault is shown."""
    assert fault.span is not None
    return fault.span.source.text[fault.span.start : fault.span.end]


def driven(text: str, n: int = 1, **options: Any) -> Any:
    return testing.sample(text, n).run("builtin", duration=5.0, **options)


def test_a_program_drives(tmp_path: Path) -> None:
    for drive in driven(scene(program(tmp_path, GOOD)), 3):
        ego = drive.trace.agents["ego"]
        assert ego.speed[-1] == pytest.approx(5.0, abs=0.3)
        assert drive.verdicts["near"].satisfied


def test_what_a_program_is_told(tmp_path: Path) -> None:
    body = """
        with open("LOG", "w") as log:
            log.write(sys.stdin.readline())
            GREET
            log.write(sys.stdin.readline())
            log.flush()
            print(json.dumps({"steering": 0.0, "acceleration": 0.0}), flush=True)
            for line in sys.stdin:
                print(json.dumps({"steering": 0.0, "acceleration": 0.0}), flush=True)
    """.replace("LOG", str(tmp_path / "log"))
    other = "agent other is car on main at 25m { drive with stanley { speed: 3m/s } }"
    driven(scene(program(tmp_path, body), others=other))
    greeting, first = map(json.loads, (tmp_path / "log").read_text().splitlines())
    assert greeting["protocol"] == "roadlang.drive/1"
    assert greeting["agent"] == "ego"
    assert greeting["distances"] == [5.0, 10.0, 20.0, 30.0, 50.0]
    assert first["time"] == 0.0
    assert first["road_width"] == pytest.approx(8.0)
    assert first["speed_limit"] is None
    assert len(first["path"]) == 5
    assert first["path"][0][0] == pytest.approx(5.0, abs=0.1)
    assert first["others"][0]["ahead"] == pytest.approx(20.0, abs=1.0)


FAILING = {
    "it ended with code 3": 'print("no such model", file=sys.stderr)\nsys.exit(3)',
    "did not answer within 0.3 s": """
        sys.stdin.readline()
        GREET
        time.sleep(60)
    """,
    """has to be {"protocol": "roadlang.drive/1"}, not 'ready'""": """
        print("ready", flush=True)
        time.sleep(60)
    """,
    "it sent back the line it was given": "for line in sys.stdin: print(line, end='', flush=True)",
    "its first line has to be": 'print("{}", flush=True)\ntime.sleep(60)',
    "is not a JSON object: 'ready'": """
        sys.stdin.readline()
        GREET
        sys.stdin.readline()
        print("ready", flush=True)
        time.sleep(60)
    """,
    "`steering` has to be a finite number": """
        sys.stdin.readline()
        GREET
        for line in sys.stdin:
            print('{"steering": NaN, "acceleration": 0}', flush=True)
    """,
    "`acceleration` has to be a finite number": """
        sys.stdin.readline()
        GREET
        for line in sys.stdin:
            print('{"steering": 0}', flush=True)
    """,
    "longer than 65536 bytes": 'print("x" * 1000000, flush=True)\ntime.sleep(60)',
    "instead of answering": """
        sys.stdin.readline()
        GREET
        sys.stdin.readline()
        sys.stdout.close()
        os.close(1)
        time.sleep(60)
    """,
}


@pytest.mark.parametrize("reason", FAILING)
def test_what_goes_wrong_is_an_error_with_the_reason(tmp_path: Path, reason: str) -> None:
    path = program(tmp_path, FAILING[reason])
    with pytest.raises(roadlang.DiagnosticError) as found:
        driven(scene(path, ", timeout: 300ms" if "0.3 s" in reason else ""))
    assert "error[RL740]" in str(found.value)
    assert reason in str(found.value)
    assert "Traceback" not in str(found.value)
    assert "it drives `ego` and failed 0.00 s into the drive" in str(found.value)


def test_a_program_that_keeps_its_first_answer_is_told_to_flush(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("roadlang_standard.drive_process.START", 0.3)
    body = """
        sys.stdin.readline()
        time.sleep(60)
    """
    with pytest.raises(roadlang.DiagnosticError) as found:
        driven(scene(program(tmp_path, body)))
    assert "it did not answer within 0.3 s" in str(found.value)
    assert "flush its standard output after each line" in str(found.value)
    assert "current folder" not in str(found.value)


def test_a_program_that_writes_more_than_its_answers_is_an_error(tmp_path: Path) -> None:
    """Every later answer would be to what the agent saw before."""
    body = """
        sys.stdin.readline()
        GREET
        for line in sys.stdin:
            answer = '{"steering": 0, "acceleration": 1}'
            print(answer + "\\n" + answer, flush=True)
    """
    for _ in range(5):  # at once, however busy the machine is
        with pytest.raises(roadlang.DiagnosticError, match="without being asked") as found:
            driven(scene(program(tmp_path, body)))
        assert "failed 0.04 s into the drive" in str(found.value)


def test_a_program_that_ended_before_it_was_written_to_is_named_with_its_code() -> None:
    ended = ControllerProcess([sys.executable, "-c", "raise SystemExit(3)"])
    ended._process.wait()
    with pytest.raises(ProgramFailed, match="it ended with code 3"):
        ended.send("{}")


def test_the_error_has_the_end_of_standard_error(tmp_path: Path) -> None:
    body = 'print("\\n".join(f"line {i}" for i in range(500)), file=sys.stderr)\nint("x")'
    with pytest.raises(roadlang.DiagnosticError) as found:
        driven(scene(program(tmp_path, body)))
    assert "ValueError: invalid literal for int()" in str(found.value)
    assert "line 100" not in str(found.value)


def test_the_error_has_only_the_beginning_of_a_very_long_line(tmp_path: Path) -> None:
    body = """
    print("file.js:1", "x" * 40000, "TypeError: no road", sep="\\n", file=sys.stderr)
    sys.exit(1)
    """
    with pytest.raises(roadlang.DiagnosticError) as found:
        driven(scene(program(tmp_path, body)))
    text = str(found.value)
    assert "file.js:1" in text
    assert "xxx ..." in text
    assert "TypeError: no road" in text
    assert len(text) < 2000


def test_the_error_is_shown_where_the_program_is_written(tmp_path: Path) -> None:
    path = tmp_path / "missing.py"
    text = scene(path) + "agent other is car on main at 40m { drive with brake }"
    with pytest.raises(roadlang.DiagnosticError) as found:
        driven(text, 2)
    (fault,) = found.value.diagnostics
    assert written(fault).startswith("drive with process")


def test_of_two_agents_with_one_program_no_place_is_shown(tmp_path: Path) -> None:
    """The help says which of the two it is; the place could be that of the other."""
    path = tmp_path / "missing.py"
    command = json.dumps([sys.executable, str(path)])
    other = f"""agent other is car on main at 40m {{
      drive with process {{ command: {command}, timeout: 100s }}
    }}"""
    with pytest.raises(roadlang.DiagnosticError) as found:
        driven(scene(path, others=other))
    (fault,) = found.value.diagnostics
    assert fault.span is None


def test_a_command_that_is_not_there() -> None:
    text = scene(Path("x.py")).replace(sys.executable, "/nowhere/driver")
    with pytest.raises(roadlang.DiagnosticError, match="cannot be started: No such file"):
        driven(text)


def test_a_command_line_in_one_text_is_shown_word_by_word() -> None:
    with pytest.raises(ProgramFailed, match=r'; write \["python3", "x.py"\]: each word by itself'):
        ControllerProcess(["python3 x.py"])


def test_the_agent_may_brake_instead_and_the_others_go_on(tmp_path: Path) -> None:
    body = GOOD + "        if seen['time'] > 2.0: sys.exit('no road')\n"
    good = json.dumps([sys.executable, str(program(tmp_path, GOOD, "good.py"))])
    other = f"agent other is car on main at 40m {{ drive with process {{ command: {good} }} }}"
    text = scene(program(tmp_path, body), ", brake_on_failure: true", other)
    (drive,) = driven(text)
    assert drive.trace.agents["ego"].speed[-1] == 0.0
    assert drive.trace.agents["other"].speed[-1] == pytest.approx(5.0, abs=0.3)
    (failure,) = drive.trace.controller_failures
    assert failure.agent == "ego"
    assert failure.time == pytest.approx(2.08, abs=0.05)
    assert "it ended with code 1" in failure.summary
    assert failure.summary.endswith("no road")


@pytest.mark.parametrize("body", [None, "raise SystemExit(3)"])
def test_a_program_that_never_drove_is_an_error_although_agents_may_brake(
    tmp_path: Path, body: str | None
) -> None:
    path = tmp_path / "missing.py" if body is None else program(tmp_path, body)
    with pytest.raises(roadlang.DiagnosticError, match="not in that of the scene file"):
        driven(scene(path, ", brake_on_failure: true"))


def test_the_same_drive_alone_and_beside_others(tmp_path: Path) -> None:
    text = scene(program(tmp_path, GOOD)).replace("at 5m", "at 5m..15m")
    scenes = testing.sample(text, 4)
    together = scenes.run("builtin", duration=5.0)
    alone = scenes[2].run("builtin", duration=5.0)
    assert (together[2].trace.agents["ego"].x == alone.trace.agents["ego"].x).all()


def is_running(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except OSError:
        return False
    state = Path(f"/proc/{pid}/stat")
    return not state.exists() or state.read_text().rsplit(")", 1)[1].split()[0] != "Z"


def ended(pid: int) -> bool:
    for _ in range(3000):
        if not is_running(pid):
            return True
        time.sleep(0.1)
    return False


STUBBORN = """
    with open("PIDS", "a") as pids:
        pids.write(f"{os.getpid()}\\n")
    sys.stdin.readline()
    GREET
    for line in sys.stdin:
        if json.loads(line)["time"] > LIMIT:
            time.sleep(600)
        print(json.dumps({"steering": 0.0, "acceleration": 1.0}), flush=True)
    time.sleep(600)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="looks at processes as POSIX has them")
def test_no_program_outlives_the_drive(tmp_path: Path) -> None:
    pids = tmp_path / "pids"
    body = STUBBORN.replace("PIDS", str(pids)).replace("LIMIT", "100")
    driven(scene(program(tmp_path, body)), 2)
    started = [int(line) for line in pids.read_text().split()]
    assert len(started) == 2
    assert all(ended(pid) for pid in started)


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_no_program_outlives_a_run_that_is_terminated(tmp_path: Path) -> None:
    pids = tmp_path / "pids"
    body = STUBBORN.replace("PIDS", str(pids)).replace("LIMIT", "0.5")
    (tmp_path / "scene.rl").write_text(scene(program(tmp_path, body), ", timeout: 100s"))
    command = [sys.executable, "-m", "roadlang", "run", "scene.rl", "-o", "out"]
    with subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE) as run:
        for _ in range(3000):
            if pids.exists() and pids.read_text().strip():
                break
            time.sleep(0.1)
        time.sleep(0.5)
        run.send_signal(signal.SIGTERM)
        run.wait(300)
    assert all(ended(int(line)) for line in pids.read_text().split())


@pytest.mark.skipif(sys.platform == "win32", reason="looks at processes as POSIX has them")
def test_no_program_outlives_a_run_with_workers_that_fails(tmp_path: Path) -> None:
    """One program fails, and breaks off the drives of the other worker."""
    pids = tmp_path / "pids"
    body = STUBBORN.replace("PIDS", str(pids)).replace("LIMIT", "0.5")
    (tmp_path / "scene.rl").write_text(scene(program(tmp_path, body), ", timeout: 1s"))
    command = [sys.executable, "-m", "roadlang", "run", "scene.rl", "-n", "4", "--jobs", "2"]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert run.returncode == 5
    assert "RL740" in run.stderr
    assert "Traceback" not in run.stderr
    assert all(ended(int(line)) for line in pids.read_text().split())
