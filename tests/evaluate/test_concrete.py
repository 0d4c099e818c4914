"""Values of one candidate, as a scene file in JSON has them."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest

from roadlang import testing
from roadlang.evaluate.concrete import concrete


@pytest.mark.parametrize(
    ("value", "written"),
    [
        (math.inf, "inf"),
        (-math.inf, "-inf"),
        (2.5, 2.5),
        ((1.0, -math.inf), [1.0, "-inf"]),
        ({"a": math.inf, "b": "left"}, {"a": "inf", "b": "left"}),
        (None, None),
    ],
)
def test_json_has_no_infinity(value: Any, written: Any) -> None:
    assert concrete(value) == written


def test_conditions_compare_with_the_greatest_number() -> None:
    (scene,) = testing.sample("""
road main { draw with segments { pieces: [straight(90m)] }, lanes: 2 }
agent ego is car on main at 9m {
  drive with lane_follow { speed: 9m/s }
  drive with brake { when: ego.speed < inf and ego.speed > -inf }
}
""")
    text = json.dumps(json.loads(scene.to_json())["agents"][0]["drive"])
    assert "1.7976931348623157e+308" in text
    assert "-1.7976931348623157e+308" in text
    assert "Infinity" not in text
