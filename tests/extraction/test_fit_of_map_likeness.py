"""The benchmark fits the weights of maps by what the other rules leave sure."""

from __future__ import annotations

from pathlib import Path

import cv2
import pytest

from benchmarks.extraction import likeness
from roadlang_standard.extraction.doubts import drawn_confidence
from roadlang_standard.extraction.doubts.road_likeness import MAP_LIKENESS
from tests.extraction.drawn_maps import CARTO, drawn_map


@pytest.mark.parametrize("of_maps", [True, False])
def test_a_map_is_judged_by_the_model_of_maps_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, of_maps: bool
) -> None:
    cv2.imwrite(str(tmp_path / "map.png"), drawn_map(CARTO)[:, :, ::-1])
    # What the model says now is no fact of a picture: the next fit must not depend on it.
    monkeypatch.setattr(drawn_confidence, "sure_like_map", lambda found: 0.0)
    argv = ["likeness", *(["--maps"] if of_maps else [])]
    argv += ["--roads", str(tmp_path), "--none", str(tmp_path)]
    judged = []
    monkeypatch.setattr(likeness, "report", lambda found, names: judged.append((found, names)))
    monkeypatch.setattr("sys.argv", argv)
    likeness.main()
    [(found, names)] = judged
    assert [one.is_roads for one in found] == ([True, False] if of_maps else [])
    assert all(one.sure and len(one.facts) == len(MAP_LIKENESS) for one in found)
    assert (names is MAP_LIKENESS) is of_maps
