"""Searches on a Dask cluster in this process."""

from __future__ import annotations

import platform
import sys
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

import roadlang
from roadlang import DiagnosticError
from roadlang.search.worker_pool import ALONE, Workers
from roadlang.session.cluster import cluster
from roadlang.testing import scenario
from tests.cli.command_lines import roadlang as command
from tests.falsification.slider import TEXT, Slider, numbers_in_journal

BUMPS = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }
road bent from main { perturb with bump { height: 0m..8m, at: 50m..110m, length: 40m } }
require high: sup_distance(bent, main) > 2m
"""


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    distributed = pytest.importorskip("distributed")  # takes a second: not in every worker
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None
    ) as local:
        yield local.scheduler_address


def test_a_cluster_gives_the_same_outcomes(address: str, tmp_path: Path) -> None:
    alone = scenario(TEXT, kinds=[Slider]).falsify(evaluations=120, seed=2)
    with cluster(address, 1) as workers:
        assert workers.jobs == 2
        found = scenario(TEXT, kinds=[Slider]).falsify(
            evaluations=120, seed=2, jobs=workers.jobs, executor=workers.executor, folder=tmp_path
        )
    assert found.outcomes == alone.outcomes
    assert numbers_in_journal(tmp_path) == list(range(120))


@pytest.mark.parametrize("sampler", ["random", "guided", "halton", "grid { steps: 40 }"])
def test_a_cluster_makes_the_same_scenes(address: str, sampler: str) -> None:
    def sampled(workers: Workers) -> list[str]:
        scenes = roadlang.loads(f"{BUMPS}\nsample with {sampler}").sample(
            40, seed=3, jobs=workers.jobs, executor=workers.executor
        )
        return [scene.to_json() for scene in scenes]

    with cluster(address, 1) as workers:
        assert sampled(workers) == sampled(ALONE)


def test_compile_writes_the_same_files_on_a_cluster(address: str, tmp_path: Path) -> None:
    (tmp_path / "scene.rl").write_text(BUMPS)
    for folder, options in {"alone": [], "cluster": ["--cluster", address]}.items():
        arguments = ["compile", "scene.rl", "-n", "20", *options, "-o", folder]
        done = command(*arguments, cwd=tmp_path)
        assert done.returncode == 0, done.stderr
    files = sorted(path.name for path in (tmp_path / "alone").iterdir())
    assert len(files) > 20
    for name in files:
        one, other = (tmp_path / folder / name for folder in ("alone", "cluster"))
        assert one.read_bytes() == other.read_bytes()


def test_compile_names_a_cluster_that_does_not_answer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("roadlang.session.cluster._PATIENCE", "200ms")
    (tmp_path / "scene.rl").write_text(BUMPS)
    done = command("compile", "scene.rl", "--cluster", "tcp://127.0.0.1:9", cwd=tmp_path)
    assert done.returncode == 5
    assert "RL704" in done.stderr
    assert not (tmp_path / "out").exists()


def test_a_cluster_that_does_not_answer_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("roadlang.session.cluster._PATIENCE", "200ms")
    with (
        pytest.raises(DiagnosticError, match=r"RL704(.|\n)*`dask scheduler` starts one"),
        cluster("tcp://127.0.0.1:9", 1),
    ):
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


def test_without_distributed_a_cluster_says_how_to_install_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(DiagnosticError) as caught, cluster("tcp://127.0.0.1:9", 1):
        pass
    (found,) = caught.value.diagnostics
    assert found.code == "RL704"
    assert "tcp://127.0.0.1:9" in found.message
    assert "`distributed` is not installed" in found.message
    assert found.help == ('pip install "roadlang[dask]"',)


def test_without_an_address_there_are_processes() -> None:
    with cluster(None, 3) as found:
        assert found == Workers(3)
