"""The journal of a search: a line for each outcome, written as it comes, read to go on."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

import msgspec

from ..files.journal import JournalFile
from .evaluator import Proposal
from .outcome import Outcome


class Journal(Protocol):
    """Where outcomes are kept while a search goes on."""

    def known(self, proposal: Proposal) -> Outcome | None:
        """The outcome of a candidate that was evaluated before."""
        ...

    def append(self, outcomes: Sequence[Outcome]) -> None:
        """Keep outcomes."""
        ...


class NoJournal:
    """Keeps nothing."""

    def known(self, proposal: Proposal) -> Outcome | None:
        """None: nothing is known."""
        return None

    def append(self, outcomes: Sequence[Outcome]) -> None:
        """Forget them."""


class SearchJournal:
    """A file of outcomes. `key` stands for all that they depend on; `resume`: go on with the file.

    Raises `DiagnosticError` RL702 where the file is that of another search, RL460 where it cannot
    be written.
    """

    def __init__(self, path: Path, key: str, resume: bool) -> None:
        self._file = JournalFile(path, key, resume)
        decoder = msgspec.json.Decoder(Outcome)
        outcomes = (decoder.decode(line) for line in self._file.lines)
        self._known = {outcome.index: outcome for outcome in outcomes}

    def known(self, proposal: Proposal) -> Outcome | None:
        """The outcome of that number, where its point is the same."""
        found = self._known.get(proposal.index)
        if found is None or found.point != proposal.point:
            return None
        return found if found.is_random == proposal.is_random else None

    def append(self, outcomes: Sequence[Outcome]) -> None:
        """Add lines to the file."""
        self._file.append([msgspec.json.encode(outcome) for outcome in outcomes])
