"""Workers of a running Dask cluster, as an executor."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from ..diagnostics import Code, DiagnosticError, diagnose
from ..search.worker_pool import Workers
from ..version import __version__

if TYPE_CHECKING:
    from distributed import Client


_PATIENCE = "10s"
_RETRIES = 5
"""How often a job is done again whose worker was lost."""


@contextmanager
def cluster(address: str | None, jobs: int) -> Iterator[Workers]:
    """The workers at the scheduler `address`, without an address `jobs` processes.

    Raises `DiagnosticError` RL704 where the cluster cannot be used.
    """
    if address is None:
        yield Workers(jobs)
        return
    try:
        from distributed import Client
    except ImportError:
        reason, help_ = "`distributed` is not installed", 'pip install "roadlang[dask]"'
        fault = diagnose(Code.CLUSTER_NOT_REACHED, address=address, reason=reason, help=help_)
        raise DiagnosticError(fault) from None
    try:
        client = Client(address, timeout=_PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        reason = str(error) or "no scheduler answers there"
        help_ = "`dask scheduler` starts one and prints its address, such as `tcp://10.0.0.5:8786`"
        fault = diagnose(Code.CLUSTER_NOT_REACHED, address=address, reason=reason, help=help_)
        raise DiagnosticError(fault) from error
    with client:
        workers = sum(client.nthreads().values())
        unfit = _unfit(client) if workers else "it has no workers"
        if unfit:
            fault = diagnose(
                Code.CLUSTER_NOT_REACHED, address=address, reason=unfit, help=_needs(workers)
            )
            raise DiagnosticError(fault)
        yield Workers(workers, client.get_executor(retries=_RETRIES, pure=False))


def _needs(workers: int) -> str:
    """What to do about a cluster without workers, or with others."""
    if not workers:
        return "`dask worker ADDRESS` starts one"
    return f"its machines need `pip install roadlang=={__version__}` and the same plugins"


def worker_version() -> str:
    """The version of roadlang where this runs."""
    return __version__


def _unfit(client: Client) -> str | None:
    """Why its scheduler or its workers cannot do our work. Both load what they pass on."""
    try:
        client.submit(worker_version, pure=False).result(_PATIENCE)
        found = set(client.run(worker_version).values())
    except Exception:  # noqa: BLE001 - whatever is raised there, of whatever is installed there
        return "its scheduler or its workers cannot load roadlang and its plugins"
    others = sorted(found - {__version__})
    return f"it has roadlang {', '.join(others)}, not {__version__}" if others else None
