"""Tools of other projects, each installed in a folder of its own, because their pins clash.

`requirements/NAME.txt` makes a virtual environment, `requirements/NAME.json` a folder of npm
packages. They are made on first use and kept outside the checkout: in the folder that the
environment variable ROADLANG_TEST_TOOLS names, by default in the cache of the user.

`python3 -m tests.formats.tool_installation` makes all of them. It needs no package, so that CI can
start it before anything else is installed.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

_REQUIREMENTS = Path(__file__).parent / "requirements"
_READY = "ready"
_NEEDED_BYTES = 4_000_000_000
"""Free space below which nothing is installed: SUMO, the largest, unpacks to 0.8 GB."""
_SECONDS = 1800


class ToolUnavailableError(Exception):
    """A tool cannot be installed; the message says why."""


def tool_names() -> list[str]:
    """All tools, in the order in which they are installed."""
    return sorted(path.stem for path in _REQUIREMENTS.iterdir())


def installed_tool(name: str) -> Path:
    """The folder of a tool, which is made if it does not exist yet.

    A virtual environment, or a folder with `node_modules`. Other processes that want the same tool
    wait until it is there.

    Raises:
        ToolUnavailableError: It cannot be installed here.
    """
    pins = next(_REQUIREMENTS.glob(f"{name}.*"))
    target = _cache() / f"{name}-{_digest(pins)}"
    if (target / _READY).exists():
        return target
    with _locked(_cache() / f"{name}.lock"):
        if not (target / _READY).exists():
            _install(pins, target)
    return target


def _install(pins: Path, target: Path) -> None:
    shutil.rmtree(target, ignore_errors=True)  # what an interrupted installation has left
    free = shutil.disk_usage(target.parent).free
    if free < _NEEDED_BYTES:
        raise ToolUnavailableError(f"only {free / 1e9:.1f} GB are free for {target}")
    try:
        if pins.suffix == ".json":
            _install_npm(pins, target)
        else:
            _install_pip(pins, target)
    except ToolUnavailableError:
        shutil.rmtree(target, ignore_errors=True)
        raise
    (target / _READY).touch()


def _install_pip(pins: Path, target: Path) -> None:
    python = str(target / "bin" / "python")
    # The interpreter behind the environment of the tests: theirs may be deleted at any time.
    base = getattr(sys, "_base_executable", sys.executable)
    if _has_pip_for_others(base):  # to put pip in each environment takes seven CPU seconds
        _run([base, "-m", "venv", "--without-pip", str(target)])
        pip = [base, "-m", "pip", "--python", python]
    else:
        _run([base, "-m", "venv", str(target)])
        pip = [python, "-m", "pip"]
    options = ("--quiet", "--no-compile", "--prefer-binary", "-r", str(pins))
    _run([*pip, "--disable-pip-version-check", "install", *options])


def _has_pip_for_others(python: str) -> bool:
    """Whether an interpreter has a pip that installs for another one: 22.3 or newer."""
    asked = subprocess.run([python, "-m", "pip", "--help"], capture_output=True, text=True)
    return "--python" in asked.stdout


def _install_npm(pins: Path, target: Path) -> None:
    if not shutil.which("npm"):
        raise ToolUnavailableError("npm is not installed")
    target.mkdir(parents=True)
    shutil.copy(pins, target / "package.json")
    _run(["npm", "install", "--no-audit", "--no-fund", "--prefix", str(target)])


def _run(command: list[str]) -> None:
    environment = {key: text for key, text in os.environ.items() if key != "PYTHONPATH"}
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=_SECONDS, env=environment
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise ToolUnavailableError(str(error)) from error
    if done.returncode:
        last = (done.stderr.strip() or done.stdout.strip())[-400:]
        raise ToolUnavailableError(f"`{' '.join(command)}` failed: {last}")


def _cache() -> Path:
    named = os.environ.get("ROADLANG_TEST_TOOLS")
    general = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(named) if named else Path(general) / "roadlang" / "test-tools"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def _digest(pins: Path) -> str:
    version = f"{sys.version_info.major}.{sys.version_info.minor}\n"
    return hashlib.sha256(version.encode() + pins.read_bytes()).hexdigest()[:12]


@contextlib.contextmanager
def _locked(path: Path) -> Iterator[None]:
    """Wait until no other process installs the same tool. The system frees the lock of a process
    that dies."""
    if sys.platform == "win32":
        raise ToolUnavailableError("the tools are installed on Linux and macOS only")
    import fcntl

    with path.open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def main() -> None:
    """Install all tools; say which ones are not available."""
    for name in tool_names():
        try:
            print(f"{name}: {installed_tool(name)}", flush=True)
        except ToolUnavailableError as error:
            print(f"{name}: {error}", flush=True)


if __name__ == "__main__":
    main()
