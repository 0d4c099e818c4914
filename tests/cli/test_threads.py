"""Results do not depend on how many cores a machine has."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

SHOW = """
import os, sys
from roadlang.cli.main import main
try:
    main(["--version"])
except SystemExit:
    print(os.environ["OPENBLAS_NUM_THREADS"], "numpy" in sys.modules)
"""


@pytest.mark.parametrize(("before", "after"), [(None, "1"), ("2", "2")])
def test_a_command_adds_up_matrices_in_one_thread_unless_told_otherwise(
    before: str | None, after: str
) -> None:
    environment = {k: v for k, v in os.environ.items() if k != "OPENBLAS_NUM_THREADS"}
    if before is not None:
        environment["OPENBLAS_NUM_THREADS"] = before
    done = subprocess.run(
        [sys.executable, "-c", SHOW], capture_output=True, text=True, env=environment, check=True
    )
    assert done.stdout.split()[-2:] == [after, "False"]


DRAWN = """
import os, sys
from roadlang.cli.main import run
run(["compile", "none.rl", "--jobs", sys.argv[1]])
is_imported = "cv2" in sys.modules
import cv2, numpy
cv2.GaussianBlur(numpy.zeros((2000, 2000, 3), numpy.uint8), (21, 21), 3.0)
from roadlang.search.start_method import start_method
print(is_imported, cv2.getNumThreads(), start_method())
"""


@pytest.mark.skipif(sys.platform != "linux", reason="processes are forked on Linux")
@pytest.mark.parametrize(
    ("jobs", "before", "after"),
    [("2", None, ["False", "1", "fork"]), ("1", "2", ["False", "2", "spawn"])],
)
def test_processes_that_read_pictures_can_be_forked(
    jobs: str, before: str | None, after: list[str]
) -> None:
    """OpenCV starts no threads in a command that has several processes for them."""
    name = "OPENCV_FOR_THREADS_NUM"
    environment = {k: v for k, v in os.environ.items() if k != name} | {"OMP_NUM_THREADS": "1"}
    if before is not None:
        environment[name] = before
    done = subprocess.run(
        [sys.executable, "-c", DRAWN, jobs],
        capture_output=True,
        text=True,
        env=environment,
        check=True,
    )
    assert done.stdout.split()[-3:] == after


TOLD = """
import os, sys
from roadlang.cli.main import run
run(["compile", "none.rl", "--jobs", sys.argv[1]])
print(os.environ.get("OPENCV_FOR_THREADS_NUM"))
from roadlang_standard.process.program import ControllerProcess
ask = "import os; print(*(os.environ.get(each) for each in sys.argv[1:]), flush=True)"
names = ("OPENCV_FOR_THREADS_NUM", "ROADLANG_ONE_THREAD")
started = ControllerProcess([sys.executable, "-c", "import sys; " + ask, *names])
print(started.receive(60.0))
started.close()
"""


@pytest.mark.parametrize(
    ("jobs", "before", "after"),
    [("2", None, ["1", "None"]), ("1", None, ["None", "None"]), ("2", "3", ["3", "3"])],
)
def test_several_processes_have_one_thread_of_opencv_each_unless_told_otherwise(
    jobs: str, before: str | None, after: list[str]
) -> None:
    """`after`: of roadlang, and of a program that it starts."""
    name = "OPENCV_FOR_THREADS_NUM"
    environment = {k: v for k, v in os.environ.items() if k != name}
    environment["ROADLANG_ONE_THREAD"] = "1"  # of a command before, in which the user had no choice
    if before is not None:
        environment[name] = before
    done = subprocess.run(
        [sys.executable, "-c", TOLD, jobs], capture_output=True, text=True, env=environment,
        check=True,
    )  # fmt: skip
    assert done.stdout.split()[-3:] == [*after, "None"]
