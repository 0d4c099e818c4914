"""An output folder whose files appear all together at the end, or not at all."""

from __future__ import annotations

import hashlib
import os
import shutil
import tempfile
from pathlib import Path
from types import TracebackType

from ..diagnostics import DiagnosticError, diagnose
from ..ir.manifest import OutputFile


class OutputFolder:
    """Files are written to a hidden folder beside their places and renamed by `commit`.

    Leaving the `with` block without `commit` removes everything that was written, and the folder
    itself if it was made for this run.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.files: list[OutputFile] = []
        self._owners: dict[str, str] = {}
        self._staging: Path | None = None
        self._made: list[Path] = []

    def __enter__(self) -> OutputFolder:
        try:
            self._made = _missing_parents(self.folder)
            self.folder.mkdir(parents=True, exist_ok=True)
            self._staging = Path(tempfile.mkdtemp(prefix=".roadlang-", dir=self.folder))
        except OSError as error:
            self._discard()
            raise _cannot_write(self.folder, error) from None
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._discard()

    def write(
        self, name: str, content: bytes | str, backend: str, scene: int | None = None
    ) -> OutputFile:
        """Stage one file. Raises `DiagnosticError` RL931 for a second file of the same name."""
        assert self._staging is not None
        owner = self._owners.setdefault(name, backend)
        if owner != backend or any(file.path == name for file in self.files):
            raise DiagnosticError(diagnose("RL931", first=owner, second=backend, path=name))
        data = content.encode() if isinstance(content, str) else content
        try:
            (self._staging / name).write_bytes(data)
        except OSError as error:
            raise _cannot_write(self.folder / name, error) from None
        digest = hashlib.sha256(data).hexdigest()
        file = OutputFile(name, digest, len(data), backend, scene)
        self.files.append(file)
        return file

    def write_manifest(self, content: str) -> None:
        """Stage `manifest.json`, which does not list itself."""
        assert self._staging is not None
        (self._staging / "manifest.json").write_text(content, encoding="utf-8")

    def commit(self) -> None:
        """Rename every file to its place; the manifest last, so that it never lies."""
        assert self._staging is not None
        names = sorted(os.listdir(self._staging), key=lambda name: (name == "manifest.json", name))
        try:
            for name in names:
                os.replace(self._staging / name, self.folder / name)
        except OSError as error:
            raise _cannot_write(self.folder, error) from None
        self._made = []

    def _discard(self) -> None:
        if self._staging is not None:
            shutil.rmtree(self._staging, ignore_errors=True)
            self._staging = None
        for folder in reversed(self._made):
            try:
                folder.rmdir()
            except OSError:
                break


def _missing_parents(folder: Path) -> list[Path]:
    """The folders that `mkdir` will make, outermost first."""
    chain = [folder, *folder.parents]
    return [path for path in reversed(chain) if not path.exists()]


def _cannot_write(path: Path, error: OSError) -> DiagnosticError:
    reason = (error.strerror or type(error).__name__).lower()
    return DiagnosticError(diagnose("RL927", path=str(path), reason=reason))
