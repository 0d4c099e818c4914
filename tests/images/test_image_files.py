"""Pictures of any quality are opened, or refused with a code; none raises anything else."""

from __future__ import annotations

import math
import struct
import zlib
from hashlib import sha256
from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from roadlang.diagnostics import DiagnosticError
from roadlang.images.image_file import OpenedImage, open_image
from roadlang.images.image_header import ImageHeader, read_header
from roadlang.images.placed_pixels import MOST_PIXELS
from tests.images.geotiffs import written_geotiff


def shown(height: int = 40, width: int = 60, channels: int = 3, depth: str = "uint8") -> np.ndarray:
    ramp = np.linspace(0, np.iinfo(depth).max, height * width * channels)
    return ramp.reshape(height, width, channels).astype(depth)


def written(path: Path, pixels: np.ndarray) -> Path:
    assert cv2.imwrite(str(path), pixels)
    return path


def opened(path: Path) -> OpenedImage:
    return open_image(path, path.name, None)


def refused(path: Path) -> str:
    with pytest.raises(DiagnosticError) as caught:
        opened(path)
    assert caught.value.diagnostics[0].path == path.name
    return caught.value.diagnostics[0].code


def huge_png(path: Path, side: int) -> Path:
    """A valid PNG header of any size, with hardly any content."""

    def chunk(kind: bytes, body: bytes) -> bytes:
        return (
            struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        )

    head = struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)
    body = chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(b"")) + chunk(b"IEND", b"")
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + body)
    return path


@pytest.mark.parametrize("ending", ["png", "jpg", "tif", "bmp", "webp", "jp2"])
def test_the_usual_formats_are_read_in_color(tmp_path: Path, ending: str) -> None:
    found = opened(written(tmp_path / f"a.{ending}", shown()))
    assert found.pixels.shape == (40, 60, 3)
    assert found.pixels.dtype == np.uint8
    assert len(found.inputs[0][1]) == 64


@pytest.mark.parametrize("channels", [1, 4])
def test_gray_and_transparent_pictures_become_color(tmp_path: Path, channels: int) -> None:
    assert opened(written(tmp_path / "a.png", shown(channels=channels))).pixels.shape == (40, 60, 3)


def test_what_is_transparent_becomes_white(tmp_path: Path) -> None:
    clear = np.zeros((8, 8, 4), np.uint8)
    assert (opened(written(tmp_path / "a.png", clear)).pixels == 255).all()


def test_sixteen_bits_keep_their_range(tmp_path: Path) -> None:
    pixels = opened(written(tmp_path / "a.png", shown(depth="uint16"))).pixels
    assert pixels.min() == 0
    assert pixels.max() == 255


def test_sixteen_bits_of_a_dark_picture_are_not_stretched(tmp_path: Path) -> None:
    dark = (shown(depth="uint16") * 0.25).astype(np.uint16)
    assert opened(written(tmp_path / "a.png", dark)).pixels.max() == 64


