"""Things: what a scene is sent as. Each is set whole, by kind and id, at a revision."""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from .protocol import BULK_DATAGRAM, HEADER_BYTES, MAX_DATAGRAM, Message

_PREFIX = struct.Struct("<HHII")
_RECORD = struct.Struct("<BII16s")
RECORD_BYTES = _RECORD.size
BULK_BODY = BULK_DATAGRAM - HEADER_BYTES - _PREFIX.size
"""Bytes of the longest body of a part that is one of many; longer things are several parts."""
LONGEST_BODY = MAX_DATAGRAM - HEADER_BYTES - _PREFIX.size
"""Bytes of the longest body that a datagram holds."""

Key = tuple[int, int]


@dataclass(frozen=True, slots=True)
class ScenePart:
    """A part of a scene. `body` builds it; `content` is what the engine must then hold."""

    kind: Message
    id: int
    body: bytes
    content: bytes
    label: str

    @property
    def key(self) -> Key:
        """What identifies a thing within a scene."""
        return (self.kind, self.id)

    def message(self, world: int, revision: int) -> bytes:
        """The payload that builds it in a world."""
        return _PREFIX.pack(world, 0, self.id, revision) + self.body

    def record(self, revision: int) -> bytes:
        """The proof that it was built: kind, id, revision, MD5 of the content."""
        digest = hashlib.md5(self.content, usedforsecurity=False).digest()
        return _RECORD.pack(self.kind, self.id, revision, digest)


def removal(world: int, key: Key, revision: int) -> bytes:
    """The payload that removes a thing."""
    return _PREFIX.pack(world, 0, key[1], revision) + struct.pack("<B", key[0])


def part_digest(records: Iterable[bytes]) -> bytes:
    """The digest of a whole world; records are ordered by kind and id."""
    ordered = sorted(records, key=record_key)
    return hashlib.md5(b"".join(ordered), usedforsecurity=False).digest()


def record_key(record: bytes) -> Key:
    """Kind and id of a record."""
    kind, id, _, _ = _RECORD.unpack(record)
    return (kind, id)


def unlike(
    wanted: Mapping[Key, bytes], found: Mapping[Key, bytes], labels: Mapping[Key, str]
) -> list[str]:
    """What is missing, or not as its record says; and what nobody has asked for."""
    extra = [f"something never sent ({key[0]:#x}, {key[1]})" for key in found.keys() - wanted]
    return [labels[key] for key in wanted if found.get(key) != wanted[key]] + sorted(extra)
