"""A class that cannot work as a kind is refused when it is loaded, with its file and line."""

from __future__ import annotations

import json
import textwrap
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import pytest

from roadlang.api import Backend, Integer, Length, Perturber, Word, option
from roadlang.cli.main import run
from roadlang.plugins.discovery import load_registry
from roadlang.plugins.kind_checks import KindFault, check_kind
from roadlang.plugins.registry import BrokenPlugin
from tests.plugins.installed import install

HEAD = """\
from dataclasses import dataclass, field
from typing import ClassVar
from roadlang.api import *
from roadlang.api import hookimpl
"""
GOOD = '''
@dataclass(frozen=True)
class Good(Perturber):
    """Does nothing."""
    name: ClassVar[str] = "good"

    def displacement(self, road, random):
        return 0 * road.stations
'''
HOOK = """
@hookimpl
def roadlang_kinds():
    return [Bad, Good]
"""
MAP = """
@hookimpl
def roadlang_kinds():
    return {"KEY": "roadlang_odd:Bad", "perturb good": "roadlang_odd:Good"}
"""


def perturber(body: str, name: str = "bad") -> str:
    """The class of a perturber; its first line is line 6 of the module."""
    body = textwrap.indent(textwrap.dedent(body).strip("\n"), "    ")
    return (
        f'\n@dataclass(frozen=True)\nclass Bad(Perturber):\n    name: ClassVar[str] = "{name}"\n'
        f"{body}\n"
    )


def options(*lines: str) -> str:
    return perturber("\n".join(lines) + "\ndef displacement(self, road, random): return 0")


def kind(base: str, *lines: str) -> str:
    body = "\n".join(f"    {line}" for line in lines)
    return (
        f'\n@dataclass(frozen=True)\nclass Bad({base}):\n    name: ClassVar[str] = "bad"\n{body}\n'
    )


