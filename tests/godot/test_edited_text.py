"""A drag changes the text only where it ends elsewhere than it began."""

from __future__ import annotations

import pytest

import roadlang
from roadlang.commands import handles_of
from roadlang_godot.editing.edited_text import EditedText
from roadlang_godot.editing.live import HandEdit

TEXT = """road main { draw with segments { pieces: [straight(200m)] } }
agent ego is car on main at 10m..190m { drive with stanley }
object kiosk is building at (20.004m, 30m)
"""
NETWORK = """image plan from \"\"\"
.....#.....
.....#.....
.#########.
.....#.....
\"\"\" { scale: 12m/px, legend: { "#": road } }
network main from plan { lanes: 2 }
"""


@pytest.mark.parametrize("text", [TEXT, NETWORK])
def test_a_drag_that_ends_where_it_began_changes_nothing(text: str) -> None:
    scene = roadlang.loads(text).sample(1, seed=0)[0].record
    for number, handle in enumerate(handles_of(text, scene)):
        edited = EditedText(text)
        x, y = handle.x, handle.y
        assert edited.take(HandEdit("move", handle, (x + 5.0, y + 5.0), number, False), scene)
        assert edited.shown != text
        assert edited.take(HandEdit("move", handle, (x + 1e-4, y), number, True), scene)
        assert edited.text == edited.shown == text
        edited.take(HandEdit("undo"), scene)
        assert edited.text == text


@pytest.mark.parametrize(
    "block",
    [
        "{ perturb with nudges { at: [50m], by: [(1m, 2m)] }, width: 6m }",
        "{\n  # moved\n  perturb with nudges { at: [50m], by: [(1m, 2m)] } }",
    ],
)
def test_the_removal_of_a_moved_place_is_undone(block: str) -> None:
    text = f"road m {{ draw with segments {{ pieces: [straight(90m)] }} }}\nroad a from m {block}\n"
    scene = roadlang.loads(text).sample(1, seed=0)[0].record
    (moved,) = [handle for handle in handles_of(text, scene) if handle.station == 50.0]
    edited = EditedText(text)
    assert edited.take(HandEdit("remove", moved), scene)
    assert "nudges" not in edited.text
    assert len(roadlang.loads(edited.text).sample()[0].roads) == 2
    edited.take(HandEdit("undo"), scene)
    assert edited.text == text
