"""What each pass leaves is checked, with the pass named, and can be seen."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import pytest

from roadlang.api import Extraction, Extractor, Perturber, Picture, RoadBatch
from roadlang.diagnostics import DiagnosticError
from roadlang.geometry import Curve, RoadNetwork
from roadlang.ir.values import PassCall
from roadlang.scenes.sampling import SamplingResult
from tests.straight_road import STRAIGHT

if TYPE_CHECKING:
    from numpy.typing import NDArray

Sample = Callable[..., SamplingResult]
PLAN = 'image plan from """\n####################\n""" { scale: 10m/px }\n'
PASSES = (
    PLAN
    + "network lane from plan\n"
    + "network wavy from lane { perturb with bump { at: 60m, length: 60m, height: 1m..3m } }\n"
    + "road main from wavy\n"
    + "road bumpy from main {\n"
    + "  perturb with sine { amplitude: 0m..1m, wavelength: 80m }\n"
    + "  perturb with bump { at: 100m, length: 60m, height: 2m } }\n"
)


def test_passes_are_seen_in_order_also_those_that_read_files(
    sample: Sample, tmp_path: Path
) -> None:
    (tmp_path / "line.csv").write_text("x,y\n0,0\n50,1\n100,0\n150,3\n")
    seen: list[tuple[str, str]] = []

    def watch(scene: int, call: PassCall, made: Any) -> None:
        seen.append((call.place, str(getattr(made, "name", type(made).__name__))))

    sample('road side from "line.csv"\n' + PASSES, 1, after_pass=watch)
    assert sorted(seen) == [
        ("bumpy/perturb 1", "bumpy"),
        ("bumpy/perturb 2", "bumpy"),
        ("lane/extract 1", "Extraction"),
        ("side/read 1", "Curve"),
        ("wavy/perturb 1", "wavy/1"),
    ]
    places = [place for place, _ in seen]
    chain = ("lane/extract 1", "wavy/perturb 1", "bumpy/perturb 1", "bumpy/perturb 2")
    assert [place for place in places if place in chain] == list(chain)


@dataclass(frozen=True)
class Broken(Extractor):
    """A road whose points are no numbers."""

    name: ClassVar[str] = "broken"

    def extract(self, picture: Picture) -> Extraction:
        found = picture.network([np.array([(0.0, 0.0), (9.0, 0.0)])])
        (edge,) = found.network.edges
        points = edge.curve.points.copy()
        points[0] = np.nan
        curve = Curve(edge.curve.spline, False, points)
        network = RoadNetwork(found.network.nodes, (replace(edge, curve=curve),))
        return replace(found, network=network)


def test_coordinates_that_are_not_finite_are_the_fault_of_the_pass(sample: Sample) -> None:
    text = PLAN + "network lane from plan { extract with acme.broken }\nroad main from lane\n"
    with pytest.raises(DiagnosticError) as raised:
        sample(text, kinds=(Broken,))
    (found,) = raised.value.diagnostics
    assert found.code == "RL474"
    assert "`extract acme.broken`" in found.message
    assert "not finite" in found.message
    assert found.span is not None
    assert found.span.text.startswith("extract")


@dataclass(frozen=True)
class Lift(Perturber):
    """A meter to the left on the interval of the pass: one candidate at a time."""

    name: ClassVar[str] = "lift"

    def displacement(self, road: RoadBatch, random: np.random.Generator) -> NDArray[np.float64]:
        assert road.interval is not None
        low, high = (float(np.asarray(end).reshape(-1)[0]) for end in road.interval)
        assert all(np.size(end) == 1 for end in road.interval)
        return np.where((road.stations >= low) & (road.stations <= high), 1.0, 0.0)


@pytest.mark.parametrize(
    "earlier", ["", "perturb with sine { amplitude: 0m..1m, wavelength: 80m }"]
)
def test_a_perturber_of_one_candidate_gets_the_interval_of_that_candidate(
    sample: Sample, earlier: str
) -> None:
    text = (
        f"{STRAIGHT}param low = 20m..80m\nroad lifted from main {{ {earlier}\n"
        "  perturb with acme.lift { over: [low, 150m] }\n}\n"
        "require high: eventually (deviation(lifted, main) > 0.5m)\n"
    )
    for scene in sample(text, 4, kinds=(Lift,)).scenes:
        road = next(road for road in scene.roads if road.name == "lifted")
        before = np.array(road.reference_stations) < scene.values["low"] - 1e-9
        quiet = np.abs(np.array(road.y))[before]
        assert quiet.max() <= (1.0 if earlier else 1e-9)
