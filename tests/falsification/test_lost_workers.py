"""The same table from real processes, also where one is killed, and after an interruption."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

import roadlang
from roadlang import Falsification
from roadlang.session.cluster import cluster
from tests.cli.command_lines import roadlang as roadlang_here
from tests.search.worker_killer import WorkerKiller

pytestmark = pytest.mark.slow

TEXT = """
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 40m), (240m, 40m), (340m, 0m)] }
  width: 8m, lanes: 2
}
road bent from main { perturb with harmonics { modes: 4, amplitude: 6m } }
require radius: always (abs(curvature(bent)) < 1 / 14m)
agent ego is choice(car, van) on bent at 5m..15m {
  drive with stanley { speed: (14m/s)..(20m/s), lateral_acceleration: 6m/s^2 }
}
world { friction: 0.45 }
expect in_lane: always (abs(ego.cross_track_error) < 1.5m)
simulate with builtin { control_step: 0.1s }
"""
FEW: dict[str, Any] = {"evaluations": 90, "batch": 30, "seed": 2}


@pytest.fixture(scope="module")
def alone() -> Falsification:
    found = roadlang.loads(TEXT).falsify(**FEW)
    assert found.failures
    return found


def test_two_processes_give_the_table_of_one_also_where_one_is_killed(
    alone: Falsification,
) -> None:
    killer = WorkerKiller()
    found = roadlang.loads(TEXT).falsify(**FEW, jobs=2, progress=killer)
    assert killer.killed
    assert found.outcomes == alone.outcomes
    assert [one.outcome for one in found.failures] == [one.outcome for one in alone.failures]


def test_a_process_killed_at_work_loses_nothing(alone: Falsification) -> None:
    before = {process.pid for process in multiprocessing.active_children()}
    killed, evaluates = list[int](), threading.Event()

    def kill_one() -> None:
        evaluates.wait()  # until the first batch is done, whatever it takes to start two workers
        time.sleep(0.05)
        ours = [p.pid for p in multiprocessing.active_children() if p.pid not in before]
        if ours and ours[-1] is not None:
            killed.append(ours[-1])
            os.kill(ours[-1], signal.SIGKILL)

    with ThreadPoolExecutor(1) as threads:
        killing = threads.submit(kill_one)
        try:
            found = roadlang.loads(TEXT).falsify(
                **FEW, jobs=2, progress=lambda done, wanted: evaluates.set()
            )
        finally:
            evaluates.set()
        killing.result()
    assert killed
    assert found.outcomes == alone.outcomes


# Workers take a part of a core also while they wait: they end with the only test of theirs.
@pytest.fixture
def workers() -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as local:
        yield local


def test_a_cluster_that_loses_a_worker_gives_the_same_table(
    alone: Falsification, workers: Any
) -> None:
    killed: list[int] = []

    def kill_one(done: int, wanted: int) -> None:
        if not killed:
            (first, *_) = workers.workers.values()
            killed.append(first.pid)
            os.kill(first.pid, signal.SIGKILL)

    with cluster(workers.scheduler_address, 1) as crew:
        found = roadlang.loads(TEXT).falsify(
            **FEW, jobs=crew.jobs, executor=crew.executor, progress=kill_one
        )
    assert killed
    assert found.outcomes == alone.outcomes


def test_every_failure_replays_alone_to_the_same_bytes(
    alone: Falsification, tmp_path: Path
) -> None:
    for failure in alone.failures:
        path = failure.scene.save(tmp_path / "failure.json")
        drive = roadlang.Scene.from_json(path.read_text()).run()
        assert drive.verdicts["in_lane"].satisfied is False
        assert drive.verdicts["in_lane"].robustness == failure.robustness["in_lane"]
        assert drive.to_json() == failure.drive.to_json()


@pytest.mark.parametrize(
    ("command", "tables", "processes"),
    [
        (["falsify", "--evaluations", "40", "--batch", "10"], ["failing.csv", "safe.csv"], "12"),
        (["run", "-n", "24"], ["results.csv"], "2"),
    ],
    ids=["falsify", "run"],
)
def test_what_was_killed_is_resumed_to_the_same_tables(
    command: list[str], tables: list[str], processes: str, tmp_path: Path
) -> None:
    (tmp_path / "scene.rl").write_text(TEXT)
    arguments = [command[0], "scene.rl", *command[1:], "--seed", "2"]
    assert roadlang_here(*arguments, "-o", "whole", cwd=tmp_path).returncode in (0, 4)
    for jobs in processes:
        part = [*arguments, "-o", jobs, "--jobs", jobs]
        interrupted = _to_be_killed(part, tmp_path)
        _wait_for_rows(tmp_path / jobs / "journal.jsonl", 8)
        os.killpg(interrupted.pid, signal.SIGKILL)
        interrupted.wait()
        assert roadlang_here(*part, "--resume", cwd=tmp_path).returncode in (0, 4)
        for name in tables:
            assert (tmp_path / jobs / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()


def _to_be_killed(arguments: list[str], folder: Path) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, "-m", "roadlang", *arguments],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        start_new_session=True,
    )


def _wait_for_rows(journal: Path, count: int) -> None:
    for _ in range(6000):
        if journal.exists() and journal.read_bytes().count(b"\n") > count:
            return
        time.sleep(0.05)
    raise AssertionError("it has not come in five minutes")
