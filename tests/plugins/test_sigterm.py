"""SIGTERM ends a command with exit code 143 and one line, whatever code of a plugin is running."""

from __future__ import annotations

import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.plugins.installed import install, start

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")

EXAMPLES = Path(__file__).parents[2] / "examples"
PLUGIN = '''
import os
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from roadlang.api import Adjuster, Monitor, Perturber, RoadName, hookimpl, option


def reached():
    Path(os.environ["MARKER"]).touch()


def work(seconds=60):
    """As long as a run takes that a job scheduler ends."""
    reached()
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        sum(range(1000))

AT_IMPORT

@dataclass(frozen=True)
class Busy(Perturber):
    """Takes a minute."""
    name: ClassVar[str] = "busy"

    def displacement(self, road, random):
        work()
        return 0.0 * road.stations


@dataclass(frozen=True)
class Deaf(Perturber):
    """Catches everything that it can."""
    name: ClassVar[str] = "deaf"

    def displacement(self, road, random):
        try:
            work()
        except BaseException:
            pass
        return 0.0 * road.stations


@dataclass(frozen=True)
class Shade(Adjuster):
    """Says that the picture is about to be read."""
    name: ClassVar[str] = "shade"

    def adjust(self, pixels, random):
        reached()
        return pixels


@dataclass(frozen=True)
class Never(Monitor):
    """Rejects everything."""
    name: ClassVar[str] = "never"
    road: RoadName = option()

    def robustness(self):
        reached()
        return [-1.0]


@hookimpl
def roadlang_kinds():
    return [Busy, Deaf, Shade, Never]
'''
LATE = """
from roadlang.api import hookimpl

@hookimpl
def roadlang_kinds():
    return {"perturb busy": "roadlang_late_kinds:Busy"}
"""
ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }\n"
PHOTO = """
image photo from "hairpin.jpg" { scale: 0.25m/px, adjust with shade }
network found from photo
road main from found { select: longest }
"""
ENDLESS = (
    ROAD
    + "road bent from main { perturb with sine { amplitude: 0m..3m, wavelength: 80m } }\n"
    + "require no with never { road: bent }\n"
    + "sample with random { attempts: 100000000 }\n"
)


def bent(kind: str) -> str:
    return ROAD + f"road bent from main {{ perturb with {kind} }}\n"


def stopped(folder: Path, *arguments: str, times: int = 1) -> None:
    """Run a command, end it when it is where the test wants it, and look at what it leaves."""
    process = start(folder, *arguments)
    while not (folder / "reached").exists():
        assert process.poll() is None, process.communicate()
        time.sleep(0.005)
    for _ in range(times):
        process.send_signal(signal.SIGTERM)
    out, err = process.communicate(timeout=300)
    assert (process.returncode, out, err) == (143, "", "stopped\n")
    assert not (folder / "out").exists()


@pytest.fixture
def folder(site: Path) -> Path:
    install(site, "slow", PLUGIN.replace("AT_IMPORT", ""))
    return site


@pytest.mark.parametrize("command", [["compile"], ["compile", "--json"], ["run"]])
def test_while_a_kind_works(folder: Path, command: list[str]) -> None:
    (folder / "scene.rl").write_text(bent("busy") + "simulate with godot\n")
    stopped(folder, *command, "scene.rl")


def test_twice_at_once_as_the_timeout_command_does(folder: Path) -> None:
    (folder / "scene.rl").write_text(bent("busy"))
    stopped(folder, "compile", "scene.rl", times=2)


def test_while_a_kind_catches_everything(folder: Path) -> None:
    (folder / "scene.rl").write_text(bent("deaf"))
    stopped(folder, "compile", "scene.rl")


def test_while_a_photo_is_read(folder: Path) -> None:
    shutil.copy(EXAMPLES / "hairpin.jpg", folder)
    (folder / "scene.rl").write_text(PHOTO)
    stopped(folder, "compile", "scene.rl")


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_while_scenes_are_searched(folder: Path, jobs: str) -> None:
    (folder / "scene.rl").write_text(ENDLESS)
    stopped(folder, "compile", "scene.rl", "-n", "40", "--jobs", jobs)


def test_while_workers_are_busy(folder: Path) -> None:
    text = (
        ROAD
        + "road bent from main { perturb with sine { amplitude: 0m..3m, wavelength: 80m } }\n"
        + "road late from bent { perturb with busy }\n"
        + "require near: always (deviation(late, main) < 9m)\n"
    )
    (folder / "scene.rl").write_text(text)
    stopped(folder, "compile", "scene.rl", "-n", "40", "--jobs", "2")


@pytest.mark.parametrize("command", [["check", "scene.rl"], ["plugins"], ["compile", "scene.rl"]])
def test_while_a_plugin_is_imported(site: Path, command: list[str]) -> None:
    install(site, "slow", PLUGIN.replace("AT_IMPORT", "work()"))
    (site / "scene.rl").write_text(ROAD)
    stopped(site, *command)


def test_while_a_kind_is_imported_that_a_map_names(site: Path) -> None:
    install(site, "late", LATE)
    (site / "roadlang_late_kinds.py").write_text(PLUGIN.replace("AT_IMPORT", "work()"))
    (site / "scene.rl").write_text(bent("busy"))
    stopped(site, "check", "scene.rl")


def test_a_plugin_that_exits_is_still_named(site: Path) -> None:
    install(
        site,
        "slow",
        PLUGIN.replace("AT_IMPORT", "").replace(
            "work()\n        return", "sys.exit(143)\n        return"
        ),
    )
    (site / "scene.rl").write_text(bent("busy"))
    process = start(site, "compile", "scene.rl")
    _, err = process.communicate(timeout=300)
    assert process.returncode == 5
    assert "`perturb slow.busy` failed (slow-plugin 1.2): SystemExit: 143" in err
    assert "roadlang_slow.py:" in err


THREE = """
import os, signal
from roadlang.plugins.termination import Terminated, end_on_sigterm, raise_if_terminated

def send():
    try:
        os.kill(os.getpid(), signal.SIGTERM)
    except Terminated:
        print("raised", flush=True)
    else:
        print("quiet", flush=True)

raise_if_terminated()
end_on_sigterm()
for _ in range(3):
    send()
    try:
        raise_if_terminated()
    except Terminated:
        print("raised again", flush=True)
print("never reached")
"""


def test_a_second_signal_lets_the_process_clean_up_and_a_third_ends_it() -> None:
    found = subprocess.run([sys.executable, "-c", THREE], capture_output=True, text=True)
    assert found.stdout.split("\n") == ["raised", "raised again", "quiet", "raised again", ""]
    assert found.returncode == -signal.SIGTERM