def test_twelve_bits_in_sixteen_are_stretched(tmp_path: Path) -> None:
    dim = (shown(depth="uint16") // 16).astype(np.uint16)
    assert opened(written(tmp_path / "a.png", dim)).pixels.max() == 255


def test_the_size_of_a_jpeg_is_found_behind_its_tables(tmp_path: Path) -> None:
    """Huffman tables have a marker next to that of the header, and may stand before it."""
    content = written(tmp_path / "a.jpg", shown(40, 60)).read_bytes()
    frame, tables = content.index(b"\xff\xc0"), content.index(b"\xff\xc4")
    behind = content.index(b"\xff\xda")
    turned = content[:frame] + content[tables:behind] + content[frame:tables] + content[behind:]
    assert read_header(turned) == ImageHeader("JPEG", 60, 40)


def test_a_text_file_called_png_is_no_picture(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_text("road main {}")
    assert refused(tmp_path / "a.png") == "RL402"


def test_an_empty_file_and_a_missing_one_cannot_be_read(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(b"")
    assert refused(tmp_path / "a.png") == "RL400"
    assert refused(tmp_path / "b.png") == "RL400"
    assert refused(tmp_path) == "RL400"


def test_a_single_pixel_holds_no_road(tmp_path: Path) -> None:
    assert refused(written(tmp_path / "a.png", shown(1, 1))) == "RL405"


def test_too_many_pixels_are_refused_before_they_are_decoded(tmp_path: Path) -> None:
    assert MOST_PIXELS < 12_000**2
    assert refused(huge_png(tmp_path / "a.png", 12_000)) == "RL401"
    assert refused(huge_png(tmp_path / "b.png", 2**31 - 1)) == "RL401"


@pytest.mark.parametrize("ending", ["png", "jpg", "bmp", "webp"])
def test_a_picture_without_its_end_is_cut_off(tmp_path: Path, ending: str) -> None:
    whole = written(tmp_path / f"a.{ending}", shown(400, 600))
    whole.write_bytes(whole.read_bytes()[: whole.stat().st_size // 2])
    assert refused(whole) == "RL403"


def test_a_header_without_content_is_damaged(tmp_path: Path) -> None:
    assert refused(huge_png(tmp_path / "a.png", 64)) == "RL404"


@settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(
    ending=st.sampled_from(["png", "jpg", "tif", "bmp", "webp"]),
    place=st.floats(0, 1),
    noise=st.binary(min_size=1, max_size=40),
)
def test_damage_anywhere_is_refused_or_survived(
    tmp_path: Path, ending: str, place: float, noise: bytes
) -> None:
    path = written(tmp_path / f"a.{ending}", shown())
    content = bytearray(path.read_bytes())
    at = int(place * (len(content) - 1))
    content[at : at + len(noise)] = noise
    path.write_bytes(bytes(content))
    try:
        assert opened(path).pixels.ndim == 3
    except DiagnosticError as error:
        codes = {"RL401", "RL402", "RL403", "RL404", "RL405"}
        assert error.diagnostics[0].code in codes  # noqa: PT017


@pytest.mark.parametrize(
    ("start", "help"),
    [
        (b"GIF89a", "it is a GIF: save the frame that shows the road as PNG"),
        (b"\0\0\0\x20ftypavif", "it is an AVIF picture: save it as PNG or JPEG"),
        (b"\0\0\0\x20ftypheic", "it is a HEIC picture: save it as PNG or JPEG"),
        (b"<!DOCTYPE html><p>404", "it is a web page: the download may have failed"),
        (b"version https://git-lfs.github.com/spec/v1", "`git lfs pull` fetches the picture"),
    ],
    ids=lambda value: value[:12] if isinstance(value, str) else "",
)
def test_a_file_that_is_no_picture_says_what_it_is(tmp_path: Path, start: bytes, help: str) -> None:
    path = tmp_path / "a.png"
    path.write_bytes(start + b"\0" * 64)
    with pytest.raises(DiagnosticError) as caught:
        opened(path)
    (found,) = caught.value.diagnostics
    assert found.code == "RL402"
    assert help in found.help[0]


def geotiff(path: Path, scale: float, unit: int, model: int = 1) -> Path:
    """A 2 x 2 TIFF with a scale, without a place."""
    keys = ((1024, model), (3076, unit))
    return written_geotiff(path, np.full((2, 2), 9, np.uint8), keys, {33550: (scale, scale, 0.0)})


@pytest.mark.parametrize(
    ("unit", "meters"), [(9001, 0.5), (9002, 0.5 * 0.3048), (9003, 0.5 * 1200 / 3937)]
)
def test_a_geotiff_says_its_scale_in_meters_feet_or_survey_feet(
    tmp_path: Path, unit: int, meters: float
) -> None:
    assert opened(geotiff(tmp_path / "a.tif", 0.5, unit)).scale == pytest.approx(meters, rel=1e-9)


def test_a_geotiff_in_degrees_says_no_scale(tmp_path: Path) -> None:
    assert opened(geotiff(tmp_path / "a.tif", 0.5, 9001, model=2)).scale is None


@pytest.mark.parametrize("beside", ["a.pgw", "a.pngw", "a.wld"])
def test_a_world_file_beside_the_picture_says_its_scale(tmp_path: Path, beside: str) -> None:
    (tmp_path / beside).write_text("0.25\n0\n0\n-0.25\n1000\n2000\n")
    picture = opened(written(tmp_path / "a.png", shown()))
    assert picture.scale == pytest.approx(0.25)
    assert len(picture.inputs) == 2
    digest = sha256((tmp_path / beside).read_bytes()).hexdigest()
    assert picture.inputs[1] == (beside, digest)


@pytest.mark.parametrize(
    ("lines", "scale"),
    [
        ("0.4330127 -0.25 -0.25 -0.4330127", 0.5),  # turned by 30 degrees
        ("0.5 0 0.3 -0.5", 0.5),  # aslant: pixels have the area of squares of this side
        ("0.5 0.25 0.5 -0.5", math.sqrt(0.375)),
        ("0.5 0.5 0.1 -0.5", math.sqrt(0.3)),
        ("2 0 0 -0.5", 1.0),
        ("0.5 0 0 0", None),
    ],
)
def test_a_world_file_may_be_turned(tmp_path: Path, lines: str, scale: float | None) -> None:
    (tmp_path / "a.pgw").write_text("\n".join([*lines.split(), "1000", "2000", ""]))
    found = opened(written(tmp_path / "a.png", shown())).scale
    assert found == (None if scale is None else pytest.approx(scale))


def test_the_size_of_a_tiff_may_be_written_in_two_bytes_or_in_four(tmp_path: Path) -> None:
    content = geotiff(tmp_path / "a.tif", 0.5, 9001).read_bytes()
    for tag in (256, 257):
        content = content.replace(
            struct.pack("<HHII", tag, 3, 1, 2), struct.pack("<HHII", tag, 4, 1, 2)
        )
    assert read_header(content) == ImageHeader("TIFF", 2, 2)
