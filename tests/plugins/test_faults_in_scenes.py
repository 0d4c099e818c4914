"""What a scene file hears of plugins that are broken, or that agree on a name."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from roadlang.cli.main import run
from roadlang.diagnostics import Diagnostic
from roadlang.plugins.discovery import load_registry
from roadlang.scenes.sampling import sample_scenes
from roadlang.semantics import check_text
from tests.plugins.installed import install
from tests.plugins.test_discovery import ACME, GOOD

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }\n"


def faults(text: str, folder: Path) -> list[Diagnostic]:
    return check_text(ROAD + text, folder / "scene.rl", {}, load_registry())[1]


def test_a_kind_of_a_broken_plugin_gives_the_reason(site: Path) -> None:
    install(site, "acme", "raise RuntimeError('no license found')")
    [fault] = faults("agent ego is car on main at 5m { drive with acme.mpc { horizon: 2s } }", site)
    assert fault.code == "RL211"
    assert fault.span is not None
    assert fault.span.text == "acme.mpc"
    assert "acme-plugin 1.2" in fault.message
    assert "no license found" in fault.message


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("agent ego is car on main at 5m { drive with mpc { horizon: 2s } }", "RL210"),
        ("let j = zqx(main)", "RL225"),
    ],
)
def test_a_broken_plugin_is_mentioned_where_a_kind_is_not_known(
    site: Path, text: str, code: str
) -> None:
    install(site, "acme", "raise RuntimeError('no license found')")
    [fault] = faults(text, site)
    assert fault.code == code
    assert any("acme-plugin 1.2 could not be loaded" in line for line in fault.help)


def test_who_interrupts_a_plugin_that_hangs_hears_which(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    install(site, "acme", "raise KeyboardInterrupt")  # as Ctrl-C does
    assert run(["plugins"]) == 130
    assert capsys.readouterr().err.strip() == "interrupted while acme-plugin 1.2 was loaded"


def test_a_kind_that_fails_when_it_is_imported(site: Path) -> None:
    text = """
from roadlang.api import hookimpl

@hookimpl
def roadlang_kinds():
    return {"perturb zigzag": "roadlang_not_there:Zigzag"}
"""
    install(site, "late", text)
    [fault] = faults("road bent from main { perturb with zigzag { amplitude: 3m } }", site)
    assert fault.code == "RL211"
    assert "roadlang_not_there" in fault.message


@pytest.mark.parametrize(
    ("key", "says"),
    [
        ("emit zigzag", "is `perturb zigzag`, not `emit zigzag`"),
        ("perturb zag", "is `perturb zigzag`, not `perturb zag`"),
    ],
)
def test_a_map_that_names_another_kind(site: Path, key: str, says: str) -> None:
    listed = GOOD.format(kind="zigzag").replace(
        "return [Zigzag]", f"return {{'{key}': 'roadlang_late:Zigzag'}}"
    )
    install(site, "late", listed)
    verb, name = key.split()
    text = f"emit {name}" if verb == "emit" else f"road bent from main {{ perturb with {name} }}"
    [fault] = faults(text, site)
    assert fault.code == "RL211"
    assert says in fault.message


def test_wrong_options_of_a_strangers_kind_are_explained_in_place(site: Path) -> None:
    install(site, "acme", ACME.read_text())
    found = faults(
        """agent ego is car on main at 5m {
  drive with acme.mpc { horizon: 2m, weights: [1], verbos: true, model: "none.onnx" }
}
expect comfort with acme.ride_comfort { agent: main, limit: 2.5m/s^2 }
""",
        site,
    )
    placed = [(fault.code, fault.span.line, fault.span.column) for fault in found if fault.span]
    assert placed == [
        ("RL201", 3, 34),
        ("RL208", 3, 47),
        ("RL220", 3, 52),
        ("RL450", 3, 73),
        ("RL228", 5, 48),
        ("RL201", 5, 61),
    ]


WAVES = """
from dataclasses import dataclass
from typing import ClassVar
from roadlang.api import Distribution, Extractor, Like, Sampler, hookimpl, option

@dataclass(frozen=True)
class Uniform(Distribution):
    '''Always the least.'''
    name: ClassVar[str] = "uniform"
    low: Like = option()
    high: Like = option()

@dataclass(frozen=True)
class Auto(Extractor):
    '''Finds nothing.'''
    name: ClassVar[str] = "auto"

@dataclass(frozen=True)
class Random(Sampler):
    '''Draws nothing.'''
    name: ClassVar[str] = "random"

@hookimpl
def roadlang_kinds():
    return [Uniform, Auto, Random]
"""


def test_what_goes_without_saying_stays_the_standard_kind(site: Path) -> None:
    install(site, "waves", WAVES)
    registry = load_registry()
    text = (
        ROAD
        + "road bent from main { perturb with sine { amplitude: 0m..3m, wavelength: 80m } }\n"
        + 'image plan from """\n####\n""" { scale: 8m/px, legend: { "#": road } }\n'
        + "network town from plan\n"
    )
    scenario, found = check_text(text, site / "scene.rl", {}, registry)
    assert found == []
    assert scenario is not None
    assert sample_scenes(scenario, registry, 1).accepted == 1


LATE = """
from roadlang.api import hookimpl

@hookimpl
def roadlang_kinds():
    return {"read xyz": "roadlang_not_there:Xyz"}
"""


def test_a_broken_reader_leaves_the_other_readers_working(site: Path) -> None:
    install(site, "late", LATE)
    (site / "points.csv").write_text("x,y\n0,0\n80,0\n160,10\n")
    assert faults('road spa from "points.csv"', site) == []


READER = """
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from roadlang.api import Reader, geometry, hookimpl


@dataclass(frozen=True)
class Xyz(Reader):
    \"\"\"Reads a table of points.\"\"\"

    name: ClassVar[str] = "xyz"
    suffixes: ClassVar[tuple[str, ...]] = (".xyz",)
    reads: ClassVar[tuple[str, ...]] = ("road",)

    def read(self, path: Path) -> geometry.Curve:
        raise NotImplementedError


@hookimpl
def roadlang_kinds():
    return [Xyz]
"""


def test_two_readers_of_strangers_are_both_named_and_nothing_else_is_said(site: Path) -> None:
    for name in ("early", "late"):
        install(site, name, READER)
    (site / "points.xyz").write_text("0 0")
    [fault] = faults('road spa from "points.xyz"', site)
    assert "a reader of .xyz files" in fault.message
    assert fault.help == ("write `read with early.xyz` or `read with late.xyz` in its block",)


def test_a_broken_reader_is_named_where_no_other_reads_the_file(site: Path) -> None:
    install(site, "late", LATE)
    (site / "points.xyz").write_text("0 0")
    [fault] = faults('road spa from "points.xyz"', site)
    assert fault.code == "RL211"
    assert "late-plugin 1.2" in fault.message


def test_a_broken_plugin_is_an_outside_failure(site: Path) -> None:
    install(site, "late", LATE)
    (site / "points.xyz").write_text("0 0")
    scene = site / "scene.rl"
    scene.write_text('road spa from "points.xyz"\n')
    assert run(["check", str(scene)]) == 5


def test_what_a_plugin_prints_stays_out_of_the_json(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    install(site, "loud", "print('Thank you for choosing Loud.')\n" + GOOD.format(kind="zigzag"))
    scene = site / "scene.rl"
    scene.write_text(ROAD)
    assert run(["check", str(scene), "--json"]) == 0
    captured = capsys.readouterr()
    assert json.loads(captured.out) == []
    assert "Thank you" in captured.err
