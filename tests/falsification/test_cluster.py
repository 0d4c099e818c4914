"""Searches on a Dask cluster in this process."""

from __future__ import annotations

import platform
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import pytest

from roadlang import DiagnosticError
from roadlang.session.cluster import cluster
from roadlang.testing import scenario
from tests.falsification.slider import TEXT, Slider

distributed = pytest.importorskip("distributed")


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None
    ) as local:
        yield local.scheduler_address


def test_a_cluster_gives_the_same_outcomes(address: str) -> None:
    alone = scenario(TEXT, kinds=[Slider]).falsify(evaluations=120, seed=2)
    with cluster(address, 1) as (count, executor):
        assert count == 2
        found = scenario(TEXT, kinds=[Slider]).falsify(
            evaluations=120, seed=2, jobs=count, executor=executor
        )
    assert found.outcomes == alone.outcomes


def test_a_cluster_that_does_not_answer_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("roadlang.session.cluster._PATIENCE", "200ms")
    with pytest.raises(DiagnosticError, match="RL704"), cluster("tcp://127.0.0.1:9", 1):
        pass


class Unloadable:
    """A function that cannot be loaded where it is to run."""

    def __call__(self) -> str:
        raise AssertionError

    def __reduce__(self) -> tuple[Callable[[str], Any], tuple[str]]:
        return import_module, ("roadlang_that_is_not_installed",)


def test_workers_without_roadlang_are_refused(
    address: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("roadlang.session.cluster.worker_version", Unloadable())
    with pytest.raises(DiagnosticError, match=r"RL704.*cannot load roadlang"), cluster(address, 1):
        pass


def test_workers_with_another_version_are_refused(
    address: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("roadlang.session.cluster.__version__", "9.9")
    monkeypatch.setattr("roadlang.session.cluster.worker_version", platform.python_version)
    match = f"RL704.*it has roadlang {platform.python_version()}, not 9.9"
    with pytest.raises(DiagnosticError, match=match), cluster(address, 1):
        pass


def test_without_an_address_there_are_processes() -> None:
    with cluster(None, 3) as found:
        assert found == (3, None)
