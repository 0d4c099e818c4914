"""Standard output is for the results of commands, whatever a plugin prints, also from C."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from tests.plugins.installed import install, start

PLUGIN = """
import ctypes
import os
from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Perturber, hookimpl


def talk(where):
    print(f"print {where}")
    os.write(1, f"write {where}\\n".encode())
    ctypes.CDLL(None).printf(f"printf {where}\\n".encode())  # arrives when the process ends


talk("at import")


@dataclass(frozen=True)
class Loud(Perturber):
    '''Says what it does.'''
    name: ClassVar[str] = "loud"

    def displacement(self, road, random):
        talk("at work")
        return 0.0 * road.stations


@hookimpl
def roadlang_kinds():
    return [Loud]
"""
SCENE = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }
road bent from main { perturb with loud }
"""


@pytest.mark.skipif(sys.platform == "win32", reason="printf of the C library of POSIX")
@pytest.mark.parametrize("command", ["check", "compile"])
def test_what_a_plugin_prints_goes_to_standard_error(site: Path, command: str) -> None:
    install(site, "loud", PLUGIN)
    (site / "scene.rl").write_text(SCENE)
    process = start(site, command, "scene.rl", "--json")
    out, err = process.communicate(timeout=300)
    assert process.returncode == 0
    json.loads(out)
    where = ["at import", *(["at work"] if command == "compile" else [])]
    for said in (f"{how} {when}" for when in where for how in ("print", "write", "printf")):
        assert said in err
