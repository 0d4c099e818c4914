"""The first bytes of a picture say its size, its last ones whether it is whole; depth by hand."""

from __future__ import annotations

import struct

import cv2
import numpy as np
import pytest

from roadlang.files.picture_ends import LAST, has_end
from roadlang.images.image_file import as_colors
from roadlang.images.image_header import ImageHeader, read_header

SHADES = np.linspace(0, 255, 40 * 50 * 3).reshape(40, 50, 3).astype(np.uint8)


def is_whole(content: bytes) -> bool:
    """As `check` looks at a file: at a few bytes of its start, and at its end."""
    return has_end(content[:512], content[-LAST:], len(content), lambda: content)


def encoded(ending: str, *options: int) -> bytes:
    fine, content = cv2.imencode(ending, SHADES, options)
    assert fine
    return bytes(content)


@pytest.mark.parametrize(
    ("ending", "options", "format"),
    [(".png", (), "PNG"), (".jpg", (), "JPEG"), (".tiff", (), "TIFF"), (".bmp", (), "BMP"),
     (".ppm", (), "PNM"), (".webp", (cv2.IMWRITE_WEBP_QUALITY, 80), "WebP"),
     (".webp", (cv2.IMWRITE_WEBP_QUALITY, 101), "WebP"), (".jp2", (), "JPEG 2000")],
    ids=["png", "jpg", "tiff", "bmp", "ppm", "lossy webp", "lossless webp", "jp2"],
)  # fmt: skip
def test_the_size_is_width_by_height_in_every_format(
    ending: str, options: tuple[int, ...], format: str
) -> None:
    content = encoded(ending, *options)
    assert read_header(content) == ImageHeader(format, 50, 40)
    assert is_whole(content)


@pytest.mark.parametrize("ending", [".png", ".jpg", ".webp", ".bmp"])
def test_what_follows_a_picture_is_not_looked_at(ending: str) -> None:
    """Phones add a video to a photo, and editors leave the end of a larger file."""
    assert is_whole(encoded(ending) + bytes(2 * LAST))


@pytest.mark.parametrize("ending", [".png", ".jpg", ".webp", ".bmp"])
def test_a_picture_that_is_cut_off_is_not_whole(ending: str) -> None:
    content = encoded(ending)
    assert not any(is_whole(content[: int(len(content) * share)]) for share in (0.2, 0.5, 0.9))


def test_a_preview_in_a_photo_that_is_cut_off_is_not_its_end() -> None:
    photo, preview = encoded(".jpg"), encoded(".jpg")
    segment = b"\xff\xe1" + (len(preview) + 2).to_bytes(2, "big") + preview
    whole = photo[:2] + segment + photo[2:]
    assert is_whole(whole)
    assert not is_whole(whole[:-40])


def webp(chunk: bytes, body: bytes) -> bytes:
    return b"RIFF" + struct.pack("<I", 22 + len(body)) + b"WEBP" + chunk + b"\0" * 4 + body


def test_extended_webp_has_its_size_less_one_in_three_bytes() -> None:
    sides = (69_999).to_bytes(3, "little") + (299).to_bytes(3, "little")
    assert read_header(webp(b"VP8X", b"\0" * 4 + sides)) == ImageHeader("WebP", 70_000, 300)


def test_lossy_webp_has_its_size_in_14_bits() -> None:
    """The two bits above are a scale."""
    sides = struct.pack("<HH", 0x4000 | 640, 0x8000 | 480)
    assert read_header(webp(b"VP8 ", b"\0" * 6 + sides)) == ImageHeader("WebP", 640, 480)


def jpeg(*segments: bytes) -> bytes:
    return b"\xff\xd8" + b"".join(segments) + b"\0" * 16


FRAME = b"\x00\x11\x08" + struct.pack(">HH", 30, 50)


