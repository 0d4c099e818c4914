"""A UDP proxy that loses, doubles, reorders and corrupts datagrams in both directions."""

from __future__ import annotations

import random
import select
import socket
import threading
import time
from dataclasses import dataclass


@dataclass(frozen=True)
class Weather:
    """Chances of what happens to a datagram."""

    loss: float = 0.0
    double: float = 0.0
    reorder: float = 0.0
    corrupt: float = 0.0


class Proxy:
    """Stands between a client and an engine. Use as a context manager."""

    def __init__(self, host: str, port: int, weather: Weather, seed: int = 1) -> None:
        self._weather = weather
        self._random = random.Random(seed)
        self._engine = (host, port)
        self._inside = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._inside.bind((host, 0))
        self._outside = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._outside.bind((host, 0))
        self._client: tuple[str, int] | None = None
        self._late: list[tuple[float, socket.socket, bytes, tuple[str, int]]] = []
        self._going = True
        self._thread = threading.Thread(target=self._run, daemon=True)
        self.port: int = self._inside.getsockname()[1]

    def __enter__(self) -> Proxy:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._going = False
        self._thread.join()
        self._inside.close()
        self._outside.close()

    def _run(self) -> None:
        while self._going:
            ready, _, _ = select.select([self._inside, self._outside], [], [], 0.002)
            for source in ready:
                data, address = source.recvfrom(65536)
                if source is self._inside:
                    self._client = address
                    self._pass(self._outside, data, self._engine)
                elif self._client is not None:
                    self._pass(self._inside, data, self._client)
            now = time.monotonic()
            for one in [one for one in self._late if one[0] <= now]:
                self._late.remove(one)
                one[1].sendto(one[2], one[3])

    def _pass(self, out: socket.socket, data: bytes, to: tuple[str, int]) -> None:
        chance = self._random.random
        if chance() < self._weather.loss:
            return
        if chance() < self._weather.corrupt:
            spoilt = bytearray(data)
            spoilt[self._random.randrange(len(spoilt))] ^= 1 << self._random.randrange(8)
            data = bytes(spoilt)
        for _ in range(2 if chance() < self._weather.double else 1):
            if chance() < self._weather.reorder:
                self._late.append((time.monotonic() + 0.01 * chance(), out, data, to))
            else:
                out.sendto(data, to)
