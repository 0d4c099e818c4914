"""Files of old Macs (CR ends a line), and names whose accents are characters of their own."""

from __future__ import annotations

from pathlib import Path

import pytest

import roadlang
from roadlang import testing
from roadlang.diagnostics import DiagnosticError
from roadlang.session.param_files import read_params

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } }"


def test_places_of_errors_have_the_lines_of_old_macs(tmp_path: Path) -> None:
    path = tmp_path / "a.rl"
    path.write_bytes(f"# a comment\r{ROAD}\r\rparam wide = 3mx\r".encode())
    with pytest.raises(DiagnosticError, match=r"RL203(.|\n)*a\.rl:4:14"):
        roadlang.load(path).sample()


def test_a_comment_ends_at_the_line_ends_of_old_macs(tmp_path: Path) -> None:
    path, included = tmp_path / "a.rl", tmp_path / "b.rl"
    path.write_bytes(b'# a comment\rinclude "b.rl"\r')
    included.write_bytes(f"# another\r{ROAD}\r".encode())
    (scene,) = roadlang.load(path).sample()
    assert [road.name for road in scene.record.roads] == ["main"]


def test_params_of_old_macs_have_lines(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_bytes(b"# of a run\rreach: 1m\rreach: 2m\r")
    with pytest.raises(DiagnosticError, match=r"p\.yaml:3:1"):
        read_params(str(path))


@pytest.mark.parametrize(("declared", "used"), [("e\u0301", "\u00e9"), ("\u00e9", "e\u0301")])
def test_one_name_in_two_spellings_is_one_fault(declared: str, used: str) -> None:
    text = f"{ROAD}\nagent caf{declared} is car on main at 5m\n"
    found = testing.check(f"{text}expect a: always (caf{used}.speed < 3m/s)\n")
    assert [(each.code, each.span.text) for each in found if each.span] == [
        ("RL007", f"caf{declared}")
    ]