@pytest.mark.parametrize(
    ("segments", "size"),
    [
        ((b"\xff\xc0" + FRAME,), (50, 30)),
        ((b"\xff\xcf" + FRAME,), (50, 30)),
        ((b"\xff\xe0\x00\x06ABCD", b"\xff\xc2" + FRAME), (50, 30)),
        ((b"\xff\xff\xff\xc0" + FRAME,), (50, 30)),
        ((b"\xff\xc4\x00\x06ABCD", b"\xff\xc1" + FRAME), (50, 30)),
        ((b"\xff\xcc\x00\x06ABCD", b"\xff\xc8\x00\x06ABCD", b"\xff\xc1" + FRAME), (50, 30)),
        ((b"\xff\xe0\x7f\xff",), (8, 8)),
    ],
    ids=["baseline", "last kind of frame", "after a segment", "fill byte", "Huffman tables",
         "no frames", "cut off before its size"],
)  # fmt: skip
def test_a_jpeg_has_its_size_in_its_frame(
    segments: tuple[bytes, ...], size: tuple[int, int]
) -> None:
    assert read_header(jpeg(*segments)) == ImageHeader("JPEG", *size)


def test_what_breaks_off_within_a_header_is_no_picture() -> None:
    assert read_header(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0") is None
    assert read_header(b"BM\0\0\0\0") is None
    assert read_header(jpeg(b"\x00\xc0" + FRAME)) is None
    assert read_header(webp(b"ALPH", b"\0" * 20)) is None


def test_a_bitmap_may_be_stored_from_the_top() -> None:
    """Its height is negative then."""
    content = b"BM" + b"\0" * 16 + struct.pack("<ii", 50, -30)
    assert read_header(content) == ImageHeader("BMP", 50, 30)


@pytest.mark.parametrize(
    ("head", "count"),
    [
        (b"P5 4 3 255\n", 12),
        (b"P6 4 3 255\n", 36),
        (b"P5 4 3 256\n", 24),
        (b"P6\n4\n3\n65535\n", 72),
    ],
)
def test_a_raw_picture_is_whole_with_its_last_byte(head: bytes, count: int) -> None:
    assert read_header(head + b"\0" * count) == ImageHeader("PNM", 4, 3)
    assert is_whole(head + b"\0" * count)
    assert not is_whole(head + b"\0" * (count - 1))


def test_other_formats_are_whole_with_their_ends() -> None:
    """Of BMP files the sizes that are stated are not exact."""
    for ending, format in ((".png", "PNG"), (".jpg", "JPEG"), (".bmp", "BMP"), (".webp", "WebP"),
                            (".jp2", "JPEG 2000")):  # fmt: skip
        content = encoded(ending)
        assert is_whole(content)
        assert not is_whole(content[: len(content) // 2]), format
        assert format == "BMP" or not is_whole(content[:-1]), format
    assert is_whole(b"II*\0")


@pytest.mark.parametrize(
    ("pixels", "shades"),
    [
        (np.array([[0, 4095]], np.uint16), [0, 255]),          # 12 bits in 16
        (np.array([[0, 32768, 65535]], np.uint16), [0, 128, 255]),
        (np.array([[8192, 16384]], np.uint16), [32, 64]),      # all 16 bits: no stretching
        (np.array([[0.25, 0.5, 0.75]], np.float32), [0, 128, 255]),
        (np.array([[np.nan, 0.0, 2.0]], np.float64), [0, 0, 255]),
        (np.array([[500, 500]], np.uint16), [128, 128]),       # one shade says nothing
        (np.array([[-7, 93]], np.int16), [0, 255]),
    ],
)  # fmt: skip
def test_any_depth_becomes_a_byte(pixels: np.ndarray, shades: list[int]) -> None:
    assert as_colors(pixels)[0, :, 0].tolist() == shades
    assert as_colors(pixels).shape == (*pixels.shape, 3)


def test_what_is_transparent_is_white() -> None:
    """A quarter covered: 0 becomes three quarters of white."""
    gray = np.array([[[40, 0], [0, 64], [40, 255]]], np.uint8)
    assert as_colors(gray)[0, :, 0].tolist() == [255, 191, 40]
    color = np.array([[[10, 20, 30, 255], [10, 20, 30, 0]]], np.uint8)
    assert as_colors(color).tolist() == [[[10, 20, 30], [255, 255, 255]]]


def test_white_lines_on_nothing_are_drawn_on_black() -> None:
    """White on white they would not be seen."""
    image = np.full((20, 30, 4), 255, np.uint8)
    image[:8, :, 3] = image[12:, :, 3] = 0
    assert as_colors(image)[:, 5, 0].tolist() == [0] * 8 + [255] * 4 + [0] * 8
    image[9, :10, :3] = 90
    assert as_colors(image)[:8].min() == 255
