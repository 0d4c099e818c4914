"""The forms in which an author says what an option takes; a type checker understands them all."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

import pytest

from roadlang import testing
from roadlang.api import (
    FREQUENCY,
    PURE,
    AgentName,
    Angle,
    Length,
    ListOf,
    Perturber,
    Piece,
    PixelPoint,
    RoadBatch,
    RoadName,
    call_of,
    kind_of,
    list_of,
    map_of,
    one_of,
    option,
    quantity,
)
from roadlang.ir.dimension import Dimension
from roadlang.plugins.annotations import Annotation, read_annotation, type_of
from roadlang.plugins.option_types import (
    CallType,
    EntityType,
    FlagType,
    KindNameType,
    ListType,
    PointType,
    QuantityType,
    TextType,
    WordType,
)
from roadlang.plugins.options import schema_of
from tests.straight_road import STRAIGHT

LENGTH, ANGLE = type_of(Length), type_of(Angle)


@pytest.mark.parametrize(
    ("annotation", "meaning"),
    [
        (tuple[Length, ...], list_of(Length)),
        (ListOf[Length], list_of(Length)),
        (ListOf[ListOf[PixelPoint]], list_of(list_of(PixelPoint))),
        (dict[str, Length], map_of(Length)),
        (Length | Angle, one_of(Length, Angle)),
        (Length | None, Length),
        (Piece, call_of("piece")),
        (ListOf[Piece], list_of(call_of("piece"))),
        (Annotated[str, kind_of("object")], kind_of("object")),
        (Annotated[float, quantity(FREQUENCY)], quantity(FREQUENCY)),
        (Annotated[ListOf[Length], list_of(Length, at_least=2)], list_of(Length, at_least=2)),
        (Annotated[str, RoadName], RoadName),
        (Annotated[str, AgentName], AgentName),
    ],
)
def test_two_forms_of_one_type(annotation: Any, meaning: Any) -> None:
    assert type_of(annotation) == type_of(meaning)


@pytest.mark.parametrize(
    ("annotation", "meaning"),
    [
        (float, Annotation(type_of(float))),
        (int, Annotation(QuantityType(PURE, is_integer=True))),
        (bool, Annotation(FlagType())),
        (str, Annotation(TextType())),
        (Literal["left", "right"], Annotation(WordType(), ("left", "right"))),
        (Literal["left", "right"] | None, Annotation(WordType(), ("left", "right"))),
        (Length | Literal["auto"], Annotation(LENGTH, ("auto",))),
        (Length | Literal["auto"] | None, Annotation(LENGTH, ("auto",))),
        (ListOf[Length] | Literal["all"], Annotation(ListType(LENGTH), ("all",))),
        (Piece, Annotation(CallType("piece"))),
        (RoadName, Annotation(EntityType(("road",)))),
        (Annotated[str, kind_of("object")], Annotation(KindNameType("object"))),
    ],
)
def test_what_an_annotation_says(annotation: Any, meaning: Annotation) -> None:
    assert read_annotation(annotation) == meaning


@pytest.mark.parametrize(
    ("annotation", "says"),
    [
        (list[Length], "could be changed in place: write `tuple[Length, ...]`"),
        (list, "could be changed in place: write `tuple[Length, ...]`"),
        (set[Length], "could be changed in place: write `tuple[Length, ...]`"),
        (tuple[Length, Length], "`Point`, or `tuple[Length, ...]`"),
        (tuple, "`Point`, or `tuple[Length, ...]`"),
        (Literal[1, 2], "is not the type of an option"),
        (Literal["left", 2], "is not the type of an option"),
        (dict[int, Length], "is not the type of an option"),
        (complex, "is not the type of an option"),
        (ListOf[complex], "is not the type of an option"),
        (Any, "is not the type of an option"),
        (RoadBatch, "is not the type of an option"),
    ],
)
def test_an_annotation_that_is_no_option(annotation: Any, says: str) -> None:
    with pytest.raises(TypeError) as caught:
        type_of(annotation)
    assert says in str(caught.value)


@dataclass(frozen=True)
class Shift(Perturber):
    """Shifts a road aside, by the sum of all sizes."""

    name: ClassVar[str] = "sidestep"
    sizes: ListOf[Length] = option(at_least=2, minimum=0)
    side: Literal["left", "right"] = option("left")
    at: Length | Literal["middle"] | None = option(None)

    def displacements(self, roads: Any, random: Any) -> Any:
        """(1, stations) meters."""
        assert self.at in (None, "middle", 7.0)
        sign = 1.0 if self.side == "left" else -1.0
        return sign * sum(self.sizes) + 0.0 * roads.stations


def shifted(options: str) -> float:
    text = STRAIGHT + f"road bent from main {{ perturb with sidestep {{ {options} }} }}\n"
    (scene,) = testing.sample(text, kinds=[Shift])
    return float(scene.roads["bent"].y[0])


def test_plain_annotations_work_in_a_scene() -> None:
    assert shifted("sizes: [1m, 2m]") == pytest.approx(3.0)
    assert shifted("sizes: [1m, 2m], side: right, at: middle") == pytest.approx(-3.0)
    assert shifted("sizes: [1m, 2m, 3m], at: 7m") == pytest.approx(6.0)


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ("sizes: [1m]", "RL208"),
        ("sizes: [1m, -2m]", "RL208"),
        ("sizes: [1m, 2m], side: up", "RL223"),
        ("sizes: [1m, 2m], at: end", "RL223"),
    ],
)
def test_plain_annotations_are_checked(options: str, code: str) -> None:
    text = STRAIGHT + f"road bent from main {{ perturb with sidestep {{ {options} }} }}\n"
    assert [found.code for found in testing.check(text, kinds=[Shift])] == [code]


def test_words_of_a_literal_are_words_of_the_option() -> None:
    sizes, side, at = schema_of(Shift)
    assert sizes.type == ListType(LENGTH, at_least=2)
    assert side.words == ("left", "right")
    assert at.words == ("middle",)


TYPED = '''
"""A plugin as its author writes it, with nothing to ignore."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from roadlang.api import (
    FREQUENCY,
    PURE,
    AgentName,
    BatchRandom,
    Control,
    Controller,
    Length,
    ListOf,
    Monitor,
    Observation,
    Perturber,
    PixelPoint,
    Reader,
    RoadBatch,
    RoadName,
    Signal,
    Trace,
    geometry,
    option,
    quantity,
)

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Shift(Perturber):
    name: ClassVar[str] = "sidestep"
    sizes: ListOf[Length] = option(at_least=1)
    leave_out: tuple[ListOf[PixelPoint], ...] = option(())
    side: Literal["left", "right"] = option("left")

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        return sum(self.sizes) + 0.0 * roads.stations


