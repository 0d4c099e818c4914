"""Perturbed roads that leave a junction at a small angle do not run over each other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import cv2
import numpy as np
import pytest
import shapely

from benchmarks.junctions.perturbed import Faults
from benchmarks.junctions.random_networks import random_network
from roadlang.api import Extraction, Extractor, Picture
from roadlang.testing import sample
from roadlang.world.perturbing.beside_arms import kept_beside

RAMP = """
image plan from "town.png" { scale: 0.4m/px }
network town from plan { extract with made_up, lanes: 2 }
network bent from town { perturb with sine { amplitude: 0.5m..3m, wavelength: 40m..100m } }
"""


@dataclass(frozen=True)
class MadeUp(Extractor):
    """A ramp, whatever the picture shows."""

    name: ClassVar[str] = "made_up"

    def extract(self, picture: Picture) -> Extraction:
        """The network alone."""
        return Extraction(random_network("ramp", 6).network)


def test_a_ramp_stays_beside_its_road(tmp_path) -> None:  # type: ignore[no-untyped-def]
    cv2.imwrite(str(tmp_path / "town.png"), np.zeros((40, 40, 3), np.uint8))
    scenes = [one.record for one in sample(RAMP, 24, kinds=[MadeUp], seed=3, folder=tmp_path)]
    faults = Faults()
    for scene in scenes:
        faults.add(scene, scenes[0])
    assert faults.faulty == 0
    lines = [
        shapely.LineString(np.column_stack([road.x, road.y]))
        for scene in scenes
        for road in scene.roads
        if road.name == "bent/2"
    ]
    assert max(shapely.hausdorff_distance(lines[0], line) for line in lines[1:]) > 1.0


@pytest.mark.parametrize("most", [0.5, 3.0, 20.0])
def test_nothing_is_moved_farther_than_there_is_room(most: float) -> None:
    wave = most * np.sin(np.linspace(0.3, 9.0, 200))[None]
    room = np.linspace(0.0, 6.0, 200)
    kept = kept_beside(wave, room)
    assert (np.abs(kept) <= room + 1e-12).all()
    free = room >= 1.2 * np.abs(wave).max()
    assert (kept[0, free] == wave[0, free]).all()
