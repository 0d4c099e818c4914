"""Pictures are extracted again only where they, or how they are read, have changed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import cv2
import numpy as np
from numpy.typing import NDArray

from roadlang import LoadedScenario, testing
from roadlang.api import Extractor, Length, option
from roadlang.plugins.discovery import registry_of
from roadlang_standard.extract_auto import Auto
from roadlang_standard.extract_onnx import OnnxExtractor

TEXT = 'image photo from "photo.png" { scale: 0.5m/px }\nnetwork town from photo '
seen: list[tuple[int, float]] = []


@dataclass(frozen=True)
class Strip(Extractor):
    name: ClassVar[str] = "strip"
    is_pure: ClassVar[bool] = True
    width: Length = option(5.0)

    def extract(self, picture: Any) -> Any:
        row = int(picture.pixels[:, 0, 0].argmax())
        seen.append((row, self.width))
        return picture.network([np.array([[0.0, row], [80.0, row]])], self.width * 2.0)


WIDTHS = [5.0, 7.0]


@dataclass(frozen=True)
class Elsewhere(Extractor):
    """Looks at more than the picture and its options, as extractors may."""

    name: ClassVar[str] = "elsewhere"

    def extract(self, picture: Any) -> Any:
        return picture.network([np.array([[0.0, 9.0], [80.0, 9.0]])], 2.0 * WIDTHS.pop(0))


def photo(row: int) -> NDArray[np.uint8]:
    pixels = np.zeros((60, 90, 3), np.uint8)
    pixels[row] = 255
    return pixels


def test_the_same_picture_is_extracted_once(tmp_path: Path) -> None:
    registry = registry_of({"acme": testing.plugin_of(Strip)})

    def road(row: int, options: str = "") -> tuple[float, float]:
        cv2.imwrite(str(tmp_path / "photo.png"), photo(row))
        text = TEXT + "{ extract with strip" + options + " }\n"
        scene = LoadedScenario(text, tmp_path / "scene.rl", {}, registry).sample(1)[0]
        (found,) = scene.roads.values()
        return float(found.y[0]), float(found.width[0])

    seen.clear()
    first, other = road(20), road(30)
    assert first[0] - other[0] == 5.0
    assert (road(20), road(30), road(20)) == (first, other, first)
    assert road(20, " { width: 6m }") == (first[0], 6.0)
    assert seen == [(20, 5.0), (30, 5.0), (20, 6.0)]


def test_an_extractor_that_does_not_say_that_it_is_pure_is_asked_again(tmp_path: Path) -> None:
    registry = registry_of({"acme": testing.plugin_of(Elsewhere)})
    cv2.imwrite(str(tmp_path / "photo.png"), photo(20))
    text = TEXT + "{ extract with elsewhere }\n"
    loaded = LoadedScenario(text, tmp_path / "scene.rl", {}, registry)
    roads = [next(iter(loaded.sample(1)[0].roads.values())) for _ in range(2)]
    assert [float(road.width[0]) for road in roads] == [5.0, 7.0]


def test_a_network_of_the_user_may_change() -> None:
    assert Auto.is_pure
    assert not OnnxExtractor.is_pure
