"""The wire protocol: numbers, and the frame that every message travels in.

A frame is a 20-byte header and a payload, little-endian: `"RL"`, u8 version, u8 type, u32
session, u32 sequence number (0: not acknowledged), u32 payload length, and the first four bytes
of the MD5 of the header so far and the payload. MD5 finds errors here; it protects from nobody.
"""

from __future__ import annotations

import hashlib
import struct
from dataclasses import dataclass
from enum import IntEnum

VERSION = 2
MAX_DATAGRAM = 8192
BULK_DATAGRAM = 1200
"""What is sent in bulk fits a datagram that no network splits."""
WINDOW = 32
MAX_COORDINATE = 100_000.0

_HEADER = struct.Struct("<2sBBIII4s")
HEADER_BYTES = _HEADER.size


class Message(IntEnum):
    """The types of message; `docs/godot.md` says what each carries."""

    HELLO = 0x01
    WELCOME = 0x02
    ACK = 0x03
    ERROR = 0x04
    BYE = 0x05
    PING = 0x06
    BEGIN = 0x10
    SEGMENT = 0x11
    PATCH = 0x12
    TILES = 0x13
    OBJECTS = 0x14
    PATH = 0x15
    AGENT = 0x16
    WORLD = 0x17
    REMOVE = 0x18
    PAINT = 0x19
    SIGNALS = 0x1A
    HANDLES = 0x1B
    CAMERA = 0x1C
    LABELS = 0x1D
    COMMIT = 0x20
    BUILT = 0x21
    LIST = 0x22
    REPORT = 0x23
    PROBE = 0x24
    PROBED = 0x25
    RUN = 0x30
    STEP = 0x31
    STATE = 0x32
    DONE = 0x33
    TRACE = 0x34
    STOP = 0x35
    CONTACTS = 0x36
    VIEW = 0x40
    SHOT = 0x41
    PICTURE = 0x42
    EDIT = 0x43
    NOTE = 0x44
    LOOK = 0x45
    FRAMES = 0x46
    EXPORT = 0x48
    EXPORTED = 0x49


@dataclass(frozen=True, slots=True)
class OpenedDatagram:
    """One datagram, opened."""

    type: int
    session: int
    seq: int
    payload: bytes


def pack(type: int, session: int, seq: int, payload: bytes) -> bytes:
    """The bytes of a datagram. Raises `ValueError` where it is longer than the engine takes."""
    if len(payload) + HEADER_BYTES > MAX_DATAGRAM:
        raise ValueError(f"a message of {len(payload)} bytes is too long")
    head = _HEADER.pack(b"RL", VERSION, type, session, seq, len(payload), b"\0\0\0\0")[:16]
    return head + _check(head, payload) + payload


def unpack(datagram: bytes) -> OpenedDatagram | None:
    """The frame in a datagram, or None where anything about it is wrong."""
    if not HEADER_BYTES <= len(datagram) <= MAX_DATAGRAM:
        return None
    magic, version, type, session, seq, length, check = _HEADER.unpack_from(datagram)
    payload = datagram[HEADER_BYTES:]
    if magic != b"RL" or version != VERSION or length != len(payload):
        return None
    if check != _check(datagram[:16], payload):
        return None
    return OpenedDatagram(type, session, seq, payload)


def _check(head: bytes, payload: bytes) -> bytes:
    return hashlib.md5(head + payload, usedforsecurity=False).digest()[:4]
