"""Frames: what is packed is unpacked, and nothing else is."""

from __future__ import annotations

import hashlib
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from roadlang_godot.net import protocol
from roadlang_godot.net.protocol import OpenedDatagram, pack, unpack

numbers = st.integers(0, 2**32 - 1)


@given(st.integers(0, 255), numbers, numbers, st.binary(max_size=2000))
def test_what_is_packed_is_unpacked(type: int, session: int, seq: int, payload: bytes) -> None:
    assert unpack(pack(type, session, seq, payload)) == OpenedDatagram(type, session, seq, payload)


@given(st.binary(max_size=200), st.data())
def test_one_flipped_bit_spoils_a_frame(payload: bytes, data: st.DataObject) -> None:
    whole = bytearray(pack(17, 1, 2, payload))
    bit = data.draw(st.integers(0, 8 * len(whole) - 1))
    whole[bit // 8] ^= 1 << bit % 8
    assert unpack(bytes(whole)) is None


@given(st.binary(max_size=300))
def test_noise_is_no_frame(noise: bytes) -> None:
    assert unpack(noise) is None


@given(st.binary(min_size=1, max_size=200), st.data())
def test_a_frame_cut_short_is_no_frame(payload: bytes, data: st.DataObject) -> None:
    whole = pack(17, 1, 2, payload)
    assert unpack(whole[: data.draw(st.integers(0, len(whole) - 1))]) is None


def test_what_is_too_long_is_refused_before_it_is_sent() -> None:
    with pytest.raises(ValueError, match="too long"):
        pack(17, 1, 2, bytes(protocol.MAX_DATAGRAM))


@pytest.mark.parametrize(
    ("magic", "version", "length", "is_one"),
    [
        (b"RL", protocol.VERSION, 3, True), (b"RM", protocol.VERSION, 3, False),
        (b"RL", protocol.VERSION + 1, 3, False), (b"RL", protocol.VERSION, 2, False),
        (b"RL", protocol.VERSION, 4, False),
    ],
)  # fmt: skip
def test_a_frame_of_another_protocol_is_none_though_its_bytes_are_whole(
    magic: bytes, version: int, length: int, is_one: bool
) -> None:
    head = magic + struct.pack("<BBIII", version, 17, 1, 2, length)
    check = hashlib.md5(head + b"abc", usedforsecurity=False).digest()[:4]
    found = OpenedDatagram(17, 1, 2, b"abc") if is_one else None
    assert unpack(head + check + b"abc") == found


def test_the_longest_frame_is_as_long_as_the_engine_takes() -> None:
    most = protocol.MAX_DATAGRAM - protocol.HEADER_BYTES
    whole = pack(17, 1, 2, bytes(most))
    assert len(whole) == protocol.MAX_DATAGRAM
    assert unpack(whole) == OpenedDatagram(17, 1, 2, bytes(most))
    with pytest.raises(ValueError, match=f"a message of {most + 1} bytes is too long"):
        pack(17, 1, 2, bytes(most + 1))
