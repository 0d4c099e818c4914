"""Files that a scene names: they must be there, and be what their names say."""

from __future__ import annotations

import os
from pathlib import Path

from ...diagnostics import Code, Diagnostic, Fix, Span, diagnose, did_you_mean
from ...files.matching import files_matching
from ...files.picture_ends import LAST, has_end
from ...files.picture_formats import NEEDED, READABLE, WHOLE_AGAIN, other_content, picture_format
from ...files.reading import UnreadableFile, read_ends, read_file

_MOST_SHOWN = 4
PICTURE_SUFFIXES = (
    *(".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm", ".ppm", ".webp"),
    *(".jp2", ".j2k"),
)


def missing_file(folder: Path, name: str, span: Span, written: str) -> Diagnostic:
    """RL450, with the nearest name in the folder, or with `/` where that names a file."""
    present = _files_in(folder, span, written)
    if isinstance(present, Diagnostic):
        return present
    with_slashes = _with_slashes(folder, span)
    if with_slashes is not None:
        fixes = [Fix(span, f'"{with_slashes}"')]
        slashes = f"write `{with_slashes}`: folders are separated by `/` on every system"
        return diagnose(
            Code.MISSING_FILE, span, file=written, what="file", help=slashes, fixes=fixes
        )
    help_ = did_you_mean(name, present) or (f"looked in `{folder}`",)
    return diagnose(Code.MISSING_FILE, span, file=written, what="file", help=help_)


def _with_slashes(folder: Path, span: Span) -> str | None:
    r"""The path, written as `sub\photo.jpg` in the file, with `/`, where a file has that name."""
    path = span.text.strip('"').replace("\\\\", "/").replace("\\", "/")
    if "\\" not in span.text or not os.path.isfile(folder / path):
        return None
    return path


def _files_in(folder: Path, span: Span, written: str) -> list[str] | Diagnostic:
    try:
        return os.listdir(folder)
    except OSError:
        help_ = f"there is no folder `{folder}`"
        return diagnose(Code.MISSING_FILE, span, file=written, what="file", help=help_)


def file_fault(folder: Path, written: str, span: Span, *, picture: bool) -> Diagnostic | None:
    """What is wrong with a file that the scene names, as far as can be told without decoding it.

    A picture may be named with `*` and `?`, which stand for all its tiles.
    """
    target = folder / written
    if picture and (tiles := files_matching(target)) != [target]:
        faults = (
            _first_fault(tile, os.path.join(os.path.dirname(written), tile.name), span, picture)
            for tile in tiles
        )
        missing = None if tiles else _missing_tiles(target.parent, span, written)
        return next(filter(None, faults), missing)
    return _first_fault(target, written, span, picture)


def _missing_tiles(folder: Path, span: Span, written: str) -> Diagnostic:
    """RL450 for a name with `*` or `?`, with the pictures in the folder."""
    present = _files_in(folder, span, written)
    if isinstance(present, Diagnostic):
        return present
    pictures = sorted(name for name in present if name.lower().endswith(PICTURE_SUFFIXES))
    shown = ", ".join(f"`{name}`" for name in pictures[:_MOST_SHOWN])
    more = f" and {len(pictures) - _MOST_SHOWN} more" if len(pictures) > _MOST_SHOWN else ""
    there = f"the pictures in `{folder}` are {shown}{more}"
    help_ = there if pictures else f"there is no picture in `{folder}`"
    return diagnose(Code.MISSING_FILE, span, file=written, what="file named like", help=help_)


def _first_fault(target: Path, written: str, span: Span, picture: bool) -> Diagnostic | None:
    try:
        head, end, size = read_ends(target, NEEDED, LAST if picture else 0)
        is_picture = picture and picture_format(head) is not None
        is_cut = is_picture and not has_end(head, end, size, lambda: read_file(target))
    except UnreadableFile as error:
        if error.is_missing:
            return missing_file(target.parent, target.name, span, written)
        return diagnose(Code.UNUSABLE_FILE, span, file=written, reason=error.reason)
    if not head:
        return diagnose(Code.UNUSABLE_FILE, span, file=written, reason="it is empty")
    if picture and not is_picture:
        reason, help_ = "it is not an image that can be read", (other_content(head), READABLE)
        shown = tuple(filter(None, help_))
        return diagnose(Code.UNUSABLE_FILE, span, file=written, reason=reason, help=shown)
    if is_cut:
        return diagnose(Code.TRUNCATED_IMAGE, span, file=written, help=WHOLE_AGAIN)
    return None
