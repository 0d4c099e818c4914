"""Commands that use a kind without a scene file name the plugin that fails, too."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

from roadlang.cli.main import run
from roadlang.plugins.discovery import load_registry
from tests.plugins.installed import install

PLUGIN = """
from dataclasses import dataclass
from typing import ClassVar
from roadlang.api import Extractor, hookimpl

def made():
    @dataclass(frozen=True)
    class Odd(Extractor):
        '''Finds nothing of use.'''
        name: ClassVar[str] = "odd"

        def extract(self, picture):
            RESULT

    return Odd

@hookimpl
def roadlang_kinds():
    return [made()]
"""
PICTURE = Path(__file__).parents[2] / "examples" / "hairpin.jpg"
LATE = """
from roadlang.api import hookimpl

@hookimpl
def roadlang_kinds():
    return {"perturb zigzag": "roadlang_not_there:Zigzag"}
"""


@pytest.mark.parametrize(("result", "code"), [("return 1 / 0", "RL470"), ("return None", "RL474")])
def test_an_extractor_on_the_command_line(
    site: Path, capsys: pytest.CaptureFixture[str], result: str, code: str
) -> None:
    install(site, "acme", PLUGIN.replace("RESULT", result))
    assert run(["extract", str(PICTURE), "--with", "odd"]) == 5
    said = capsys.readouterr().err
    assert code in said
    assert "acme-plugin 1.2" in said


SWAY = """
from dataclasses import dataclass
from typing import ClassVar
from roadlang.api import Backend, Perturber, hookimpl

@dataclass(frozen=True)
class Sway(Perturber):
    "Divides by zero."
    name: ClassVar[str] = "sway"
    is_random: ClassVar[bool] = False

    def displacement(self, road, random):
        return 1 / 0

@dataclass(frozen=True)
class Zero(Backend):
    "Divides by zero."
    name: ClassVar[str] = "zero"

    def files(self, scene):
        return 1 / 0

@hookimpl
def roadlang_kinds():
    return [Sway, Zero]
"""
ROAD = "road main { draw with segments { pieces: [straight(90m)] } }\n"


@pytest.mark.parametrize(
    "more", ["road bent from main { perturb with sway }\nemit json", "emit zero"]
)
@pytest.mark.parametrize("options", [[], ["--json"]])
def test_the_author_of_a_plugin_can_see_where_it_raised(
    site: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    more: str,
    options: list[str],
) -> None:
    install(site, "acme", SWAY)
    path = site / "scene.rl"
    path.write_text(ROAD + more)
    command = ["compile", str(path), "-o", str(site / "out"), *options]
    assert run(command) == 5
    assert "Traceback" not in capsys.readouterr().err
    monkeypatch.setenv("ROADLANG_TRACEBACK", "1")
    assert run(command) == 5
    said = capsys.readouterr().err
    assert "roadlang_acme.py" in said
    assert "ZeroDivisionError" in said
    assert "Traceback" in said


@pytest.mark.parametrize("command", [["plugins", "show", "zigzag"], ["schema", "zigzag"]])
def test_a_kind_that_cannot_be_shown(
    site: Path, capsys: pytest.CaptureFixture[str], command: list[str]
) -> None:
    install(site, "late", LATE)
    assert run(command) == 5
    assert "late-plugin 1.2" in capsys.readouterr().err


def test_a_class_that_only_a_function_knows_does_not_stop_other_processes(site: Path) -> None:
    install(site, "acme", PLUGIN.replace("RESULT", "return None"))
    registry = pickle.loads(pickle.dumps(load_registry()))
    assert registry.find("perturb", "sine").load().name == "sine"
    with pytest.raises(AttributeError, match="locals"):
        registry.find("extract", "odd").load()
