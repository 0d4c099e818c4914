"""Which bands of a TIFF file are colors, and which of its pixels show something."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.images.image_file import open_image
from roadlang.images.tiff_bands import TiffBands

INFRARED, OPACITY = 0, 2
LZW, ZSTANDARD = 5, 50000


GRAY, RGB = 1, 2


def tiff_of(
    pixels: np.ndarray,
    extra: int | None = None,
    no_data: str = "",
    compression: int = 1,
    meaning: int = RGB,
    planes: int = 1,
) -> bytes:
    """A file of pixels (h, w, bands), red first. `extra`: the kind of the last band; `planes`: 2
    where the bands are apart."""
    height, width, bands = pixels.shape
    body = pixels.tobytes()
    tags = [
        (256, 3, 1, width), (257, 3, 1, height), (259, 3, 1, compression), (262, 3, 1, meaning),
        (273, 4, 1, 8), (277, 3, 1, bands), (278, 3, 1, height), (279, 4, 1, len(body)),
        (284, 3, 1, planes), (339, 3, 1, 2 if pixels.dtype.kind == "i" else 1),
    ]  # fmt: skip
    depths = struct.pack(f"<{bands}H", *[8 * pixels.itemsize] * bands)
    tags.append((258, 3, bands, 8 + len(body)))
    body += depths
    if extra is not None and meaning == GRAY:  # all bands but the first
        tags.append((338, 3, bands - 1, extra << 16 if bands == 3 else 8 + len(body)))
        body += struct.pack(f"<{bands - 1}H", *[0] * (bands - 2), extra)
    elif extra is not None:
        tags.append((338, 3, 1, extra))
    if no_data:
        text = no_data.encode() + b"\0"
        is_short = len(text) <= 4  # then it is in the tag itself
        place = int.from_bytes(text, "little") if is_short else 8 + len(body)
        tags.append((42113, 2, len(text), place))
        body += b"" if is_short else text
    table = struct.pack("<H", len(tags))
    table += b"".join(struct.pack("<HHII", *tag) for tag in sorted(tags)) + b"\0\0\0\0"
    return b"II*\0" + struct.pack("<I", 8 + len(body)) + body + table


def picture() -> np.ndarray:
    """(4, 6, 4) red, green, blue, and a fourth band that is 0 on the left."""
    pixels = np.zeros((4, 6, 4), np.uint8)
    pixels[..., :3] = (10, 20, 30)
    pixels[:, 3:, 3] = 255
    return pixels


@pytest.mark.parametrize(("kind", "left"), [(INFRARED, [30, 20, 10]), (OPACITY, [255, 255, 255])])
def test_a_band_of_infrared_is_not_opacity(tmp_path: Path, kind: int, left: list[int]) -> None:
    (tmp_path / "a.tif").write_bytes(tiff_of(picture(), kind))
    opened = open_image(tmp_path / "a.tif", "a.tif", None)
    assert opened.pixels[0, 0].tolist() == left
    assert opened.pixels[0, 5].tolist() == [30, 20, 10]


def test_what_shows_nothing() -> None:
    bgra = picture()[..., [2, 1, 0, 3]]
    left = np.arange(6) < 3
    shown = TiffBands().shown(bgra)
    assert shown is not None
    assert (shown == ~left).all()
    assert TiffBands().shown(bgra[:, 3:]) is None
    assert TiffBands().shown(bgra[..., :3]) is None
    zeros = np.where(left[:, None], 0, bgra[..., :3])
    shown = TiffBands(no_data=0.0).shown(zeros)
    assert shown is not None
    assert (shown == ~left).all()
    partly = zeros.copy()
    partly[..., 1] = 9  # 0 in two of three bands is a color
    assert TiffBands(no_data=0.0).shown(partly) is None
    half = np.full((2, 2, 2), 32768, np.uint16)
    assert TiffBands().shown(half) is None
    half[0, 0, 1] = 32767
    one_hidden = TiffBands().shown(half)
    assert one_hidden is not None
    assert np.argwhere(~one_hidden).tolist() == [[0, 0]]


@pytest.mark.parametrize(("kind", "none"), [(np.int16, -9999), (np.uint16, 65535)])
def test_no_data_does_not_reduce_the_contrast(
    tmp_path: Path, kind: type[np.integer], none: int
) -> None:
    pixels = np.full((4, 6, 3), 1000, kind)
    pixels[:, 2:4], pixels[:, 4:] = 3000, none
    (tmp_path / "a.tif").write_bytes(tiff_of(pixels, None, str(none)))
    opened = open_image(tmp_path / "a.tif", "a.tif", None)
    assert opened.pixels[0, :, 0].tolist() == [0, 0, 255, 255, 0, 0]


def test_bands_are_read_from_tags() -> None:
    assert TiffBands.of(tiff_of(picture(), INFRARED, "0")) == TiffBands(False, 0.0)
    assert TiffBands.of(tiff_of(picture()[..., :3], None, "-9999.5")).no_data == -9999.5
    assert TiffBands.of(tiff_of(picture()[..., :3], None, "none")).no_data is None
    assert TiffBands.of(tiff_of(picture(), OPACITY)) == TiffBands()
    assert TiffBands.of(b"II*\0") == TiffBands()


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
@pytest.mark.parametrize("bands", [3, 4])
def test_bands_that_are_not_said_to_be_colors_are_red_green_and_blue(
    tmp_path: Path, bands: int, kind: type[np.unsignedinteger]
) -> None:
    pixels = picture()[..., :bands].astype(kind) * (257 if kind is np.uint16 else 1)
    (tmp_path / "a.tif").write_bytes(tiff_of(pixels, INFRARED, meaning=GRAY))
    opened = open_image(tmp_path / "a.tif", "a.tif", None)
    assert opened.pixels[0, 0].tolist() == [30, 20, 10]


def test_bands_of_two_bytes_that_are_apart_are_refused(tmp_path: Path) -> None:
    pixels = np.ascontiguousarray(picture()[..., :3]).astype(np.uint16)
    (tmp_path / "a.tif").write_bytes(tiff_of(pixels, planes=2))
    with pytest.raises(DiagnosticError) as raised:
        open_image(tmp_path / "a.tif", "a.tif", None)
    (fault,) = raised.value.diagnostics
    assert fault.code == "RL404"
    assert "-co INTERLEAVE=PIXEL" in fault.help[0]
    assert not TiffBands.of(tiff_of(picture(), planes=2)).is_misread


@pytest.mark.parametrize(
    ("bands", "compression", "reason"),
    [
        (3, ZSTANDARD, "Zstandard compression is not supported: `gdal_translate"),
        (5, 1, "it has 5 bands, at most 4 can be read: `gdal_translate"),
    ],
)
def test_what_cannot_be_read_is_named(
    tmp_path: Path, bands: int, compression: int, reason: str
) -> None:
    content = tiff_of(np.zeros((4, 6, bands), np.uint8), None, "", compression)
    (tmp_path / "a.tif").write_bytes(content)
    with pytest.raises(DiagnosticError) as raised:
        open_image(tmp_path / "a.tif", "a.tif", None)
    (fault,) = raised.value.diagnostics
    assert fault.code == "RL404"
    assert fault.help[0].startswith(reason)
