"""The embedded engine and Godot come to the same: on random bends, alone and in traffic."""

from __future__ import annotations

import pytest

from benchmarks.agreement.drives import in_embedded, in_godot
from benchmarks.agreement.measures import Agreement, Pair
from benchmarks.agreement.scenes import random_scenes
from tests.godot.godot_engines import require_engine

pytestmark = [pytest.mark.godot, pytest.mark.slow]


def test_both_engines_agree_on_random_scenes() -> None:
    require_engine()
    scenes = list(random_scenes(8, 18))
    found = Agreement.of(map(Pair.of, in_embedded(scenes), in_godot(scenes)))
    assert 2 <= found.failing <= 6, str(found)
    assert found.speed_rmse <= 0.25, str(found)
    assert found.lateral_correlation >= 0.95, str(found)
    assert min(found.right_failing, found.right_safe) >= 0.8, str(found)
