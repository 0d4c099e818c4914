"""The roads of a picture of a scene file, with corrections and without."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.candidates import fixed_candidate
from ..files.writing import replace_file
from ..geometry import GeometryError
from ..geometry.arrays import Floats
from ..geometry.networks.corrections import Corrections, corrected
from ..ir.picture import Picture
from ..ir.scenario import FileSource, ScenarioImage, ScenarioNetwork
from ..session.loading import LoadedScenario, load
from ..session.scene_files import read_scene_file
from ..syntax.correction_edits import (
    Line,
    WrittenCorrections,
    corrections_of,
    with_corrections,
)
from ..world.index import index_scenario
from ..world.networks.networks import found_in_picture

_STEP = 2.0
"""Pixels between the points of a road on the page."""


@dataclass(frozen=True, eq=False)
class PictureRoads:
    """`network`: what was found in `picture`, for the network called `name` of the scene file."""

    path: Path
    name: str
    picture: Picture
    network: Any
    remarks: tuple[str, ...]

    @classmethod
    def of(cls, path: Path, image: Path) -> PictureRoads:
        """Those of the first network of a scene file that is extracted from this picture.

        Raises DiagnosticError for what is wrong with the file, RL440 where there is no such
        network, and RL229 where it is another in every scene.
        """
        text = read_scene_file(str(path))
        loaded = load(path)
        scenario = index_scenario(loaded.scenario, loaded.registry)
        for network in scenario.networks.values():
            source = scenario.source_of(network)
            if isinstance(source, ScenarioImage) and _shows(source, image):
                return cls._found(path, text, network, loaded)
        raise DiagnosticError(diagnose(Code.PICTURE_NOT_USED, path=str(path), image=str(image)))

    @classmethod
    def _found(
        cls, path: Path, text: str, network: ScenarioNetwork, loaded: LoadedScenario
    ) -> PictureRoads:
        scenario = index_scenario(loaded.scenario, loaded.registry)
        if scenario.is_varying(network.name):
            what = f"`{network.name}`"
            expected = "the same in every scene, so that its roads can be corrected"
            raise DiagnosticError(
                diagnose(Code.MUST_NOT_BE_RANDOM, network.span, what=what, expected=expected)
            )
        if corrections_of(text, network.name) is None:
            raise DiagnosticError(
                diagnose(Code.CORRECTIONS_NOT_NUMBERS, network.span, name=network.name)
            )
        found, loaded_picture = found_in_picture(network, fixed_candidate(scenario))
        picture = loaded_picture.picture
        return cls(path, network.name, picture, found.network, found.remarks)

    def written(self) -> WrittenCorrections:
        """The corrections that the scene file has now."""
        found = corrections_of(read_scene_file(str(self.path)), self.name)
        return WrittenCorrections() if found is None else found

    def roads(self, corrections: WrittenCorrections) -> dict[str, Any]:
        """What the page shows: roads in pixels, and points that no road is near."""
        world = Corrections(
            tuple(self._world(line) for line in corrections.drawn),
            tuple(self._world(line) for line in corrections.dismissed),
            self._world(corrections.confirmed),
        )
        try:
            after = corrected(self.network, world)
        except GeometryError as error:
            return {"error": f"This road cannot be drawn: {error}."}
        missed = self._pixels(np.array(after.missed).reshape(-1, 2))
        return {
            "roads": [self._road(edge) for edge in after.network.edges],
            "missed": missed.round(1).tolist(),
        }

    def found_roads(self) -> list[dict[str, Any]]:
        """Those of the extractor, without corrections."""
        return [self._road(edge) for edge in self.network.edges]

    def save(self, corrections: WrittenCorrections) -> None:
        """Write the corrections into the scene file, as it is now. Raises DiagnosticError."""
        text = with_corrections(read_scene_file(str(self.path)), self.name, corrections)
        if text is None:
            raise DiagnosticError(
                diagnose(Code.CORRECTIONS_NOT_NUMBERS, None, path=str(self.path), name=self.name)
            )
        replace_file(self.path, text)

    def _world(self, line: Line) -> Floats:
        pixels = np.array(line, dtype=np.float64).reshape(-1, 2)
        return self.picture.to_world(self.picture.from_file(pixels))

    def _pixels(self, points: Floats) -> Floats:
        """Of the file, where points (n, 2) in meters are."""
        return self.picture.to_file(self.picture.to_pixels(points))

    def _road(self, edge: Any) -> dict[str, Any]:
        curve, scale = edge.curve, self.picture.file_scale
        points = self._pixels(curve.at(curve.stations(spacing=_STEP * scale)))
        points = np.vstack([points, points[:1]]) if curve.closed else points
        return {
            "id": edge.id,
            "points": points.round(1).tolist(),
            "width": round(float(np.mean(edge.widths)) / scale, 2),
            "confidence": round(float(edge.confidence), 3),
        }


def _shows(image: ScenarioImage, path: Path) -> bool:
    source = image.source
    return isinstance(source, FileSource) and Path(source.resolved).resolve() == path.resolve()
