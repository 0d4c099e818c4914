"""A file that is included under a name means what it means alone."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import roadlang

EXAMPLES = Path(__file__).parents[2] / "examples"
MEMBERS = (
    "values", "images", "networks", "roads", "agents", "objects", "requirements", "expectations",
)  # fmt: skip

ROAD = """\
road main { draw with segments { pieces: [straight(300m)] }, lanes: 2 }
agent ego is car on main at 20m { drive with lane_follow { speed: 8m/s..12m/s } }
"""
FILES = {
    "places by another": "agent lead is car on main at ahead_of(ego, 20m..30m)\n"
    "agent third is car at behind(lead, 5m)\n",
    "kinds as names": "agent truck is truck on main at 60m\nobject tree is tree on main at 5m\n",
    "words as names": "agent back is car on main at 200m { facing: back }\n"
    "let left = ego.speed > 3m/s\nobject bins is pole on main at 5m { side: left }\n",
    "functions as names": "agent behind is car at behind(ego, 5m)\n"
    "expect length: length(main) > 3m\n",
    "random as a name": "agent random is car on main at random\n",
    "weights": "let a = ego.speed < 9m/s\nlet b = ego.lane == -1\n"
    "expect c: always (a and b) { weights: { a: 3 } }\n",
}


def meaning(path: Path) -> str:
    scenario = roadlang.load(path).scenario
    return re.sub(r"Span\([^)]*\)", "", repr([getattr(scenario, name) for name in MEMBERS]))


def same_under_a_name(path: Path) -> None:
    main = path.with_name("main.rl")
    main.write_text(f'include "{path.name}" as q\nemit json\n')
    assert meaning(main).replace("q.", "") == meaning(path)


@pytest.mark.parametrize("text", FILES.values(), ids=FILES)
def test_a_file_means_the_same_under_a_name(text: str, tmp_path: Path) -> None:
    path = tmp_path / "part.rl"
    path.write_text(ROAD + text)
    same_under_a_name(path)


@pytest.mark.parametrize("name", ["traffic", "cut_in", "overtaking", "signals"])
def test_an_example_means_the_same_under_a_name(name: str, tmp_path: Path) -> None:
    for each in (name, "street"):  # which one of them includes
        (tmp_path / f"{each}.rl").write_text((EXAMPLES / f"{each}.rl").read_text())
    same_under_a_name(tmp_path / f"{name}.rl")


def test_nothing_is_left_out_without_a_word(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("roadlang.semantics.lower.actors.place_of", lambda *given: None)
    (tmp_path / "part.rl").write_text(ROAD)
    with pytest.raises(AssertionError, match="nothing says why ego is left out"):
        roadlang.load(tmp_path / "part.rl").scenario  # noqa: B018
