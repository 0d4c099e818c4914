"""Kinds that are made once for a scene get plain numbers as options, drawn ones as well."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import pytest

from roadlang import testing
from roadlang.api import (
    Backend,
    DiagnosticError,
    Drawer,
    Extractor,
    Integer,
    JunctionControl,
    Kind,
    Length,
    Number,
    Reader,
    RightOfWay,
    Searcher,
    Selector,
    option,
)
from roadlang.geometry import Curve
from tests.straight_road import STRAIGHT

SEEN: dict[str, list[tuple[type, ...]]] = {}
PLAN = '''image plan from """
..#..
#####
..#..
""" { scale: 25m/px, legend: { "#": road } }
'''


@dataclass(frozen=True)
class _Plain(Kind):
    """Writes down what its options are; not its methods' business."""

    name: ClassVar[str] = "plain"
    share: Number = option(0.5, help="a number")
    size: Length = option(2.0, help="a length")
    count: Integer = option(3, help="a whole number")

    def note(self) -> None:
        found = type(self.share), type(self.size), type(self.count)
        SEEN.setdefault(self.verb, []).append(found)


@dataclass(frozen=True)
class PlainDrawer(_Plain, Drawer):
    """Draws."""

    def draw(self, closed: bool) -> Curve:
        self.note()
        return Curve.through([(0.0, 0.0), (90.0, 0.0)], closed)


@dataclass(frozen=True)
class PlainReader(_Plain, Reader):
    """Reads."""

    def read(self, path: Path) -> Curve:
        self.note()
        return Curve.through([(0.0, 0.0), (90.0, 0.0)], False)


@dataclass(frozen=True)
class PlainExtractor(_Plain, Extractor):
    """Extracts."""

    def extract(self, picture: Any) -> Any:
        self.note()
        return picture.network([[(0.0, 1.0), (4.0, 1.0)]], 6.0)


@dataclass(frozen=True)
class PlainSelector(_Plain, Selector):
    """Selects."""

    def select(self, network: Any) -> Any:
        self.note()
        return network.longest()


@dataclass(frozen=True)
class PlainControl(_Plain, JunctionControl):
    """Controls."""

    def right_of_way(self, junction: Any) -> RightOfWay:
        self.note()
        return RightOfWay("right_first")


@dataclass(frozen=True)
class PlainBackend(_Plain, Backend):
    """Writes nothing of note."""

    def files(self, scene: Any) -> Mapping[str, str]:
        self.note()
        return {"txt": "nothing"}


@dataclass(frozen=True)
class PlainSearcher(_Plain, Searcher):
    """Searches for nothing."""

    def start(self, axes: Any, seed: int) -> Any:
        self.note()
        raise ArithmeticError


OPTIONS = "share: {}, size: {}, count: {}"
CONSTANT, DRAWN = OPTIONS.format("1", "3m", "2"), OPTIONS.format("0..1", "1m..3m", "integer(1, 4)")
SCENES = {
    "draw": (PlainDrawer, "road main { draw with plain { OPTIONS } }"),
    "extract": (PlainExtractor, PLAN + "network town from plan { extract with plain { OPTIONS } }"),
    "select": (PlainSelector, PLAN + "network town from plan\nroad main from town"
               " { select: plain(OPTIONS) }"),
    "control": (PlainControl, PLAN + "network town from plan { control with plain { OPTIONS } }"),
}  # fmt: skip


@pytest.mark.parametrize("options", [CONSTANT, DRAWN], ids=["constant", "drawn"])
@pytest.mark.parametrize("verb", SCENES)
def test_options_of_what_is_made_once_for_a_scene(verb: str, options: str) -> None:
    SEEN.clear()
    kind, text = SCENES[verb]
    testing.sample(text.replace("OPTIONS", options), kinds=[kind])
    assert set(SEEN[verb]) == {(float, float, int)}


def test_options_of_what_is_made_once_for_all_scenes(tmp_path: Path) -> None:
    SEEN.clear()
    (tmp_path / "line.raw").write_text("a line")
    text = f'road main from "line.raw" {{ read with plain {{ {CONSTANT} }} }}\n'
    text += f"emit plain {{ {CONSTANT} }}\n"
    scenes = testing.sample(text, 2, kinds=[PlainReader, PlainBackend], folder=tmp_path)
    scenes.emit(tmp_path / "out")
    assert set(SEEN) == {"read", "emit"}
    assert {found for all_ in SEEN.values() for found in all_} == {(float, float, int)}


def test_options_of_a_search() -> None:
    SEEN.clear()
    text = STRAIGHT + "agent ego is car on main at 9m..20m { drive with lane_follow }\n"
    text += "expect slow: always (ego.speed < 8m/s)\n"
    text += f"falsify with plain {{ expects: slow, {CONSTANT} }}\n"
    with pytest.raises(DiagnosticError, match="ArithmeticError"):
        testing.scenario(text, kinds=[PlainSearcher]).falsify(evaluations=2)
    assert {"falsify": [(float, float, int)]} == SEEN
