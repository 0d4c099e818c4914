"""`within`: a part of a network, with what stands in it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import DiagnosticError, testing
from roadlang.api import Region
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]
TOWN = '''
image plan from """
  ...#....T
  ...#.....
  #########
  ...#...B.
  ...#.....
""" { scale: 12m/px, legend: { "#": road, "T": tree, "B": building } }
'''


def refused(text: str, **options: Any) -> tuple[str, str]:
    """The code and the source text of the first diagnostic."""
    with pytest.raises(DiagnosticError) as caught:
        testing.sample(text, **options)
    (first, *_) = caught.value.diagnostics
    assert first.span is not None
    return first.code, first.span.text


def test_roads_objects_and_pixels_outside_are_gone(sample: Sample) -> None:
    text = (
        TOWN + "network town from plan { extract with pixels, within: box((10m, 8m), (100m, 45m)) }"
    )
    (scene,) = sample(
        text + "\nnetwork bent from town { perturb with sine { amplitude: 1m, wavelength: 40m } }\n"
    ).scenes
    (town, _) = scene.networks
    assert [thing.kind for thing in scene.objects] == ["building"]
    roads = [road for road in scene.roads if road.name in town.roads]
    assert len(roads) == 4
    every = np.concatenate([np.column_stack((road.x, road.y)) for road in roads])
    assert every.min(axis=0) == pytest.approx((10.0, 8.0), abs=1e-3)
    assert every.max(axis=0) == pytest.approx((100.0, 45.0), abs=1e-3)
    assert [len(junction.arms) for junction in town.junctions] == [4]


def test_the_box_may_be_drawn() -> None:
    text = TOWN + "network town from plan { within: box((0m, 0m), (60m..100m, 60m)) }"
    lengths = {
        round(sum(road.length for road in scene.record.roads), 3)
        for scene in testing.sample(text, 4)
    }
    assert len(lengths) == 4


def test_faults_of_the_option_are_at_their_places() -> None:
    town = TOWN + "network town from plan { within: WITHIN }\n"
    flat = town.replace("WITHIN", "box((0m, 0m), (60m, 0m))")
    assert refused(flat) == ("RL480", "(60m, 0m)")
    code, _ = refused(town.replace("WITHIN", "box((500m, 0m), (600m, 90m))"))
    assert code == "RL412"
    derived = (
        TOWN + "network town from plan\nnetwork part from town { within: box((0m, 0m), (9m, 9m)) }"
    )
    assert refused(derived)[1] == "within"


@dataclass(frozen=True)
class Odd(Region):
    """Gives what no region should."""

    name: ClassVar[str] = "odd"

    def contains(self, points: Any) -> Any:
        return points[:, 0]


def test_a_region_of_a_plugin_must_give_booleans() -> None:
    text = TOWN + "network town from plan { within: odd() }"
    assert refused(text, kinds=[Odd]) == ("RL474", "odd()")
