"""`read with opendrive`: files that cannot be right."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

import roadlang
from roadlang_formats.read_opendrive import OpenDriveMap
from tests.formats.small_maps import (
    crossing,
    lane,
    link,
    piece,
    road,
    section,
    straight,
    xodr,
)

FAULTS = {
    "no number": (straight(1, 0, 0).replace('length="60.0"><line', 'length="6O"><line'), "6O"),
    "not finite": (straight(1, 0, 0).replace('x="0"', 'x="nan"'), "nan"),
    "no pieces": (road(1, 60.0, ""), "planView"),
    "no length": (road(1, 1e-9, piece(0, 0, 0, 0.0, 60.0)), "road `1` is too short"),
    "no lanes": (straight(1, 0, 0, lanes=""), "no lane"),
    "a gap": (
        road(1, 60.0, piece(0, 0, 0, 0.0, 30.0) + piece(30, 35, 0, 0.0, 30.0)),
        "5 m away",
    ),
    "twice": (straight(1, 0, 0) + "\n" + straight(1, 0, 9), "two roads"),
    "far objects": (
        straight(1, 0, 0, inside='<objects><object type="tree" s="1" t="9e5"/></objects>'),
        "900000 m away",
    ),
    "huge objects": (
        straight(1, 0, 0, inside='<objects><object type="barrier" s="1" length="600"/></objects>'),
        "`length` of an object is 600 m, and 500 m is the most",
    ),
    "far copies": (
        straight(
            1,
            0,
            0,
            inside='<objects><object type="tree" s="1" t="9">'
            '<repeat s="0" length="9" distance="3" tEnd="900"/></object></objects>',
        ),
        "900 m away",
    ),
    "endless objects": (
        straight(
            1,
            0,
            0,
            9e5,
            inside='<objects><object type="tree" s="1" t="9">'
            '<repeat s="0" length="9e5" distance="0.01"/></object></objects>',
        ),
        "repeated 18,",
    ),
    "lane 2 alone": (straight(1, 0, 0, lanes=section(0, (), [lane(-2)])), "no lane -1"),
    "contact": (straight(1, 0, 0, inside=link(successor="road 1 middle")), "contactPoint"),
    "a vortex": (
        road(1, 90000.0, piece(0, 0, 0, 0.0, 90000.0, '<arc curvature="90"/>')),
        "turns too often",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_are_reported_with_their_lines(tmp_path: Path, fault: str) -> None:
    element, word = FAULTS[fault]
    path = tmp_path / "town.xodr"
    path.write_text(xodr("", element))
    with pytest.raises(roadlang.DiagnosticError) as caught:
        OpenDriveMap().read(path)
    (found,) = caught.value.diagnostics
    assert found.span is not None
    assert (found.code, found.span.source.path) == ("RL479", "town.xodr")
    assert found.span.line == (6 if fault == "twice" else 5)
    assert word in found.message
    assert ("objects: false" in "".join(found.help)) == ("object" in found.message)


def test_a_file_cut_off_is_reported_where_it_ends(tmp_path: Path) -> None:
    path = tmp_path / "town.xodr"
    path.write_text(crossing()[:1500])
    with pytest.raises(roadlang.DiagnosticError) as caught:
        OpenDriveMap().read(path)
    place = caught.value.diagnostics[0].span
    assert place is not None
    assert place.start >= 1400


def test_entities_are_refused_before_they_grow(tmp_path: Path) -> None:
    names = "abcdefghij"
    bomb = '<!DOCTYPE x [<!ENTITY a "lol">' + "".join(
        f'<!ENTITY {after} "{f"&{before};" * 10}">' for before, after in pairwise(names)
    )
    path = tmp_path / "town.xodr"
    path.write_text(f'<?xml version="1.0"?>\n{bomb}]>\n<OpenDRIVE>&j;</OpenDRIVE>')
    with pytest.raises(roadlang.DiagnosticError, match="entity `a`"):
        OpenDriveMap().read(path)
