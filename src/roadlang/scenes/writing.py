"""Writes files whole, all of them or none."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path

from ..diagnostics import Code, DiagnosticError, diagnose


def write_all(folder: Path, contents: Mapping[str, bytes | str]) -> tuple[Path, ...]:
    """Write each content under its name in `folder`, which is made where it is not there.

    All contents go to temporary files first and are renamed together at the end, so that a full
    disk or an interruption leaves no part of a file. Raises DiagnosticError RL460.
    """
    written: list[tuple[Path, Path]] = []
    target = folder
    try:
        for name, content in contents.items():
            target = folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            written.append((_written(target, content), target))
        for temporary, target in written:
            os.replace(temporary, target)
    except OSError as error:
        raise DiagnosticError(
            diagnose(
                Code.OUTPUT_NOT_WRITTEN,
                path=str(target),
                file=str(target),
                reason=error.strerror or error,
            )
        ) from error
    finally:
        for temporary, _ in written:
            with contextlib.suppress(OSError):
                temporary.unlink()
    return tuple(path for _, path in written)


def _written(target: Path, content: bytes | str) -> Path:
    data = content.encode("utf-8") if isinstance(content, str) else content
    handle, name = tempfile.mkstemp(prefix=f".{target.name}.", dir=target.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        os.chmod(name, 0o666 & ~_umask())
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(name)
        raise
    return Path(name)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
