"""What cameras record beside their arrays: pictures and clips."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import cv2
import numpy as np
import pytest

from roadlang.api import OptionError, SensorRecord
from roadlang.drive.reading_files import reading_files
from roadlang_standard.sense_camera import Camera


def seen(count: int = 6) -> SensorRecord:
    """A drive past a bright patch: `count` pictures, 0.1 s apart."""
    rgb = np.full((count, 36, 64, 3), 40, np.uint8)
    for number in range(count):
        rgb[number, 8:24, 4 + 8 * number : 20 + 8 * number] = (250, 120, 10)
    depth = np.full((count, 36, 64), np.inf, np.float32)
    depth[:, 20:] = np.float32(12.345)
    time = np.linspace(0.0, 0.1 * (count - 1), count)
    return SensorRecord("ego", "front", time, time, {"rgb": rgb, "depth": depth})


def files(seen: SensorRecord, *record: Literal["png", "mp4"]) -> dict[str, bytes]:
    return Camera(width=64.0, height=36.0, outputs=("rgb", "depth"), record=record).files(seen)


def test_nothing_is_recorded_unless_it_is_wanted() -> None:
    assert files(seen()) == {}


def test_pictures_hold_what_was_seen() -> None:
    record = seen()
    found = files(record, "png")
    assert list(found) == [f"{n:06d}.{o}.png" for o in ("rgb", "depth") for n in range(6)]
    for number in range(6):
        data = np.frombuffer(found[f"{number:06d}.rgb.png"], np.uint8)
        colors = cv2.imdecode(data, cv2.IMREAD_COLOR)[..., ::-1]
        np.testing.assert_array_equal(colors, record.arrays["rgb"][number])
    data = np.frombuffer(found["000005.depth.png"], np.uint8)
    centimeters = cv2.imdecode(data, cv2.IMREAD_UNCHANGED)
    assert centimeters.dtype == np.uint16
    assert (centimeters[:20] == 0).all()
    assert (centimeters[20:] == 1234).all() or (centimeters[20:] == 1235).all()


def test_a_clip_shows_the_pictures_at_their_pace(tmp_path: Path) -> None:
    record = seen()
    found = files(record, "mp4")
    assert list(found) == ["mp4"]
    assert files(record, "mp4") == found
    path = tmp_path / "clip.mp4"
    path.write_bytes(found["mp4"])
    clip = cv2.VideoCapture(str(path))
    assert clip.get(cv2.CAP_PROP_FPS) == pytest.approx(10.0)
    for picture in record.arrays["rgb"]:
        ok, colors = clip.read()
        assert ok
        assert np.abs(colors[..., ::-1].astype(int) - picture).mean() < 12
    assert not clip.read()[0]


def test_names_of_files_begin_with_agent_and_sensor() -> None:
    record = SensorRecord("ego", "front", np.zeros(1), np.zeros(1), {}, {"000000.rgb.png": b"x"})
    assert set(reading_files([record])) == {"ego.front.npz", "ego.front.000000.rgb.png"}


def test_a_clip_needs_colors() -> None:
    with pytest.raises(OptionError, match="rgb"):
        Camera(outputs=("depth",), record=("mp4",))
