"""`roadlang extract IMAGE --edit SCENE`, and the text that the page writes."""

from __future__ import annotations

import re
import subprocess
import sys
import urllib.request
from pathlib import Path

import cv2
import numpy as np
import pytest
from click.testing import CliRunner, Result

from roadlang.cli.extract import command
from roadlang.diagnostics import DiagnosticError
from roadlang.syntax.correction_edits import (
    WrittenCorrections,
    corrections_of,
    with_corrections,
)

ALL = WrittenCorrections((((1.0, 2.0), (3.25, 4.0)),), (((5.0, 6.0),),), ((7.0, 8.0),))
NOTHING = WrittenCorrections()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    picture = np.full((60, 120, 3), 255, np.uint8)
    cv2.line(picture, (0, 30), (119, 30), (0, 0, 0), 7)
    cv2.imwrite(str(tmp_path / "plan.png"), picture)
    return tmp_path


@pytest.mark.parametrize(
    "text",
    [
        "network town from photo\n",
        "network town from photo {}\n",
        "network town from photo { lanes: 2 }\n",
        "network town from photo { extract with contour, lanes: 2 }\n",
        "network town from photo {\n    lanes: 2  # two\n}\n",
        "network town from photo {\r\n  lanes: 2\r\n}\r\nroad a from town\r\n",
    ],
)
def test_corrections_are_written_read_and_taken_back(text: str) -> None:
    written = with_corrections(text, "town", ALL)
    assert written is not None
    found = corrections_of(written, "town")
    assert found == WrittenCorrections((((1.0, 2.0), (3.2, 4.0)),), ALL.dismissed, ALL.confirmed)
    assert with_corrections(written, "town", found) == written
    taken_back = with_corrections(written, "town", NOTHING)
    assert taken_back is not None
    assert corrections_of(taken_back, "town") == NOTHING
    if "{" in text and "{}" not in text:
        assert taken_back == text


@pytest.mark.parametrize(
    "value", ["[[(a, 2px), (3px, 4px)]]", "roads", "[(1m, 2m)]", "[[(1px + 1px, 2px)]]"]
)
def test_corrections_that_are_no_numbers_are_not_read(value: str) -> None:
    assert corrections_of(f"network town from photo {{ drawn: {value} }}\n", "town") is None


def edited(*words: object) -> Result:
    return CliRunner().invoke(command, [str(word) for word in words])


def test_a_scene_file_is_begun_and_served_until_the_page_is_closed(folder: Path) -> None:
    words = ("extract", "plan.png", "--edit", "a.rl", "--scale", "0.5", "--no-browser")
    with subprocess.Popen(
        [sys.executable, "-m", "roadlang", *words], cwd=folder, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    ) as process:  # fmt: skip
        assert process.stdout is not None
        address = process.stdout.readline().strip()
        assert re.fullmatch(r"http://127\.0\.0\.1:\d+/[\w-]{20,}/", address)
        nothing = b'{"drawn": [], "dismissed": [], "confirmed": []}'
        urllib.request.urlopen(urllib.request.Request(address + "done", data=nothing)).close()
        assert process.wait() == 0
    scene = (folder / "a.rl").read_text()
    assert scene == 'image photo from "plan.png" { scale: 0.5m/px }\nnetwork town from photo\n'


@pytest.mark.parametrize(
    ("scene", "code"),
    [
        ("world { traffic: left }", "RL440"),
        (
            'image p from "plan.png" { scale: 1m/px }\n'
            "network n from p { extract with contour { blur: uniform(0px, 1px) } }",
            "RL229",
        ),
        (
            'image p from "plan.png" { scale: 1m/px }\n'
            "let x = 3px\nnetwork n from p { confirmed: [(x, x)] }",
            "RL441",
        ),
    ],
)
def test_networks_that_cannot_be_corrected_are_refused(folder: Path, scene: str, code: str) -> None:
    (folder / "a.rl").write_text(scene + "\n")
    done = edited(folder / "plan.png", "--edit", folder / "a.rl", "--no-browser")
    assert isinstance(done.exception, DiagnosticError)
    assert done.exception.diagnostics[0].code == code


@pytest.mark.parametrize("words", [("--width", "3"), ("-o", "a.json"), ("--only-through",)])
def test_options_of_the_extractor_are_refused_beside_it(
    folder: Path, words: tuple[str, ...]
) -> None:
    done = edited(folder / "plan.png", "--edit", folder / "a.rl", "--no-browser", *words)
    assert done.exit_code == 2
    assert "--edit" in done.output
    assert not (folder / "a.rl").exists()


def test_a_new_scene_file_needs_a_scale(folder: Path) -> None:
    done = edited(folder / "plan.png", "--edit", folder / "a.rl", "--no-browser")
    assert done.exit_code == 2
    assert "--scale" in done.output
