"""What actors of drawn kinds draw for their options is in the scene, whichever kind others have."""

from __future__ import annotations

from roadlang import testing

TEXT = """scenario kinds
road main { draw with segments { pieces: [straight(400m)] }, lanes: 2 }
object boxes is choice(box, rock) on main at 10m..300m {
  count: integer(0, 4), length: choice(0.5m, 0.6m..0.9m), overlap: true
}
object one is choice(box, rock) on main at 390m { length: 0.6m..0.9m, overlap: true }
agent cars is choice(car, van, bicycle) on main at 10m..300m {
  count: integer(1, 4), length: 1m..2m, overlap: true
}
"""


def test_every_copy_of_every_kind_has_its_draws_in_a_scene_alone_and_among_others() -> None:
    scenes = testing.sample(TEXT, n=20, seed=3)
    for scene in scenes:
        drawn = scene.draws
        assert "one/length" in drawn
        for name in ("boxes", "cars"):
            lengths = [place for place in drawn if place.startswith(f"{name}/length[")]
            assert len(lengths) == drawn[f"{name}/count"]
    for count in (1, 2, 7):
        few = testing.sample(TEXT, n=count, seed=3)
        assert [scene.draws for scene in few] == [scene.draws for scene in scenes[:count]]
