"""What all tests share: property tests without a stopwatch, the same examples on every run.

Other examples: `pytest --hypothesis-profile=seeded --hypothesis-seed=1`.
"""

import gc
import os
from collections.abc import Generator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

settings.register_profile(
    "roadlang",
    deadline=None,
    max_examples=25,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.register_profile(
    "seeded", parent=settings.get_profile("roadlang"), derandomize=False, database=None
)
settings.load_profile("roadlang")

pytest_plugins = ["roadlang.testing", "tests.scene_texts"]


COLLECTED_AFTER = (50_000, 20, 100)
"""Thresholds of the garbage collector, above its defaults: most objects of a test live until it
ends, and two in a hundred seconds went into looking for others."""
MOST_WORKERS = 8
"""`-n auto` starts no more, however many cores there are: each has Godot engines of its own."""


def pytest_configure() -> None:
    """Files are not waited for until they are on the disk: that is for power cuts. What a killed
    process has written is there."""
    os.fsync = lambda fd: None


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int | None:
    """As many as cores, up to `MOST_WORKERS`; PYTEST_XDIST_AUTO_NUM_WORKERS says it otherwise."""
    if "PYTEST_XDIST_AUTO_NUM_WORKERS" in os.environ:
        return None
    known = hasattr(os, "sched_getaffinity")
    cores = len(os.sched_getaffinity(0)) if known else os.cpu_count() or 1
    return min(cores, MOST_WORKERS)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Thousands of tests are made and none is dropped: there is no garbage to look for, and none
    is among them later."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(*COLLECTED_AFTER)
        gc.enable()


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Tests of engines come first: they wait for most of their time, which costs nothing while
    other workers compute, and half a core while they are all that is left."""
    items.sort(key=lambda item: not item.nodeid.startswith("tests/godot/"))


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """With `-m slow`, most files have nothing to run: those are not imported."""
    if config.option.markexpr != "slow" or not collection_path.name.startswith("test_"):
        return None
    return "mark.slow" not in collection_path.read_text(encoding="utf-8") or None
