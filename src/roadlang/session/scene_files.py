"""Scene files as text."""

from __future__ import annotations

import sys
from pathlib import Path

from ..diagnostics import Code, DiagnosticError, diagnose, did_you_mean
from ..files.reading import LARGEST_SCENE_FILE, UnreadableFile, read_file, written_text

STANDARD_INPUT = "-"


def read_scene_file(name: str) -> str:
    """The text of a scene file; `-` is standard input.

    Raises `DiagnosticError` (RL920 to RL923) for what is no readable text.
    """
    data = _bytes(name)
    if b"\0" in data:
        raise DiagnosticError(
            diagnose(
                Code.NOT_UTF8,
                path=name,
                help=_encoding_hint(data),
                reason="it contains zero bytes",
            )
        )
    try:
        return written_text(data)
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        reason = f"line {line} has the byte 0x{data[error.start]:02x}"
        raise DiagnosticError(
            diagnose(Code.NOT_UTF8, path=name, help=_encoding_hint(data), reason=reason)
        ) from None


def _bytes(name: str) -> bytes:
    path = Path(name)
    try:
        if name == STANDARD_INPUT:
            data = sys.stdin.buffer.read(LARGEST_SCENE_FILE + 1)
            size = len(data) if len(data) > LARGEST_SCENE_FILE else None
        else:
            data, size = read_file(path, LARGEST_SCENE_FILE), None
    except UnreadableFile as error:
        if error.is_folder:
            folder = diagnose(Code.FOLDER_INSTEAD_OF_FILE, path=name, help=_scenes_in(path))
            raise DiagnosticError(folder) from None
        if error.size is None:
            hints = _near_files(path) if error.is_missing else _pipe_hint(error.reason)
            raise DiagnosticError(
                diagnose(Code.UNREADABLE_FILE, path=name, help=hints, reason=error.reason)
            ) from None
        data, size = b"", error.size
    if size is not None:
        limit = LARGEST_SCENE_FILE / 1e6
        raise DiagnosticError(
            diagnose(Code.SCENE_FILE_TOO_LARGE, path=name, size=size / 1e6, limit=limit)
        )
    return data


def _pipe_hint(reason: str) -> tuple[str, ...]:
    return ("`-` reads standard input",) if "not a file" in reason else ()


def _scenes_in(folder: Path) -> tuple[str, ...]:
    try:
        found = sorted(path.name for path in folder.glob("*.rl"))[:5]
    except OSError:
        return ()
    return tuple(f"there is `{folder / name}`" for name in found)


def _near_files(path: Path) -> tuple[str, ...]:
    try:
        present = [entry.name for entry in path.parent.iterdir()]
    except (OSError, ValueError):
        return ()
    return did_you_mean(path.name, present)


def _encoding_hint(data: bytes) -> str:
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "it looks like UTF-16: save it as UTF-8"
    if data.startswith((b"\x89PNG", b"\xff\xd8\xff", b"II*\0", b"MM\0*", b"BM", b"RIFF")):
        return 'it is an image: name it in a scene file, `image photo from "..."`'
    return "save it as UTF-8"
