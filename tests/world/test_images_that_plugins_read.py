"""Pictures that a reader kind gives: gray or in colors, and nothing else."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import DiagnosticError, LoadedScenario, testing
from roadlang.api import Reader
from roadlang.plugins.discovery import registry_of

TEXT = 'image photo from "photo.raw" { scale: 0.5m/px, read with raw }\nnetwork town from photo\n'


def pixels(channels: int) -> Any:
    shape = (40, 60) if channels == 1 else (40, 60, channels)
    image = np.full(shape, 40, np.uint8)
    image[15:25] = 220
    return image


@pytest.mark.parametrize("channels", [1, 3])
def test_gray_and_color_give_the_same_roads(channels: int, tmp_path: Path) -> None:
    @dataclass(frozen=True)
    class Raw(Reader):
        name: ClassVar[str] = "raw"
        reads: ClassVar[tuple[str, ...]] = ("image",)

        def read(self, path: Path) -> Any:
            assert path.read_bytes() == b"photo"
            return pixels(channels)

    (tmp_path / "photo.raw").write_bytes(b"photo")
    registry = registry_of({"acme": testing.plugin_of(Raw)})
    loaded = LoadedScenario(TEXT, tmp_path / "scene.rl", {}, registry)
    (road,) = loaded.sample(1)[0].roads.values()
    assert road.points[[0, -1], 0] == pytest.approx([0.0, 30.0], abs=2.5) or road.points[
        [-1, 0], 0
    ] == pytest.approx([0.0, 30.0], abs=2.5)
    assert road.y == pytest.approx(10.0, abs=0.6)
    assert road.width == pytest.approx(5.0, abs=0.6)


@pytest.mark.parametrize("channels", [2, 4, 5])
def test_other_channels_are_refused(channels: int, tmp_path: Path) -> None:
    @dataclass(frozen=True)
    class Raw(Reader):
        name: ClassVar[str] = "raw"
        reads: ClassVar[tuple[str, ...]] = ("image",)

        def read(self, path: Path) -> Any:
            return pixels(channels)

    (tmp_path / "photo.raw").write_bytes(b"photo")
    registry = registry_of({"acme": testing.plugin_of(Raw)})
    shapes = r"\(height, width, 3\) or \(height, width\) of uint8"
    with pytest.raises(DiagnosticError, match=f"RL474.*{shapes}"):
        LoadedScenario(TEXT, tmp_path / "scene.rl", {}, registry).sample(1)
