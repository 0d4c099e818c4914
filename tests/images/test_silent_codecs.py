"""libjpeg and libpng print nothing of damaged pictures: the diagnostic says what is wrong."""

from __future__ import annotations

import os
import threading
from contextlib import suppress
from pathlib import Path

import cv2
import numpy as np
import pytest

from roadlang import DiagnosticError
from roadlang.images.image_file import open_image
from roadlang.images.silent_codecs import silent_codecs

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
    with silent_codecs():
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
    with silent_codecs():
        os.write(2, b"shown")
    assert capfd.readouterr().err == "shown"
