"""Files that plugins read have the limits and diagnostics of those that scenes name."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from roadlang.api import DiagnosticError, read_image, read_input


def refused(read: object, *arguments: object) -> str:
    with pytest.raises(DiagnosticError) as caught:
        read(*arguments)  # type: ignore[operator]
    return caught.value.diagnostics[0].code


def test_an_image_is_its_pixels_with_row_0_at_the_top(tmp_path: Path) -> None:
    blue, red = (255, 0, 0), (0, 0, 255)
    pixels = np.array([[blue, blue, blue], [red, red, blue]], np.uint8)
    cv2.imwrite(str(tmp_path / "a.png"), pixels)
    np.testing.assert_array_equal(read_image(tmp_path / "a.png"), pixels)


def test_a_file_is_its_bytes_up_to_the_limit(tmp_path: Path) -> None:
    (tmp_path / "a.bin").write_bytes(b"12345")
    assert read_input(tmp_path / "a.bin") == b"12345"
    assert read_input(tmp_path / "a.bin", 5) == b"12345"
    assert refused(read_input, tmp_path / "a.bin", 4) == "RL401"


def test_what_is_no_file_or_no_image_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(b"no image")
    assert refused(read_input, tmp_path / "none") == "RL400"
    assert refused(read_image, tmp_path / "none") == "RL400"
    assert refused(read_input, tmp_path) == "RL400"
    assert refused(read_image, tmp_path / "a.png") == "RL402"


def test_an_image_that_is_damaged_in_part_is_refused(tmp_path: Path) -> None:
    noise = np.random.default_rng(1).integers(0, 255, (60, 80, 3), np.uint8)
    content = bytearray(cv2.imencode(".jpg", noise)[1].tobytes())
    middle = len(content) // 2
    content[middle : middle + 40] = bytes(40)
    (tmp_path / "a.jpg").write_bytes(bytes(content))
    with pytest.raises(DiagnosticError) as caught:
        read_image(tmp_path / "a.jpg")
    (found,) = caught.value.diagnostics
    assert found.code == "RL404"
    assert "`a.jpg` is damaged: Corrupt JPEG data" in found.help[0]
