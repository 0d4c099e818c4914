"""What the first bytes of a picture file say of its format: which can be read, which not."""

from __future__ import annotations

NEEDED = 512
"""Bytes of the start of a file that are looked at."""
READABLE = "PNG, JPEG, TIFF, BMP, PNM, WebP and JPEG 2000 can be read"

WHOLE_AGAIN = "copy or download it again, or open it in another program and save what there is"
"""What to do where the end of a picture is missing."""

_READ = {
    "PNG": (b"\x89PNG\r\n\x1a\n",),
    "JPEG": (b"\xff\xd8\xff",),
    "TIFF": (b"II*\x00", b"MM\x00*", b"II+\x00", b"MM\x00+"),
    "BMP": (b"BM",),
    "PNM": (b"P2", b"P3", b"P5", b"P6"),
    "JPEG 2000": (b"\x00\x00\x00\x0cjP  \r\n\x87\n", b"\xff\x4f\xff\x51"),
}
_OTHERS = (
    ("a GIF", "save the frame that shows the road as PNG", (b"GIF8",)),
    ("a PDF", "save the page as PNG: `pdftoppm -png -r 150 FILE page`", (b"%PDF",)),
    ("a Photoshop picture", "save it as PNG", (b"8BPS",)),
    ("an icon", "save it as PNG", (b"\x00\x00\x01\x00",)),
    ("a JPEG XL picture", "save it as PNG", (b"\xff\x0a", b"\x00\x00\x00\x0cJXL ")),
    ("an OpenEXR picture", "save it as PNG or TIFF", (b"v/1\x01",)),
    ("an archive", "unpack it", (b"PK\x03\x04", b"\x1f\x8b", b"7z\xbc\xaf", b"Rar!")),
    ("a Git LFS pointer", "`git lfs pull` fetches the picture", (b"version https://git-lfs",)),
)
"""What it is, what to do, and how it starts."""
_OF_PHONES = (b"heic", b"heix", b"mif1", b"msf1")
_MARKS = (
    (b"<osm", "a map of OpenStreetMap", 'read it with `network town from "FILE.osm"`'),
    (b"<opendrive", "a map in OpenDRIVE", 'read it with `network town from "FILE.xodr"`'),
    (b"<svg", "a drawing in SVG", "export it as PNG, as with `rsvg-convert FILE -o FILE.png`"),
    (b"<html", "a web page", "the download may have failed: look at the file in a browser"),
    (
        b"<!doctype html",
        "a web page",
        "the download may have failed: look at the file in a browser",
    ),
)


def picture_format(start: bytes) -> str | None:
    """The format of a picture that starts so; None where it is none that can be read."""
    if start[:4] == b"RIFF" and start[8:12] == b"WEBP":
        return "WebP"
    return next((name for name, begins in _READ.items() if start.startswith(begins)), None)


def other_content(start: bytes) -> str:
    """What a file that cannot be read is, and what to do: `it is a GIF: save ...`; else empty."""
    for what, remedy, begins in _OTHERS:
        if start.startswith(begins):
            return f"it is {what}: {remedy}"
    if start[4:8] == b"ftyp" and start[8:12] in (b"avif", b"avis", *_OF_PHONES):
        name = "a HEIC" if start[8:12] in _OF_PHONES else "an AVIF"
        return f"it is {name} picture: save it as PNG or JPEG"
    text = start[:NEEDED].lower()
    return next((f"it is {what}: {remedy}" for mark, what, remedy in _MARKS if mark in text), "")
