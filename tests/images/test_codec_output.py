"""libjpeg and libpng print nothing of damaged pictures: a diagnostic says what is wrong."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from contextlib import suppress
from pathlib import Path

import cv2
import numpy as np
import pytest

import roadlang
from roadlang import DiagnosticError
from roadlang.images.codec_output import codec_output
from roadlang.images.image_file import open_image

NOISE = np.random.default_rng(1).integers(0, 255, (60, 80, 3), np.uint8)


def threads(monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    """Runners of tests may have threads of their own."""
    monkeypatch.setattr(threading, "active_count", lambda: count)


def damaged(ending: str) -> bytes:
    content = bytearray(cv2.imencode(ending, NOISE)[1].tobytes())
    middle = len(content) // 2
    content[middle : middle + 40] = bytes(40)
    return bytes(content)


def fail_silently() -> None:
    with codec_output():
        os.write(2, b"lost")
        raise ValueError("stop")


@pytest.mark.parametrize("ending", [".jpg", ".png"])
def test_only_the_diagnostic_speaks_of_a_damaged_picture(
    ending: str,
    tmp_path: Path,
    capfd: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    file = tmp_path / f"damaged{ending}"
    file.write_bytes(damaged(ending))
    cv2.imread(str(file))
    assert capfd.readouterr().err, "these libraries print by themselves"
    threads(monkeypatch, 1)
    with suppress(DiagnosticError):
        open_image(file, file.name, None)
    assert capfd.readouterr().err == ""


def test_standard_error_is_as_before_also_after_a_fault(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    threads(monkeypatch, 1)
    with pytest.raises(ValueError, match="stop"):
        fail_silently()
    os.write(2, b"shown")
    assert capfd.readouterr().err == "shown"


def test_lines_of_other_threads_are_not_lost(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    threads(monkeypatch, 2)
    with codec_output() as printed:
        os.write(2, b"shown\nCorrupt JPEG data: all of it\nlast")
    assert capfd.readouterr().err == "shown\nlast"
    assert printed.damage == "Corrupt JPEG data: all of it"


def test_a_closed_standard_error_stays_closed() -> None:
    code = (
        "import os; os.close(2)\n"
        "from roadlang.images.codec_output import codec_output\n"
        "with codec_output() as printed: os.write(2, b'Premature end of JPEG file')\n"
        "try: os.fstat(2)\n"
        "except OSError: print(printed.damage)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True)
    assert done.stdout == "Premature end of JPEG file\n"


def cut(content: bytes, end: bytes) -> bytes:
    return content[: len(content) * 3 // 4] + end


JPEG = cv2.imencode(".jpg", NOISE)[1].tobytes()
PNG = cv2.imencode(".png", NOISE)[1].tobytes()


@pytest.mark.parametrize("count", [1, 3])
def test_a_jpeg_whose_end_is_missing_is_read_with_a_warning(
    count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "cut.jpg"
    file.write_bytes(cut(JPEG, b"\xff\xd9"))
    threads(monkeypatch, count)
    (warning,) = open_image(file, file.name, None).warnings
    assert (warning.code, warning.is_error, warning.path) == ("RL446", False, "cut.jpg")
    assert "Corrupt JPEG data: premature end of data segment" in warning.message


@pytest.mark.parametrize("content", [JPEG, PNG, JPEG + b"more", PNG + b"more"])
def test_a_sound_picture_has_no_warning(content: bytes, tmp_path: Path) -> None:
    file = tmp_path / "sound"
    file.write_bytes(content)
    assert open_image(file, file.name, None).warnings == ()


def test_a_png_that_is_damaged_anywhere_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "changed.png"
    for at in range(8, len(PNG) - 12, 97):
        file.write_bytes(PNG[:at] + bytes([PNG[at] ^ 1]) + PNG[at + 1 :])
        with pytest.raises(DiagnosticError):
            open_image(file, file.name, None)


def test_a_scene_with_a_damaged_picture_has_the_warning_at_its_image(tmp_path: Path) -> None:
    pixels = cv2.line(np.zeros((200, 200, 3), np.uint8), (0, 20), (199, 60), (255, 255, 255), 9)
    content = cv2.imencode(".jpg", pixels)[1].tobytes()
    (tmp_path / "road.jpg").write_bytes(content[:-40] + content[-2:])
    scene = tmp_path / "scene.rl"
    scene.write_text(
        'image photo from "road.jpg" { scale: 1m/px }\n'
        "network town from photo { extract with contour }\nroad main from town\n"
    )
    (warning,) = roadlang.load(scene).sample(1).result.warnings
    assert warning.code == "RL446"
    assert warning.span is not None
    assert warning.span.source.text[warning.span.start :].startswith("image photo")
