"""Which plugin a name means, and which names a plugin may have."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.cli.main import run
from roadlang.diagnostics import Diagnostic
from roadlang.plugins import compatibility
from roadlang.plugins.discovery import load_registry
from roadlang.plugins.registry import AmbiguousKind
from roadlang.semantics import check_text
from tests.plugins.installed import install
from tests.plugins.test_discovery import GOOD

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }\n"
SINE = ROAD + "road bent from main { perturb with KIND { amplitude: 1m, wavelength: 80m } }\n"
ZIGZAG = ROAD + "road bent from main { perturb with KIND { amplitude: 1m } }\n"
STRANGER = """
from dataclasses import dataclass
from typing import ClassVar
from roadlang.api import (
    AgentKind, AgentName, Backend, DriveSignal, ObjectKind, Reader, RoadName, Signal, hookimpl,
    option,
)

@dataclass(frozen=True)
class Json(Backend):
    '''Not the JSON of the scene.'''
    name: ClassVar[str] = "json"

    def files(self, scene):
        return {"json": "[]"}

@dataclass(frozen=True)
class Csv(Reader):
    '''Reads nothing.'''
    name: ClassVar[str] = "table"
    suffixes: ClassVar[tuple[str, ...]] = (".csv", ".odd")

    def read(self, path):
        return None

@dataclass(frozen=True)
class Start(DriveSignal):
    '''Has the name of a shipped number.'''
    name: ClassVar[str] = "start"
    unit: ClassVar[str] = "s"
    agent: AgentName = option()

    def values(self):
        return self.agent.time

@dataclass(frozen=True)
class Length(Signal):
    '''Has the name of a shipped number.'''
    name: ClassVar[str] = "length"
    unit: ClassVar[str] = "s"
    road: RoadName = option()

    def values(self):
        return 0 * self.road.stations

@dataclass(frozen=True)
class Tree(AgentKind):
    '''An agent with the name of a shipped object.'''
    name: ClassVar[str] = "tree"

@hookimpl
def roadlang_kinds():
    return [Json, Csv, Start, Length, Tree]
