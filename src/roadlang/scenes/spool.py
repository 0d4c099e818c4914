"""Scenes kept on disk, for whoever wants all of many."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from typing import Any, overload

from ..ir.json_document import plain_number
from ..ir.scene import Scene


class SceneSpool(Sequence[Scene]):
    """Scenes that are read again when they are asked for; the file has no name, and is gone with
    its process."""

    def __init__(self) -> None:
        import msgspec

        self._file = tempfile.TemporaryFile()  # noqa: SIM115 - closed with the spool
        self._ends = [0]
        self._decoder = msgspec.msgpack.Decoder(Scene)

    def add(self, content: bytes) -> None:
        """The next scene, as `packed` gives it."""
        self._file.seek(self._ends[-1])
        self._file.write(content)
        self._ends.append(self._ends[-1] + len(content))

    def close(self) -> None:
        """Give up the file."""
        self._file.close()

    def __len__(self) -> int:
        return len(self._ends) - 1

    @overload
    def __getitem__(self, index: int) -> Scene: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Scene]: ...
    def __getitem__(self, index: int | slice) -> Scene | Sequence[Scene]:
        if isinstance(index, slice):
            return [self[number] for number in range(*index.indices(len(self)))]
        number = range(len(self))[index]
        self._file.seek(self._ends[number])
        content = self._file.read(self._ends[number + 1] - self._ends[number])
        scene: Scene = self._decoder.decode(content)
        return scene

    def __iter__(self) -> Iterator[Scene]:
        return (self[number] for number in range(len(self)))


def packed(scene: Scene) -> bytes:
    """A scene as a spool has it."""
    import msgspec

    content: Any = msgspec.msgpack.encode(scene, enc_hook=plain_number)
    return bytes(content)
