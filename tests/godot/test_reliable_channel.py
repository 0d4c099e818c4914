"""Reliable delivery, on a network of pure thought: no sockets, no clock."""

from __future__ import annotations

import itertools
import random
import struct

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from roadlang_godot.net.reliable_channel import FIRST_RESEND, LAST_RESEND, Channel

STEP = 0.005


def exchange(count: int, seed: int, loss: float, double: float) -> tuple[list[bytes], Channel]:
    """Send `count` messages over a bad network until all are acknowledged."""
    chance = random.Random(seed)
    sender, receiver = Channel(), Channel()
    arrived: list[bytes] = []
    for i in range(count):
        sender.offer(17, str(i).encode())
    now = 0.0
    while not sender.idle and now < 60:
        now += STEP
        network = [m for m in sender.to_send(now) if chance.random() >= loss]
        network += [m for m in network if chance.random() < double]
        chance.shuffle(network)
        for _, seq, payload in network:
            if receiver.accept(seq):
                arrived.append(payload)
        ack = receiver.take_ack()
        if ack and chance.random() >= loss:
            sender.acknowledged(ack)
    return arrived, sender


@settings(max_examples=20)
@given(st.integers(0, 80), st.integers(0, 2**16), st.floats(0, 0.6), st.floats(0, 0.6))
def test_every_message_arrives_exactly_once(
    count: int, seed: int, loss: float, double: float
) -> None:
    arrived, sender = exchange(count, seed, loss, double)
    assert sender.idle
    assert sorted(arrived) == sorted(str(i).encode() for i in range(count))


def test_a_perfect_network_needs_no_second_sending() -> None:
    _, sender = exchange(500, seed=1, loss=0.0, double=0.0)
    assert sender.resent == 0


def test_no_more_than_the_window_is_on_its_way() -> None:
    sender = Channel(window=8)
    for _ in range(20):
        sender.offer(17, b"")
    assert len(sender.to_send(0.0)) == 8
    assert sender.to_send(0.001) == []


def test_what_is_not_acknowledged_is_named_when_patience_ends() -> None:
    sender = Channel()
    sender.offer(17, b"", "bent from 0 m to 100 m")
    sender.to_send(0.0)
    assert sender.overdue(4.9, patience=5.0) == []
    assert sender.overdue(5.1, patience=5.0) == ["bent from 0 m to 100 m"]


def test_a_message_that_others_have_overtaken_is_sent_again_at_once() -> None:
    sender, receiver = Channel(), Channel()
    for _ in range(6):
        sender.offer(17, b"")
    for _, seq, _ in sender.to_send(0.0):
        if seq != 1:
            receiver.accept(seq)
            sender.acknowledged(receiver.take_ack())
    assert [seq for _, seq, _ in sender.to_send(FIRST_RESEND / 2)] == [1]


@given(st.binary(max_size=40))
def test_a_false_acknowledgment_harms_nothing(payload: bytes) -> None:
    sender = Channel()
    sender.offer(17, b"")
    sender.to_send(0.0)
    sender.acknowledged(payload)
    assert sender.overdue(9.0, 5.0) or sender.idle


def test_what_is_not_acknowledged_is_sent_again_after_longer_and_longer_waits() -> None:
    sender = Channel()
    sender.offer(17, b"hello")
    times = [round(now * STEP, 3) for now in range(200) if sender.to_send(now * STEP)]
    waits = [round(later - now, 3) for now, later in itertools.pairwise(times)]
    expected = [FIRST_RESEND, 2 * FIRST_RESEND, LAST_RESEND, LAST_RESEND]
    assert waits[:4] == pytest.approx(expected, abs=1.5 * STEP)


def test_a_message_that_later_ones_have_overtaken_is_sent_again_at_once() -> None:
    sender = Channel()
    for number in range(6):
        sender.offer(17, bytes([number]))
    assert len(sender.to_send(0.0)) == 6
    for upto in range(2, 6):
        sender.acknowledged(struct.pack("<IQ", 0, 1 << upto - 1))  # all but the first
    assert [seq for _, seq, _ in sender.to_send(0.001)] == [1]
    sender.acknowledged(struct.pack("<IQ", 6, 0))
    assert sender.idle


def test_what_waits_while_others_arrive_is_not_late() -> None:
    sender, receiver = Channel(window=1), Channel()
    for label in ("first", "second", "third"):
        sender.offer(17, b"", label)
    for now in (0.0, 4.0, 8.0):
        (_, seq, _), *_ = sender.to_send(now)
        assert sender.overdue(now + 3.9, patience=5.0) == []
        receiver.accept(seq)
        sender.acknowledged(receiver.take_ack())
    slow = Channel()
    slow.offer(17, b"", "never taken")
    slow.offer(17, b"", "taken late")
    slow.to_send(0.0)
    slow.acknowledged(struct.pack("<IQ", 0, 1 << 1))
    assert slow.overdue(6.0, patience=5.0) == []
    assert slow.overdue(11.1, patience=5.0) == ["never taken"]