"""


def faults(text: str, folder: Path) -> list[Diagnostic]:
    return check_text(text, folder / "scene.rl", {}, load_registry())[1]


def broken(plugin: str) -> list[str]:
    return [b.reason for b in load_registry().broken if b.origin.plugin == plugin]


def test_a_plain_name_means_the_shipped_kind_and_a_warning_says_so(site: Path) -> None:
    install(site, "waves", GOOD.format(kind="sine"))
    assert load_registry().find("perturb", "sine").qualified == "standard.sine"
    [found] = faults(SINE.replace("KIND", "sine"), site)
    assert (found.code, found.severity) == ("RL292", "warning")
    assert "`perturb with sine` means the kind that ships" in found.message
    assert "waves-plugin 1.2" in found.message
    assert found.help == ("write `waves.sine` for that, or `standard.sine` for this one",)


def test_a_name_is_warned_of_once(site: Path) -> None:
    install(site, "waves", GOOD.format(kind="sine"))
    again = "road other from main { perturb with sine { amplitude: 1m, wavelength: 9m } }\n"
    assert len(faults(SINE.replace("KIND", "sine") + again, site)) == 1


@pytest.mark.parametrize("name", ["standard.sine", "waves.sine"])
def test_a_qualified_name_needs_no_warning(site: Path, name: str) -> None:
    install(site, "waves", GOOD.format(kind="sine"))
    text = SINE if name == "standard.sine" else ZIGZAG
    assert faults(text.replace("KIND", name), site) == []


def test_what_names_no_kind_means_the_shipped_one_without_a_warning(site: Path) -> None:
    uniform = GOOD.format(kind="uniform").replace("Perturber", "Distribution")
    uniform = uniform.replace("def displacement(self, road, random)", "def quantile(self, uniform)")
    install(site, "waves", uniform)
    text = SINE.replace("KIND", "sine").replace("amplitude: 1m", "amplitude: 1m..2m")
    assert faults(text, site) == []


def test_two_strangers_of_one_name_are_both_named(site: Path) -> None:
    install(site, "left", GOOD.format(kind="zigzag"))
    install(site, "right", GOOD.format(kind="zigzag"))
    with pytest.raises(AmbiguousKind):
        load_registry().find("perturb", "zigzag")
    [found] = faults(ZIGZAG.replace("KIND", "zigzag"), site)
    assert found.code == "RL213"
    assert "left-plugin 1.2 and right-plugin 1.2" in found.message
    assert found.help == ("write `left.zigzag` or `right.zigzag`",)
    assert faults(ZIGZAG.replace("KIND", "right.zigzag"), site) == []


@pytest.mark.parametrize("emit", ["", "emit json\n"])
def test_a_second_json_leaves_the_output_as_it_was(
    site: Path, capsys: pytest.CaptureFixture[str], emit: str
) -> None:
    install(site, "acme", STRANGER)
    (site / "scene.rl").write_text(ROAD + emit)
    arguments = [str(site / "scene.rl"), "-o", str(site / "out")]
    assert run(["compile", *arguments]) == 0
    assert '"schema": "roadlang.scene/' in (site / "out" / "scene-0000.json").read_text()
    assert run(["compile", *arguments, "--emit", "json"]) == 0
    assert '"schema": "roadlang.scene/' in (site / "out" / "scene-0000.json").read_text()
    assert run(["compile", *arguments, "--emit", "acme.json"]) == 0
    assert (site / "out" / "scene-0000.json").read_text() == "[]"
    assert "RL900" not in capsys.readouterr().err


@pytest.mark.parametrize(
    ("command", "what"),
    [
        (["compile", "SCENE", "--emit", "zip"], "emit zip"),
        (["extract", "PICTURE", "--with", "zip"], "extract zip"),
        (["run", "SCENE", "--engine", "zip"], "simulate zip"),
    ],
)
def test_a_command_says_which_plugins_share_a_name(
    site: Path, capsys: pytest.CaptureFixture[str], command: list[str], what: str
) -> None:
    kinds = """
from dataclasses import dataclass
from typing import ClassVar
from roadlang.api import Backend, Extractor, Simulator, hookimpl

@dataclass(frozen=True)
class A(Backend):
    name: ClassVar[str] = "zip"
    def files(self, scene): return {}

@dataclass(frozen=True)
class B(Extractor):
    name: ClassVar[str] = "zip"
    def extract(self, picture): return None

@dataclass(frozen=True)
class C(Simulator):
    name: ClassVar[str] = "zip"
    def drive(self, scene, controllers): return None

