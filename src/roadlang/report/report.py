"""A folder of results to its page."""

from __future__ import annotations

from pathlib import Path

from ..plugins.registry import Registry
from .page_text import page_text
from .reading import read_record
from .results import Results
from .run_results import read_run, results_folder
from .search_results import read_search


def read_results(folder: Path, registry: Registry) -> Results:
    """What `roadlang run` or `roadlang falsify` wrote into a folder.

    Raises `DiagnosticError` RL720 where there is nothing of the kind, RL721 for a file of it that
    cannot be read.
    """
    record = read_record(results_folder(folder))
    read = read_search if record.command == "falsify" else read_run
    return read(folder, record, registry)


def report(folder: Path, registry: Registry) -> str:
    """The HTML document on a folder. Raises as `read_results` does."""
    return page_text(read_results(folder, registry), registry)
