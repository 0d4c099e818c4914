"""Finds a Godot engine, and runs the bundled project in it."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
import subprocess
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

from roadlang.api import Code

from ..faults import EngineError, fault
from ..net.link import DatagramLink
from ..net.link_udp import UdpLink
from ..net.session import Session
from ..net.transports import websocket_link
from .engine_log import new_log
from .engine_places import usual_executables

OLDEST = (4, 3)
START_SECONDS = 180.0
ANSWER_TIMEOUT = 120.0
"""Seconds without an answer after which an engine of ours is given up though its process runs: on a
busy machine it may get little time, and drawing in software takes seconds in which it answers
nobody. Where the process ends, nobody waits that long."""

_KILL = getattr(signal, "SIGKILL", signal.SIGTERM)
_KILLED = {code for number in (_KILL, signal.SIGTERM) for code in (-number, 128 + number)}
"""Exit codes of a process that was killed, and of a virtual screen's whose engine was."""
_VARIABLE = "ROADLANG_GODOT"
_LISTENING = re.compile(r"roadlang: listening on (\S+):(\d+)")
_NO_PORT = "roadlang: cannot listen on"
_HELP = (
    "get Godot 4.3 or newer: your system's package `godot`, or the download page of the Godot "
    "project; on Debian, `sh godot_backend/install_godot.sh`",
    f"or set {_VARIABLE} to the engine's executable",
)


def find() -> Path:
    """The engine: `ROADLANG_GODOT`, else on PATH, else in the usual places.

    Raises `EngineError` RL500 where there is none.
    """
    configured = os.environ.get(_VARIABLE)
    if configured:
        found = shutil.which(configured)
        if found is None:
            raise fault(
                Code.GODOT_NOT_FOUND,
                _HELP,
                reason=f"{_VARIABLE} is `{configured}`, which cannot be run",
            )
        return Path(found).absolute()
    for candidate in usual_executables():
        found = shutil.which(candidate)
        if found is not None:
            return Path(found).absolute()
    raise fault(Code.GODOT_NOT_FOUND, _HELP, reason="none on PATH or in the usual places")


def find_drawing() -> list[str]:
    """The command that runs an engine with pixels: on this screen, else on a virtual one.

    Raises `EngineError` RL500 or RL508.
    """
    engine = find()
    drawing = ["--audio-driver", "Dummy", "--rendering-method", "gl_compatibility"]
    if os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY") or os.name == "nt":
        return [str(engine), *drawing]
    renderer = engine.with_name(engine.name + "-render")
    if renderer.exists():
        return [str(renderer)]
    virtual = shutil.which("xvfb-run")
    if virtual is None:
        raise fault(
            Code.RENDERING_UNAVAILABLE, "run on a desktop, or install xvfb for a virtual screen"
        )
    screen = ["-a", "-s", "-screen 0 1280x720x24"]
    return [virtual, *screen, str(engine), "--rendering-driver", "opengl3", *drawing]


def version_of(engine: Path) -> str:
    """What `--version` prints. Raises `EngineError` RL501, or RL511 where it is too old."""
    try:
        finished = subprocess.run(
            [str(engine), "--version"],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=START_SECONDS,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise fault(Code.GODOT_NOT_STARTED, engine=engine, reason=str(error)) from error
    text = finished.stdout.strip().splitlines()[-1] if finished.stdout.strip() else ""
    numbers = re.match(r"(\d+)\.(\d+)", text)
    if numbers is None:
        raise fault(Code.GODOT_NOT_STARTED, engine=engine, reason="it does not print its version")
    if (int(numbers[1]), int(numbers[2])) < OLDEST:
        raise fault(Code.GODOT_TOO_OLD, version=text, oldest=".".join(map(str, OLDEST)))
    return text


def project() -> Path:
    """The bundled Godot project: of the installed package, else of the checkout."""
    shipped = Path(str(files("roadlang"))) / "_shipped" / "godot_backend"
    checkout = Path(__file__).resolve().parents[4] / "godot_backend"
    return shipped if not checkout.is_dir() else checkout


@dataclass
class Engine:
    """A running engine, and where it listens. Use as a context manager; leaving ends it."""

    process: subprocess.Popen[bytes]
    host: str
    port: int
    transport: str
    log: Path
    draws: bool

    def __enter__(self) -> Engine:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def connect(self, name: str = "", patience: float | None = None) -> Session:
        """A session with this engine."""
        seconds = ANSWER_TIMEOUT if patience is None else patience
        session = connect(self.host, self.port, self.transport, name, seconds, self.ending)
        # One that draws makes use of several cores; its process may be that of a virtual screen.
        session.process = None if self.draws else self.process.pid
        return session

    def ending(self) -> str:
        """How the process has ended, in words; nothing while it runs."""
        code = self.process.poll()
        if code is None:
            return ""
        number = -code if code < 0 else code - 128  # a shell gives the signal in this way
        if number not in set(signal.Signals):
            return f"its process has ended with code {code}"
        name = signal.Signals(number).name
        return f"its process was {'killed' if self.was_killed else 'ended'} by {name}"

    @property
    def was_killed(self) -> bool:
        """Whether something else has ended the process, not a fault of its own."""
        return self.process.poll() in _KILLED

    def output(self) -> str:
        """What the engine has printed."""
        return self.log.read_text(encoding="utf-8", errors="replace")

    def stop(self) -> None:
        """End the process, with the virtual screen it may have, and remove its log."""
        if self.process.poll() is None:
            self._signal(signal.SIGTERM)
            try:
                self.process.wait(timeout=5)
            except subprocess.TimeoutExpired:
                self._signal(_KILL)
                self.process.wait()
        if self.process.stdin is not None:
            self.process.stdin.close()
        shutil.rmtree(self.log.parent, ignore_errors=True)

    def _signal(self, number: int) -> None:
        if os.name == "nt":
            self.process.send_signal(number)
            return
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, number)