METHOD = "def displacement(self, road, random): return 0"
FAULTS = {
    "nothing implemented": (
        kind("Perturber"), "Bad does not implement `displacement` or `displacements`", 6,
    ),
    "a misspelled method": (
        kind("Perturber", "def displacments(self, roads, random): return 0"),
        "Bad does not implement `displacement` or `displacements`; `displacments`: "
        "did you mean `displacements`?", 9,
    ),
    "a method that has another use": (
        kind("Perturber", "def smoothed(self, values): return values"),
        "Bad does not implement `displacement` or `displacements` (", 6,
    ),
    "a backend without a method": (
        kind("Backend"),
        "Bad does not implement `files` or `collection` or `drive_files` or `send`",
        6,
    ),
    "a second method misspelled": (
        kind("Backend", "def files(self, scene): return {}", "def colection(self, scenes): ..."),
        "Bad does not use `colection`: did you mean `collection`?", 10,
    ),
    "a judge of drives that judges roads": (
        kind("Monitor", 'domain: ClassVar[str] = "drive"', "def robustness(self): return [1]"),
        "Bad does not implement `judge`", 6,
    ),
    "a judge of roads that judges drives": (
        kind("Monitor", "def judge(self, trace): return 1"), "Bad does not implement `robustness`",
        6,
    ),
    "a misspelled attribute": (
        kind("Signal", 'unti: ClassVar[str] = "m"', "def values(self): return 0"),
        "Bad does not use `unti`: did you mean `unit`?", 9,
    ),
    "a method with too few parameters": (
        kind("Perturber", "def displacement(self, road): return 0"),
        "`displacement` of Bad takes (self, road), but is called with (self, road, random)", 9,
    ),
    "a method with too many": (
        kind("Extractor", "def extract(self, picture, level): return 0"),
        "`extract` of Bad takes (self, picture, level), but is called with (self, picture)", 9,
    ),
    "no method at all": (
        kind("Distribution", "def quantile(self, u): return u", "support: ClassVar = (0, 1)"),
        "`support` of Bad is not a method", 10,
    ),
    "a default of a wrong type": (
        options('size: Length = option("seven")'),
        "the option `size` of Bad has the default 'seven'; expected: length (m)", 9,
    ),
    "a flag of 0": (
        options("loud: Flag = option(0)"),
        "the option `loud` of Bad has the default 0; expected: true | false", 9,
    ),
    "a number that is a flag": (
        options("size: Length = option(True)"),
        "the option `size` of Bad has the default True; expected: length (m)", 9,
    ),
    "half of a whole number": (
        options("count: Integer = option(1.5)"), "expected: integer", 9,
    ),
    "not a number": (
        options('size: Length = option(float("nan"))'), "expected: length (m)", 9,
    ),
    "a point of three": (
        options("at: Point = option((1.0, 2.0, 3.0))"), "expected: point (m)", 9,
    ),
    "an interval from high to low": (
        options("range: LengthInterval = option((2.0, 1.0))"), "expected: interval", 9,
    ),
    "a list of fewer": (
        options("sizes: list_of(Length, at_least=2) = option((1.0,))"), "expected: list", 9,
    ),
    "a default that names a road": (
        options('other: RoadName = option("main")'), "expected: name of a road", 9,
    ),
    "a default below its bounds": (
        options("size: Length = option(-1.0, minimum=0)"),
        "the option `size` of Bad has the default -1.0; expected: >= 0m", 9,
    ),
    "a default at a bound that is excluded": (
        options("size: Length = option(0.0, above=0)"), "expected: > 0m", 9,
    ),
    "an item beyond the bounds": (
        options("sizes: list_of(Length) = option((1.0, 9.0), maximum=5)"), "expected: <= 5m", 9,
    ),
    "bounds that leave nothing": (
        options("size: Length = option(minimum=5, maximum=2)"), "allows no value: >= 5m, <= 2m", 9,
    ),
    "a word without words": (
        options("side: Word = option()"),
        "the option `side` of Bad is a word, but has no words", 9,
    ),
    "a default that is not among the words": (
        options('side: Word = option("up", words=("left", "right"))'),
        "has the default 'up'; expected: left | right", 9,
    ),
    "a word that cannot be written": (
        options('version: Word = option(words=("a\\nb",))'),
        "has the word 'a\\nb', which cannot be written in a scene file", 9,
    ),
    "a list as default": (
        options("sizes: list_of(Length) = option([1.0])"),
        "the option `sizes` of Bad has a list as default, which all uses would share: write a "
        "tuple", 9,
    ),
    "a map as default": (
        options("sizes: map_of(Length) = option({})"),
        "has a dict as default, which all uses would share: write None", 9,
    ),
    "a default factory": (
        options("sizes: list_of(Length) = field(default_factory=tuple)"), "default_factory", 9,
    ),
    "an option that hides `over`": (
        options("over: Length = option(1.0)"),
        "the option `over` of Bad would hide the option `over` that every kind of `perturb` has", 9,
    ),
    "an option that hides `when`": (
        kind("Controller", "when: Length = option(1.0)"), "every kind of `drive` has", 9,
    ),
    "an option that hides where an agent stands": (
        kind("AgentKind", "lane: Integer = option(1)"), "every kind of `agent` has", 9,
    ),
    "an option with the name of a method": (
        options("displacement_bound: Length = option(1.0)"),
        "the option `displacement_bound` of Bad has the name of an attribute of Perturber", 9,
    ),
    "an option called as a word of the language": (
        options("until: Length = option(1.0)"), "`until` of Bad cannot be written", 9,
    ),
    "an option whose letters no scene file has": (
        options("größe: Length = option(1.0)"), "`größe` of Bad cannot be written", 9,
    ),
    "an annotation that is no option": (
        options("size: complex = option(1)"),
        "field `size` of Bad: <class 'complex'> is not the type of an option", 9,
    ),
    "an annotation that is not there": (
        options('size: "Lenght" = option(1)'), "NameError: name 'Lenght' is not defined", 6,
    ),
    "an unknown unit": (
        kind("Signal", 'unit: ClassVar[str] = "parsec"', "def values(self): return 0"),
        "`unit` is 'parsec', which is not a unit", 9,
    ),
    "a unit with two slashes": (
        kind("DriveSignal", 'unit: ClassVar[str] = "m/s/s"', "def values(self): return 0"),
        "`unit` is 'm/s/s', which is not a unit", 9,
    ),
    "an unknown domain": (
        kind("Monitor", 'domain: ClassVar[str] = "air"', "def robustness(self): return 0"),
        '`domain` is \'air\', not "road" or "drive"', 9,
    ),
    "an attribute of a wrong type": (
        kind("Signal", 'cost: ClassVar[str] = "high"', "def values(self): return 0"),
        "`cost` of Bad is 'high', not a float", 9,
    ),
    "a category that is none": (
        kind("AgentKind", 'category: ClassVar[str] = "buss"', ""),
        "`category` of Bad is 'buss': did you mean 'bus'?", 9,
    ),
    "one word where a tuple is expected": (
        kind("Reader", 'reads: ClassVar[str] = "network"', "def read(self, path): return 0"),
        "`reads` of Bad is 'network', not a tuple of words", 9,
    ),
    "something that nobody declares": (
        kind("Reader", 'reads: ClassVar = ("street",)', "def read(self, path): return 0"),
        "`reads` has 'street': ", 9,
    ),
    "a rest that is no option": (
        kind("Distribution", 'rest: ClassVar[str] = "all"', "def quantile(self, u): return u"),
        "`rest` is 'all', which is not an option", 9,
    ),
    "a lane that no option holds": (
        kind("Controller", 'lane_options: ClassVar = ("to",)', "def control(self, seen): return 0"),
        "`lane_options` has 'to', which is not an option", 9,
    ),
    "a sensor that no option holds": (
        kind("Controller", 'sensor_options: ClassVar = ("eye",)',
             "def control(self, seen): return 0"),
        "`sensor_options` has 'eye', which is not an option", 9,
    ),
    "no name": (
        kind("Perturber", METHOD).replace('name: ClassVar[str] = "bad"', "pass"),
        "Bad has no `name`", 6,
    ),
    "a name that cannot be written": (
        kind("Perturber", METHOD).replace('"bad"', '"too bad"'), "its name 'too bad'", 8,
    ),
    "no verb": (kind("Kind", METHOD), "Bad has no verb", 6),
    "no decorator": (
        options("size: Length = option(1.0)").replace("@dataclass(frozen=True)", ""),
        "Bad is not decorated with `@dataclass(frozen=True)`", 7,
    ),
    "not frozen": (
        kind("Perturber", METHOD).replace("(frozen=True)", ""),
        "Bad is not decorated with `@dataclass(frozen=True)`", 6,
    ),
}  # fmt: skip


