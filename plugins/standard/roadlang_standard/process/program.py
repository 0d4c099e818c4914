"""A running program, of which each answer is awaited for a limited time."""

from __future__ import annotations

import contextlib
import json
import os
import queue
import signal
import subprocess
import threading
import weakref
from collections import deque
from collections.abc import Sequence
from typing import IO, TypeAlias

from roadlang.api import program_environment

LONGEST_LINE = 65_536
"""bytes of an answer"""
TAIL = 30
"""lines of standard error that are kept"""
LONGEST_KEPT = 300
"""bytes of each: minified source code is one line of many thousands"""
PATIENCE = 1.0
"""seconds for which a program may go on after its standard input was closed"""

Came: TypeAlias = tuple[list[bytes], bool]
"""Lines that came together, so that nobody sees the first without the others; and whether the
beginning of one more came with them."""


class ProgramFailed(Exception):
    """A program died, does not answer, or answers what it should not."""


class ProgramLate(ProgramFailed):
    """A program did not answer in time."""


class ControllerProcess:
    """A program in a session of its own, so that whatever it starts ends with it.

    Ended by `close`, when it is not referred to any more, and at the end of roadlang.
    """

    def __init__(self, command: Sequence[str]) -> None:
        try:
            self._process = subprocess.Popen(
                list(command),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                env=program_environment(),
                start_new_session=True,
            )
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            raise ProgramFailed(f"it cannot be started: {reason}{_words_of(command)}") from error
        self.close = weakref.finalize(self, _end, self._process)
        self._errors: deque[bytes] = deque(maxlen=TAIL)
        self._answers: queue.Queue[Came] = queue.Queue()
        self._next: deque[bytes] = deque()
        """lines that came together with others before them"""
        self._more_begun = False
        """whether the beginning of one more came with them"""
        process = self._process
        assert process.stdout is not None
        assert process.stderr is not None
        self._threads = [
            threading.Thread(target=_read_answers, args=(process.stdout, self._answers)),
            threading.Thread(target=_read_errors, args=(process.stderr, self._errors)),
        ]
        for thread in self._threads:
            thread.daemon = True
            thread.start()

    def send(self, line: str) -> None:
        """Write a line. Raises ProgramFailed where nobody reads."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(line.encode() + b"\n")
            self._process.stdin.flush()
        except (OSError, ValueError) as error:
            code = self._exit_code()
            ended = "it closed its standard input" if code is None else f"it ended with code {code}"
            raise self.failed(ended) from error

    def unasked(self) -> str | None:
        """A line that it wrote without being asked; None where there is none."""
        with contextlib.suppress(queue.Empty):
            line = self._line(PATIENCE if self._more_begun else 0.0)
            if line.endswith(b"\n"):
                return line.decode("utf-8", "replace").rstrip("\r\n")
            self._next.appendleft(line)  # the end, or too long a line: `receive` says so
        return None

    def _line(self, seconds: float) -> bytes:
        """The next one. Raises queue.Empty where there is none by then."""
        if not self._next:
            lines, self._more_begun = self._answers.get(timeout=seconds)
            self._next += lines
        return self._next.popleft()

    def receive(self, seconds: float) -> str:
        """The next line of its standard output. Raises ProgramFailed where there is none."""
        try:
            line = self._line(seconds)
        except queue.Empty:
            late = self.failed(f"it did not answer within {seconds:g} s")
            raise ProgramLate(str(late)) from None
        if not line:
            code = self._exit_code()
            ended = (
                "it closed its standard output" if code is None else f"it ended with code {code}"
            )
            raise self.failed(f"{ended} instead of answering")
        if not line.endswith(b"\n"):
            raise self.failed(f"its answer is longer than {LONGEST_LINE} bytes, or cut off")
        return line.decode("utf-8", "replace").rstrip("\r\n")

    def _exit_code(self) -> int | None:
        """Of a program that has ended, or ends within a moment; None of one that goes on."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(PATIENCE)
        return self._process.returncode

    def failed(self, reason: str) -> ProgramFailed:
        """The reason, with the last lines that it wrote to standard error."""
        self.close()
        self._threads[1].join(PATIENCE)
        lines = [line.decode("utf-8", "replace").rstrip() for line in list(self._errors)]
        tail = "\n".join(line for line in lines if line)
        return ProgramFailed(
            f"{reason}; the end of its standard error:\n{tail}" if tail else reason
        )


def _read_answers(stream: IO[bytes], answers: queue.Queue[Came]) -> None:
    """Lines as they come, and an empty one for the end. Of what is too long, its beginning."""
    begun = b""
    with contextlib.suppress(OSError, ValueError):
        while len(begun) < LONGEST_LINE and (part := os.read(stream.fileno(), LONGEST_LINE)):
            *lines, begun = (begun + part).split(b"\n")
            if lines:
                answers.put(([_bounded(line + b"\n") for line in lines], bool(begun)))
    answers.put(([_bounded(begun), b""] if begun else [b""], False))


def _bounded(line: bytes) -> bytes:
    return line[:LONGEST_LINE]


def _read_errors(stream: IO[bytes], errors: deque[bytes]) -> None:
    """The lines as they come, of long ones the beginning."""
    is_begun = False
    with contextlib.suppress(OSError, ValueError):
        while part := stream.readline(LONGEST_KEPT):
            if not is_begun:
                is_cut = len(part) == LONGEST_KEPT and not part.endswith(b"\n")
                errors.append(part + b" ..." if is_cut else part)
            is_begun = not part.endswith(b"\n")


def _end(process: subprocess.Popen[bytes]) -> None:
    """End a program and all that it has started: kindly, then not."""
    try:
        with contextlib.suppress(OSError, ValueError):
            if process.stdin is not None:
                process.stdin.close()
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(PATIENCE)
    finally:  # SIGTERM or Ctrl-C while it waits
        with contextlib.suppress(OSError):
            if hasattr(os, "killpg"):
                os.killpg(process.pid, signal.SIGKILL)
            else:
                process.kill()
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(PATIENCE)


def _words_of(command: Sequence[str]) -> str:
    """What to write in place of a command line in one text."""
    words = command[0].split() if len(command) == 1 else []
    return f"; write {json.dumps(words)}: each word by itself" if len(words) > 1 else ""