def connect(
    host: str,
    port: int,
    transport: str = "udp",
    name: str = "",
    patience: float | None = None,
    ending: Callable[[], str] = str,
) -> Session:
    """A session with an engine that already runs; `ending` says how its process has ended.

    Raises `EngineError` RL502 where nobody answers, RL503 where it refuses, RL512 where the address
    is wrong, RL516 where the package for a WebSocket is missing.
    """
    try:
        link: DatagramLink = (
            websocket_link(host, port) if transport == "websocket" else UdpLink(host, port)
        )
    except OSError as error:
        raise fault(
            Code.UNREACHABLE_ADDRESS, host=host, port=port, reason=error.strerror or error
        ) from error
    return Session(link, patience=patience, name=name, ending=ending)


def start(
    *,
    fixed_fps: int | None = None,
    draw: bool = False,
    window: bool = False,
    host: str = "127.0.0.1",
    port: int = 0,
    transport: str = "udp",
    quit_idle: float | None = 60.0,
    extra: Sequence[str] = (),
) -> Engine:
    """Start an engine: headless, or with `draw` to take pictures, or with `window` to be looked at.

    `fixed_fps` makes it run as fast as it can, each frame that part of a second; `port` 0 takes
    a free one; after `quit_idle` seconds without a client it ends by itself, so that nothing is
    left behind by whoever was killed. Raises `EngineError` RL500, RL501, RL508.
    """
    draws = draw or window
    command = find_drawing() if draws else [str(find()), "--headless"]
    command += ["--path", str(project())]
    if fixed_fps is not None:
        command += ["--fixed-fps", str(fixed_fps)]
    command += [*extra, "--", "--host", host, "--port", str(port), "--transport", transport]
    log = new_log()
    command += ["--quit-with-parent", "--log", str(log)]
    if draw and not window:
        command.append("--still")
    if quit_idle is not None:
        command += ["--quit-idle", str(quit_idle)]
    engine = Engine(_spawn(command, log), host, port, transport, log, draws)
    engine.port = _await_port(engine, command[0])
    return engine


def _spawn(command: list[str], log: Path) -> subprocess.Popen[bytes]:
    """A process group of its own: ending it ends a virtual screen too."""
    try:
        # A file, not a pipe: an engine whose pipe nobody reads stops when it is full.
        with log.open("wb") as out:
            return subprocess.Popen(
                command,
                stdout=out,
                stderr=subprocess.STDOUT,
                # Ends with this process, however that ends; then the engine ends too.
                stdin=subprocess.PIPE,
                start_new_session=True,
            )
    except OSError as error:
        shutil.rmtree(log.parent, ignore_errors=True)
        raise fault(
            Code.GODOT_NOT_STARTED, engine=command[0], reason=error.strerror or error
        ) from error


def _await_port(engine: Engine, name: str) -> int:
    deadline = time.monotonic() + START_SECONDS
    while time.monotonic() < deadline:
        heard = _LISTENING.search(engine.output())
        if heard:
            return int(heard[2])
        if engine.process.poll() is not None or "SCRIPT ERROR" in engine.output():
            break
        time.sleep(0.02)
    printed, was_killed = engine.output(), engine.was_killed
    engine.stop()  # that ends it by a signal, too
    raise _not_started(name, printed, engine.host, engine.port, was_killed)


def _not_started(name: str, printed: str, host: str, port: int, was_killed: bool) -> EngineError:
    """Why an engine does not listen, by what it has printed."""
    if _NO_PORT in printed:
        return fault(
            Code.GODOT_NOT_STARTED,
            "end the program that listens there, or choose another port with `--port`",
            engine=name,
            reason=f"port {port} of {host} is in use or not allowed",
        )
    if was_killed:
        reason = "its process was killed while it started"
        return fault(Code.GODOT_DISCONNECTED, reason=reason)
    try:
        version_of(find())
    except EngineError as error:  # what is too old fails in many ways
        if error.diagnostics[0].code == Code.GODOT_TOO_OLD:
            return error
    errors = [line for line in printed.splitlines() if "ERROR" in line]
    shown = errors[:3] or printed.strip().splitlines()[-3:]
    reason = "it did not start listening"
    return fault(Code.GODOT_NOT_STARTED, shown, engine=name, reason=reason)