@dataclass(frozen=True)
class Bend(Signal):
    name: ClassVar[str] = "bend"
    unit: ClassVar[str] = "1/m"
    road: RoadName = option()

    def values(self) -> Floats:
        return np.abs(self.road.WRONGcurvature)


@dataclass(frozen=True)
class Calm(Monitor):
    name: ClassVar[str] = "calm"
    domain: ClassVar[str] = "drive"
    agent: AgentName = option()

    def judge(self, trace: Trace) -> float:
        return 9.0 - float(self.agent.speed.max())


@dataclass(frozen=True)
class Steer(Controller):
    name: ClassVar[str] = "steer"
    gain: Annotated[float, quantity(FREQUENCY)] = option(1.0)

    def control(self, observation: Observation) -> Control:
        return Control(-self.gain * observation.cross_track_error, 0.0)


@dataclass(frozen=True)
class Line(Reader):
    name: ClassVar[str] = "line"

    def read(self, path: Path) -> geometry.Curve:
        return geometry.Curve.through(np.loadtxt(path))
'''


@pytest.mark.slow
def test_a_typed_plugin_needs_no_ignores(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    (tmp_path / "right.py").write_text(TYPED.replace("WRONG", ""))
    (tmp_path / "wrong.py").write_text(TYPED.replace("WRONG", "x_"))
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file", ""]
    command += ["--cache-dir", os.devnull, "right.py", "wrong.py"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 1, done.stdout + done.stderr
    faults = [line for line in done.stdout.splitlines() if ": error: " in line]
    assert all(line.startswith("wrong.py:") for line in faults), done.stdout
    assert any('"RoadBatch" has no attribute "x_curvature"' in line for line in faults)


@pytest.mark.parametrize(
    ("point", "dimensions"),
    [
        (PointType(FREQUENCY), [FREQUENCY] * 2),
        (PointType(FREQUENCY, PURE), [FREQUENCY, PURE]),
        (PointType(FREQUENCY, in_space=True), [FREQUENCY] * 3),
    ],
)
def test_the_parts_of_a_point_have_its_dimensions(
    point: PointType, dimensions: list[Dimension]
) -> None:
    assert [part.dimension for part in point.parts] == dimensions