@hookimpl
def roadlang_kinds(): return [A, B, C]
"""
    install(site, "left", kinds)
    install(site, "right", kinds)
    (site / "scene.rl").write_text(ROAD)
    picture = str(Path(__file__).parents[2] / "examples" / "hairpin.jpg")
    places = {"SCENE": str(site / "scene.rl"), "PICTURE": picture}
    assert run([places.get(word, word) for word in command]) == 1
    said = capsys.readouterr().err
    assert f"error[RL213]: `{what}` is ambiguous" in said
    assert "left-plugin 1.2 and right-plugin 1.2" in said


def test_a_shipped_name_of_another_verb_goes_before_a_strangers(site: Path) -> None:
    install(site, "acme", STRANGER)
    text = (
        ROAD
        + "agent ego is car on main at 5m { drive with brake }\n"
        + "require near: ego.start < 9m\n"
        + "require short: length(main) < 900m\n"
        + "object oak is tree on main at 9m\n"
    )
    assert [found.code for found in faults(text, site)] == []


def test_the_shipped_reader_of_an_ending_goes_before_a_strangers(site: Path) -> None:
    install(site, "acme", STRANGER)
    (site / "points.csv").write_text("x,y\n0,0\n80,0\n160,10\n")
    [found] = faults('road spa from "points.csv"', site)
    assert found.code == "RL292"
    assert "`a reader of .csv files` means the kind that ships" in found.message
    assert faults('road spa from "points.csv" { read with acme.table }', site) == []


@pytest.mark.parametrize(
    ("entry", "reason"),
    [
        ("my-kit", "its entry point 'my-kit' is not a name: use letters, digits and `_`"),
        ("sp ace", "its entry point 'sp ace' is not a name: use letters, digits and `_`"),
        ("kit.more", "its entry point 'kit.more' is not a name: use letters, digits and `_`"),
        ("2fast", "its entry point '2fast' is not a name: use letters, digits and `_`"),
        ("größe", "its entry point 'größe' is not a name: use letters, digits and `_`"),
        ("with", "its entry point `with` is a keyword"),
        ("always", "its entry point `always` is a keyword"),
        ("standard", "its entry point `standard` is also that of roadlang"),
        ("godot", "its entry point `godot` is also that of roadlang"),
    ],
)
def test_an_entry_point_that_cannot_be_written_or_is_ours(
    site: Path, entry: str, reason: str
) -> None:
    install(site, "odd", GOOD.format(kind="zigzag"), name_of_entry=entry)
    install(site, "good", GOOD.format(kind="zagzig"))
    registry = load_registry()
    [found] = registry.broken
    assert found.origin.plugin == entry
    assert found.origin.distribution == "odd-plugin"
    assert found.reason.startswith(reason)
    assert registry.find("perturb", "zagzig").origin.plugin == "good"
    assert registry.find("perturb", "standard.sine").origin.is_shipped
    assert registry.find("simulate", "godot").origin.is_shipped


def test_two_distributions_with_one_entry_point_are_both_left_out(site: Path) -> None:
    install(site, "one", GOOD.format(kind="zigzag"), name_of_entry="kit")
    install(site, "two", GOOD.format(kind="zagzig"), name_of_entry="kit")
    assert broken("kit") == [
        "its entry point `kit` is also that of two-plugin 1.2",
        "its entry point `kit` is also that of one-plugin 1.2",
    ]
    assert faults(SINE.replace("KIND", "sine"), site) == []


def test_a_kind_cannot_be_called_as_a_word_of_the_language(site: Path) -> None:
    install(site, "odd", GOOD.format(kind="until"))
    assert broken("odd") == ["its name `until` is a keyword (roadlang_odd.py:9)"]


@pytest.mark.parametrize(
    ("requires", "reason"),
    [
        ("roadlang>=99", "it requires roadlang>=99, and this is"),
        ("roadlang<0.1", "it requires roadlang<0.1, and this is"),
        ("roadlang (==0.0.1)", "it requires roadlang==0.0.1, and this is"),
        ("Roadlang>=99; python_version >= '3'", "it requires Roadlang>=99, and this is"),
        ("roadlang", None),
        ("roadlang>=0.1", None),
        ("roadlang>=99; extra == 'test'", None),
        ("roadlang-extras>=99", None),
        ("roadlang>>1", None),
        ("numpy>=99", None),
    ],
)
def test_a_plugin_for_another_version_of_roadlang(
    site: Path, requires: str, reason: str | None
) -> None:
    install(site, "good", GOOD.format(kind="zigzag"), requires=requires)
    assert load_registry().has("perturb", "zigzag") == (reason is None)
    assert all(found.startswith(str(reason)) for found in broken("good"))
    assert bool(broken("good")) == (reason is not None)


@pytest.mark.parametrize(
    ("version", "fits"), [("0.2.9.dev4", False), ("0.3.0.dev1", True), ("0.3.0", True)]
)
def test_a_checkout_on_the_way_to_a_version_is_as_good_as_that_version(
    site: Path, monkeypatch: pytest.MonkeyPatch, version: str, fits: bool
) -> None:
    install(site, "good", GOOD.format(kind="zigzag"), requires="roadlang>=0.3")
    monkeypatch.setattr(compatibility, "__version__", version)
    assert load_registry().has("perturb", "zigzag") == fits
