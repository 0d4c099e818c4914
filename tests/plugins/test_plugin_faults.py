"""What a plugin gives back is checked where it is used, and what it prints stays out of the way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang.api import (
    Distribution,
    Drawer,
    Like,
    Monitor,
    Perturber,
    Reader,
    Sampler,
    Selector,
    option,
)
from roadlang.diagnostics import DiagnosticError
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
BENT = STRAIGHT + "road bent from main { perturb with KIND }\n"
NEAR = "require near: always (deviation(bent, main) < 3m)\n"
SWAYING = (
    STRAIGHT + "road bent from main { perturb with sine { amplitude: DRAW, wavelength: 80m } }\n"
)
TOWN = """
image plan from \"\"\"
######
\"\"\" { scale: 8m/px, legend: { "#": road } }
network town from plan
"""


def kind(base: type, method: str, gives: Any, **members: Any) -> type:
    """A kind called `odd` whose `method` gives `gives`, or raises it."""

    def odd(self: Any, *given: Any, **named: Any) -> Any:
        if isinstance(gives, Exception):
            raise gives
        return gives

    still: dict[type, dict[str, Any]] = {
        Perturber: {"displacement": lambda self, road, random: 0.0 * road.stations},
        Sampler: {"points": lambda self, indices, draws, seed: np.zeros((len(indices), 0))},
    }
    annotations = dict.fromkeys(members, ClassVar[Any]) | {"name": ClassVar[str]}
    body = {**still.get(base, {}), **members, method: odd, "name": "odd"}
    made = type("Odd", (base,), {**body, "__annotations__": annotations, "__doc__": "Odd."})
    return dataclass(frozen=True)(made)


@dataclass(frozen=True)
class Odd(Distribution):
    """Its low and high are no bounds, and it says so."""

    name: ClassVar[str] = "odd"
    low: Like = option()
    high: Like = option()

    def quantile(self, uniform: Any) -> Any:
        return self.low + 100 * (self.high - self.low) * uniform


def failure(sample: Sample, text: str, *kinds: type) -> Any:
    with pytest.raises(DiagnosticError) as caught:
        sample(text, kinds=kinds)
    return caught.value.diagnostics[0]


@pytest.mark.parametrize("gives", [float("nan"), [1.0, 2.0, 3.0], [], -1.0])
def test_a_displacement_bound_that_is_none(sample: Sample, gives: Any) -> None:
    found = failure(
        sample, BENT.replace("KIND", "odd") + NEAR, kind(Perturber, "displacement_bound", gives)
    )
    assert found.code == "RL474"
    assert "perturb acme.odd" in found.message


def test_a_displacement_bound_that_raises(sample: Sample) -> None:
    odd = kind(Perturber, "displacement_bound", ValueError("boom"))
    found = failure(sample, BENT.replace("KIND", "odd") + NEAR, odd)
    assert found.code == "RL470"
    assert "ValueError: boom" in found.message


def test_only_standard_ranges_end_at_low_and_high(sample: Sample) -> None:
    result = sample(SWAYING.replace("DRAW", "odd(1m, 2m)") + NEAR, 4, kinds=(Odd,))
    amplitudes = [scene.draws["bent/perturb 1/amplitude"] for scene in result.scenes]
    assert all(abs(amplitude) < 3 for amplitude in amplitudes)


@pytest.mark.parametrize("gives", ["two", 1.5, [3]])
def test_a_sampler_whose_size_is_no_count(sample: Sample, gives: Any) -> None:
    found = failure(
        sample,
        SWAYING.replace("DRAW", "0m..1m") + "sample with odd\n",
        kind(Sampler, "size", gives),
    )
    assert found.code == "RL470"
    assert "sample acme.odd" in found.message


def test_a_drawer_that_draws_no_curve(sample: Sample) -> None:
    found = failure(sample, "road main { draw with odd }\n", kind(Drawer, "draw", "a line"))
    assert found.code == "RL474"
    assert "gave a str, not a Curve" in found.message


def test_a_selector_that_selects_no_path(sample: Sample) -> None:
    odd = kind(Selector, "select", None)
    found = failure(sample, TOWN + "road main from town { select: odd() }\n", odd)
    assert found.code == "RL474"
    assert "select acme.odd" in found.message


@pytest.mark.parametrize("statement", ["road", "network", "image"])
@pytest.mark.parametrize("gives", [None, "hello", np.zeros((2, 2)), []])
def test_a_reader_that_reads_something_else(
    sample: Sample, tmp_path: Path, statement: str, gives: Any
) -> None:
    file = tmp_path / "thing.odd"
    file.write_text("thing")
    odd = kind(Reader, "read", gives, suffixes=(".odd",), reads=(statement,))
    text = f'{statement} thing from "{file}" {{ read with odd }}\n'
    text = text.replace("{ read", "{ scale: 1m/px, read") if statement == "image" else text
    text += "network n from thing\nroad r from n\n" if statement == "image" else ""
    text += "road r from thing\n" if statement == "network" else ""
    found = failure(sample, text, odd)
    assert found.code == "RL474"
    assert "read acme.odd" in found.message


def test_a_monitor_that_gives_no_number(sample: Sample) -> None:
    odd = kind(Monitor, "robustness", [np.nan])
    found = failure(sample, STRAIGHT + "require calm with odd\n", odd)
    assert "gave a robustness that is not a number" in found.message


def test_what_a_kind_prints_goes_to_standard_error(
    sample: Sample, capsys: pytest.CaptureFixture[str]
) -> None:
    @dataclass(frozen=True)
    class Odd(Perturber):
        """Talks."""

        name: ClassVar[str] = "odd"

        def displacement(self, road: Any, random: Any) -> Any:
            print("so far so good")  # noqa: T201
            return 0.0 * road.stations

    assert sample(BENT.replace("KIND", "odd"), kinds=(Odd,)).accepted == 1
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "so far so good" in captured.err