def refused(site: Path, text: str) -> BrokenPlugin:
    """The one thing that is broken where a plugin brings a bad kind and a good one."""
    install(site, "odd", text)
    registry = load_registry()
    assert registry.find("perturb", "good").origin.plugin == "odd"
    [found] = registry.broken
    return found


@pytest.mark.parametrize("fault", FAULTS)
def test_a_bad_kind_is_refused_and_its_plugin_goes_on(site: Path, fault: str) -> None:
    bad, says, line = FAULTS[fault]
    found = refused(site, HEAD + bad + GOOD + HOOK)
    assert says in found.reason
    assert found.reason.endswith(f"(roadlang_odd.py:{line})")
    assert found.kind


@pytest.mark.parametrize("fault", FAULTS)
def test_a_bad_kind_that_a_map_names_is_refused_when_it_is_used(site: Path, fault: str) -> None:
    bad, says, line = FAULTS[fault]
    install(site, "odd", HEAD + bad + GOOD + MAP.replace("KEY", "perturb bad"))
    registry = load_registry()
    assert registry.broken == ()
    with pytest.raises(KindFault) as caught:
        registry.find("perturb", "bad").load()
    assert says in str(caught.value)
    assert str(caught.value).endswith(f"(roadlang_odd.py:{line})")


@pytest.mark.parametrize("key", ["bad", "perturbed bad", "perturb with bad", "perturb until"])
def test_a_bad_key_of_a_map_leaves_the_others(site: Path, key: str) -> None:
    found = refused(site, HEAD + options("") + GOOD + MAP.replace("KEY", key))
    assert key.split()[-1] in found.reason or key in found.reason


def test_a_kind_that_comes_twice_leaves_the_others(site: Path) -> None:
    found = refused(site, HEAD + options("") + GOOD + HOOK.replace("[Bad,", "[Bad, Bad,"))
    assert found.kind == "perturb bad"
    assert found.reason == "it provides `perturb bad` twice"


def test_a_use_of_a_bad_kind_gives_the_reason(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    install(site, "odd", HEAD + kind("Perturber") + GOOD + HOOK)
    scene = site / "scene.rl"
    road = "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m)] } }\n"
    for name in ("bad", "odd.bad"):
        scene.write_text(road + f"road bent from main {{ perturb with {name} }}\n")
        assert run(["check", str(scene)]) == 5
        said = capsys.readouterr().err
        assert "error[RL211]" in said
        assert "does not implement `displacement`" in said
        assert "(roadlang_odd.py:6)" in said


def test_the_listing_has_broken_kinds_first(site: Path, capsys: pytest.CaptureFixture[str]) -> None:
    install(site, "odd", HEAD + kind("Perturber") + GOOD + HOOK)
    assert run(["plugins"]) == 0
    first, *others = capsys.readouterr().out.splitlines()
    assert first.startswith("`perturb bad` of odd (odd-plugin 1.2) is broken: Bad does not impl")
    assert any(line.startswith("  perturb good") for line in others)
    assert run(["plugins", "--json"]) == 0
    [record] = json.loads(capsys.readouterr().out)["broken"]
    assert record["kind"] == "perturb bad"


def test_what_a_plugin_may_do() -> None:
    @dataclass(frozen=True)
    class Fine(Perturber):
        """Has helpers, words beside numbers, defaults at their bounds, and an open signature."""

        name: ClassVar[str] = "fine"
        size: Length = option(0.0, minimum=0)
        far: Length = option(float("inf"))
        count: Integer = option("auto", minimum=1, words=("auto",))
        side: Word = option("left", words=("left", "right"))
        feet: Length = option(0.3048, minimum=0.3048)

        @property
        def double(self) -> float:
            return 2 * self.size

        def helper(self) -> float:
            return self.double

        def displacements(self, *given: Any, **named: Any) -> Any:
            return self.helper()

    @dataclass(frozen=True)
    class Inherits(Fine):
        """A kind of another kind."""

        name: ClassVar[str] = "inherits"

    @dataclass(frozen=True)
    class Sends(Backend):
        """One method is enough."""

        name: ClassVar[str] = "sends"

        def send(self, scene: Any) -> None:
            return None

    for good in (Fine, Inherits, Sends):
        assert check_kind(good) is good


@pytest.mark.parametrize("what", [3, int, None, "Sine"])
def test_what_is_no_kind(what: object) -> None:
    with pytest.raises(KindFault, match="does not derive from a base class"):
        check_kind(what)
