"""A map is a network; where it is taken for a road, the error says how to select a road."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang import testing


def test_a_map_is_read_as_a_network(tmp_path: Path) -> None:
    (tmp_path / "town.xodr").write_text("<OpenDRIVE/>")
    (found,) = testing.check('road main from "town.xodr"', folder=tmp_path)
    assert found.code == "RL214"
    assert found.help[0] == (
        '`network town from "town.xodr"` reads it; `road NAME from town` selects one of its roads'
    )


def test_what_nothing_reads_is_no_map(tmp_path: Path) -> None:
    (tmp_path / "town.xyz").write_text("points")
    (found,) = testing.check('road main from "town.xyz"', folder=tmp_path)
    assert found.code == "RL214"
    assert found.help[0].startswith("a road can be read from: .csv")


@pytest.mark.parametrize("written", ["3", '"3"'])
def test_a_road_is_chosen_by_its_id(written: str) -> None:
    plan = 'image plan from """\n####\n""" { scale: 20m/px }\nnetwork town from plan\n'
    (found,) = testing.check(f"{plan}road main from town {{ select: {written} }}")
    assert (found.code, found.help) == ("RL206", ("write `road(3)`",))
    assert [fix.replacement for fix in found.fixes] == ["road(3)"]
