"""The journal of a search: a line for each outcome, written as it comes, read to go on."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import Protocol

import msgspec

from ..diagnostics import Diagnostic
from ..files.journal import JournalFile, header_of, with_checksum
from ..files.writing import write_file
from .evaluator import Proposal
from .outcome import Outcome


class Journal(Protocol):
    """Where outcomes are kept while a search goes on."""

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """What is wrong with those of an earlier search."""
        ...

    def known(self, proposal: Proposal) -> Outcome | None:
        """The outcome of a candidate that was evaluated before."""
        ...

    def append(self, outcomes: Sequence[Outcome]) -> None:
        """Keep outcomes."""
        ...

    def removed_if_nothing_is_finished(self) -> AbstractContextManager[None]:
        """For the search: an error before anything is finished leaves no file."""
        ...


class NoJournal:
    """Keeps nothing."""

    diagnostics: tuple[Diagnostic, ...] = ()

    def known(self, proposal: Proposal) -> Outcome | None:
        """None: nothing is known."""
        return None

    def append(self, outcomes: Sequence[Outcome]) -> None:
        """Forget them."""

    def removed_if_nothing_is_finished(self) -> AbstractContextManager[None]:
        """There is nothing to remove."""
        return nullcontext()


class SearchJournal:
    """A file of outcomes. `key` stands for all that they depend on; `resume`: go on with the file.

    Raises `DiagnosticError` RL702 where the file is that of another search, RL460 where it cannot
    be written.
    """

    def __init__(self, path: Path, key: str, resume: bool) -> None:
        decoder = msgspec.json.Decoder(Outcome)
        self._file = JournalFile(path, key, resume, decoder.decode)
        self._known = {outcome.index: outcome for outcome in self._file.entries}

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """A warning of lines that cannot be read (RL724)."""
        return self._file.diagnostics

    def known(self, proposal: Proposal) -> Outcome | None:
        """The outcome of that number, where its point is the same."""
        found = self._known.get(proposal.index)
        if found is None or found.point != proposal.point:
            return None
        return found if found.is_random == proposal.is_random else None

    def removed_if_nothing_is_finished(self) -> AbstractContextManager[None]:
        """Where a `DiagnosticError` ends the search before anything is finished, no file is
        left."""
        return self._file.removed_if_nothing_is_finished()

    def append(self, outcomes: Sequence[Outcome]) -> None:
        """Add lines to the file."""
        self._file.append([msgspec.json.encode(outcome) for outcome in outcomes])


def write_journal(path: Path, key: str, outcomes: Sequence[Outcome]) -> None:
    """Write the journal of a search that kept none there; one that holds all of these outcomes
    stays, as it may hold more. Raises `DiagnosticError` RL460."""
    lines = [with_checksum(msgspec.json.encode(outcome)) for outcome in outcomes]
    try:
        header, *known = path.read_bytes().split(b"\n")
        if header == header_of(key) and {*lines} <= {*known}:
            return
    except OSError:
        pass  # there is none
    write_file(path, b"".join(line + b"\n" for line in (header_of(key), *lines)))
