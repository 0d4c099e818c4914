"""The text of a requirement in a scene is the formatter's, however the file is laid out."""

from __future__ import annotations

import roadlang
from roadlang.diagnostics import Source
from roadlang.syntax import format_source

UNTIDY = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }
let k =   curvature( main )
require bend: G (
   abs(k)<0.5/m   # a note
   && width(main)>1m )
"""


def test_formatting_a_file_changes_no_text_in_its_scenes() -> None:
    tidy, _ = format_source(Source("scene.rl", UNTIDY))
    assert tidy is not None
    one, other = (roadlang.loads(text).sample()[0].record for text in (UNTIDY, tidy))
    assert one.requirements[0].text == "always (abs(k) < 0.5/m and width(main) > 1m)"
    assert one.signals[0].text == "curvature(main)"
    assert one.requirements == other.requirements
    assert one.signals == other.signals
