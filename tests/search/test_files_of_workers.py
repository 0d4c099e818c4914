"""A file that workers elsewhere do not have: the error says that it is they who read it."""

from __future__ import annotations

import os
import pickle
from collections.abc import Callable
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

import roadlang

TEXT = """
image photo from "road.png" { scale: 1m/px }
network town from photo { extract with contour }
road main from town { width: 7m, lanes: 2 }
agent ego is car on main at 5m { lane: -1, drive with lane_follow { speed: 5m/s..9m/s } }
expect calm: always (ego.speed < 8m/s)
"""


class Elsewhere:
    """An executor on a machine without the picture."""

    def __init__(self, picture: Path) -> None:
        self.picture, self.hidden = picture, picture.with_suffix(".gone")

    def submit(self, function: Callable[..., Any], /, *arguments: Any) -> Future[Any]:
        done: Future[Any] = Future()
        os.rename(self.picture, self.hidden)
        try:
            sent = pickle.loads(pickle.dumps((function, arguments)))  # as other processes get it
            done.set_result(sent[0](*sent[1]))
        except roadlang.DiagnosticError as error:
            done.set_exception(error)
        finally:
            os.rename(self.hidden, self.picture)
        return done


def test_the_error_says_that_workers_read_the_file(tmp_path: Path) -> None:
    pixels = cv2.line(np.zeros((120, 200, 3), np.uint8), (0, 20), (199, 60), (255, 255, 255), 9)
    assert cv2.imwrite(str(tmp_path / "road.png"), pixels)
    scene = tmp_path / "scene.rl"
    scene.write_text(TEXT)
    executor = Elsewhere(tmp_path / "road.png")
    with pytest.raises(roadlang.DiagnosticError) as caught:
        roadlang.load(scene).falsify(evaluations=20, executor=executor, jobs=2)
    (found,) = caught.value.diagnostics
    assert found.code == "RL400"
    assert found.help[-1].startswith("workers read input files themselves, at the same path")
    assert roadlang.load(scene).falsify(evaluations=20).outcomes
