"""Writes files whole: one, or several together."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path

from ..diagnostics import Code, DiagnosticError, diagnose
from .locking import folder_lock
from .not_written import not_written
from .transaction import PREFIX, is_plain, recover, replace_files

Content = bytes | str | os.PathLike[str]
"""What is to be in a file, or the path of a file on the same disk that is moved."""


def write_all(folder: Path, contents: Mapping[str, Content]) -> tuple[Path, ...]:
    """Write each content under its name in `folder`, or move it there, all of them or none.

    The folder is made where it is not there. Raises `DiagnosticError` RL460, and then the folder
    is as it was before.
    """
    return write_set(folder, contents, marker=None)


def write_file(path: Path, content: Content) -> Path:
    """Write one file whole. Raises `DiagnosticError` RL460."""
    (written,) = write_all(path.parent, {path.name: content})
    return written


def write_set(
    folder: Path,
    contents: Mapping[str, Content],
    marker: str | None,
    belonging: Callable[[Path], Iterable[str]] | None = None,
) -> tuple[Path, ...]:
    """As `write_all`; the file called `marker`, one of the contents, stands for the whole set.

    Where the marker is, every file of its set is there, whole. `belonging` reads the marker that
    was there before and names the files of that set: those that are not written again are removed.
    All other files stay. Whatever a killed process has left unfinished is finished first.
    """
    for name in contents:
        if not is_plain(name):
            raise ValueError(f"`{name}` is not the name of a file in a folder")
    data = {
        name: content.encode() if isinstance(content, str) else content
        for name, content in contents.items()
    }
    with reported(folder), created(folder), folder_lock(folder):
        recover(folder)
        earlier = folder / marker if marker is not None else None
        removed: Iterable[str] = ()
        if earlier is not None and belonging is not None and os.path.lexists(earlier):
            removed = belonging(earlier)
        replace_files(folder, data, removed, marker)
    return tuple(folder / name for name in data)


def remove_set(folder: Path, marker: str, belonging: Callable[[Path], Iterable[str]]) -> None:
    """Remove a set that `write_set` wrote, and the folder where nothing else is in it.

    Nothing happens where there is no marker. Raises `DiagnosticError` RL460.
    """
    with reported(folder):
        with folder_lock(folder):
            recover(folder)
            if not os.path.lexists(folder / marker):
                return
            replace_files(folder, {}, [*belonging(folder / marker), marker], None)
        with contextlib.suppress(OSError):
            folder.rmdir()


def replace_file(path: Path, text: str) -> None:
    """Write another text into a file of the user: whole or not at all, its permissions kept.

    Links keep pointing at the file. Raises `DiagnosticError` RL927.
    """
    target = Path(os.path.realpath(path))
    try:
        mode = target.stat().st_mode
        with folder_lock(target.parent):
            handle, name = tempfile.mkstemp(prefix=PREFIX, dir=target.parent)
            try:
                with os.fdopen(handle, "wb") as file:
                    file.write(text.encode("utf-8"))
                    file.flush()
                    os.fsync(file.fileno())
                os.chmod(name, mode)
                os.replace(name, target)
            except BaseException:
                with contextlib.suppress(OSError):
                    os.unlink(name)
                raise
    except OSError as error:
        reason = (error.strerror or type(error).__name__).lower()
        raise DiagnosticError(
            diagnose(Code.UNWRITABLE_OUTPUT, path=str(path), reason=reason)
        ) from error


@contextlib.contextmanager
def created(folder: Path) -> Iterator[None]:
    """Make a folder with its parents; where the writing fails, those that were made go again."""
    missing = [path for path in (folder, *folder.parents) if not os.path.lexists(path)]
    folder.mkdir(parents=True, exist_ok=True)
    try:
        yield
    except BaseException:
        for path in missing:
            with contextlib.suppress(OSError):
                path.rmdir()
        raise


@contextlib.contextmanager
def reported(folder: Path) -> Iterator[None]:
    """Turn an `OSError` inside into `DiagnosticError` RL460 of the folder."""
    try:
        yield
    except OSError as error:
        raise reason_of(folder, error) from error


def reason_of(folder: Path, error: OSError) -> DiagnosticError:
    """RL460 of a folder, or of the file in it that an error names."""
    path = str(error.filename or folder)
    return not_written(folder if PREFIX in path else Path(path), error)
