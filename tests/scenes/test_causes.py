"""What is said to be in the way of all scenes, and how much is placed to find that out."""

from __future__ import annotations

import numpy as np
import pytest

import roadlang
from roadlang.world.placement.placement_without_overlap import Arrangement

ROAD = "road main { draw with segments { pieces: [straight(60m)] }, lanes: 2 }\n"
CROWD = ROAD + "agent cars is car on main at 5m..55m { lane: -1, count: 40, drive with traffic }\n"


def test_a_crowd_that_was_judged_is_placed_once_more_to_say_what_is_in_the_way(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    placed: list[int] = []
    place = Arrangement._found

    def counted(self: Arrangement, actor: object) -> object:
        placed.append(self.candidates.count)
        return place(self, actor)  # type: ignore[arg-type]

    monkeypatch.setattr(Arrangement, "_found", counted)
    with pytest.raises(roadlang.NoSceneError) as caught:
        roadlang.loads(CROWD).sample(1)
    found = caught.value.result.result
    assert found.causes == ("copies of `cars` are in the way of each other",)
    assert sum(placed) == found.candidates + 1


@pytest.mark.parametrize("first", range(3))
def test_a_candidate_that_is_violated_is_found_wherever_it_is(first: int) -> None:
    from roadlang.scenes import sampling

    class Few:
        def __init__(self, rows: np.ndarray) -> None:
            self.rows, self.count = rows, len(rows)

        def take(self, rows: np.ndarray) -> Few:
            return Few(self.rows[rows])

    class Requires:
        def rho(self, few: Few) -> np.ndarray:
            return np.where(few.rows == first, -1.0, 1.0)

    found = sampling._violating(Requires(), Few(np.arange(3)), True)  # type: ignore[arg-type]
    assert found.rows.tolist() == [first]  # type: ignore[union-attr]
    assert sampling._violating(Requires(), Few(np.arange(3)), False) is None  # type: ignore[arg-type]
    alone = sampling._violating(Requires(), Few(np.array([first])), False)  # type: ignore[arg-type]
    assert alone is not None
