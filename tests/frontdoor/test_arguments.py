"""Arguments of another type or without sense are refused where they are given, by their names."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

import roadlang
from roadlang import DiagnosticError
from roadlang.api import OptionError, Perturber, option
from roadlang.testing import scenario
from tests.straight_road import STRAIGHT

SCENE = STRAIGHT + (
    "param first = 1m/s..3m/s\n"
    "agent ego is car on main at 10m { start_speed: first, drive with brake }\n"
    "expect slow: always (ego.speed < 9m/s)\n"
)
LOADED: Any = roadlang.loads(SCENE)
SCENES: Any = LOADED.sample(1)
FRONT: Any = roadlang

WRONG: list[tuple[Callable[[], Any], str]] = [
    (lambda: FRONT.load(3), "`file` must be a path, as text or a `pathlib.Path`, not 3"),
    (lambda: FRONT.load(b"scene.rl"), "`file` must be a path"),
    (lambda: FRONT.loads(SCENE, params={}), "`params` must be a number, or a text"),
    (lambda: FRONT.loads(None), "`text` must be text, not None"),
    (lambda: FRONT.loads(SCENE, folder=3), "`folder` must be a path"),
    (lambda: LOADED.with_params("first=3m/s"), "`params` must be a map, such as a dict"),
    (lambda: LOADED.with_params({3: 4}), "`params` must be a map whose keys are texts, not 3"),
    (lambda: LOADED.with_param_file(None), "`file` must be a path"),
    (lambda: LOADED.with_text(3), "`text` must be text"),
    (lambda: LOADED.with_outputs([3]), "`outputs` must be text or a list of texts"),
    (lambda: LOADED.sample(True), "`n` must be an integer, not True"),
    (lambda: LOADED.sample(jobs=0), "`jobs` must be at least 1, not 0"),
    (lambda: LOADED.sample(jobs="2"), "`jobs` must be an integer, not '2'"),
    (lambda: LOADED.sample(executor=3), "`executor` must be something with a method `submit`"),
    (lambda: LOADED.sample(progress=True), "`progress` must be a function, not True"),
    (lambda: LOADED.sample(count=2), "sample() has no argument `count`: did you mean `n`?"),
    (lambda: LOADED.sample(sede=2), "sample() has no argument `sede`: did you mean `seed`?"),
    (lambda: LOADED.falsify(3), "`expects` must be text or a list of texts, not 3"),
    (lambda: LOADED.falsify(jobs=0), "`jobs` must be at least 1"),
    (lambda: LOADED.falsify(searcher=3), "`searcher` must be text"),
    (lambda: LOADED.falsify(options=3), "`options` must be a map"),
    (lambda: LOADED.falsify(resume=True), "`resume` needs the `folder`"),
    (lambda: LOADED.falsify(output="x"), "falsify() has no argument `output`: did you mean `fold"),
    (lambda: LOADED.falsify(duration=2), 'no argument `duration`: write `options={"duration": '),
    (lambda: LOADED.falsify(first="2m/s"), "params come before, by `with_params(first=...)`"),
    (lambda: SCENES.run(2), "`engine` must be text, not 2"),
    (lambda: SCENES.emit(None), "`folder` must be a path"),
    (lambda: SCENES.emit("out", progress=3), "`progress` must be a function"),
    (lambda: SCENES[0].save(""), "`path` must name a file, not ''"),
    (lambda: FRONT.Scene.from_json({}), "`text` must be the text of a document, not {}"),
    (lambda: FRONT.write_report(3), "`folder` must be a path"),
    (lambda: FRONT.read_drive(None), "`file` must be a path"),
]


@pytest.mark.parametrize(("call", "says"), WRONG, ids=[says for _, says in WRONG])
def test_an_argument_that_is_wrong_is_named(call: Callable[[], Any], says: str) -> None:
    with pytest.raises((TypeError, ValueError)) as caught:
        call()
    assert says in str(caught.value)


OPTIONS: list[tuple[Callable[[], Any], str]] = [
    (lambda: SCENES.run(duration="2s"), "RL206]: `duration` expects time (s), but this is '2s'"),
    (lambda: SCENES.run(step="20ms"), "write `step=0.02`: numbers from Python have SI units"),
    (lambda: SCENES.run(duration=None), "RL206]: `duration` expects time (s), but this is None"),
    (lambda: SCENES.run(duration=np.nan), "RL206]: `duration` expects time (s), but this is nan"),
    (lambda: SCENES.run(duration=-1), "RL208]: `duration` must be > 0s"),
    (lambda: SCENES.run(""), "RL930]: there is no engine called ``"),
    (lambda: SCENES[0].svg(legend="yes"), "RL206]: `legend` expects true | false"),
    (lambda: SCENES[0].svg(photo=3), "RL206]: `photo` expects the name of an image"),
    (lambda: LOADED.falsify(seconds="10s"), "write `seconds=10`"),
    (lambda: LOADED.falsify(options={"duration": "2s"}), "write `duration=2`"),
    (lambda: LOADED.falsify(evaluations=2.5), "RL206]: `evaluations` expects integer"),
    (lambda: LOADED.with_outputs(""), "RL928]"),
    (lambda: LOADED.with_outputs("json,svgg"), "did you mean `svg`?"),
]


@pytest.mark.parametrize(("call", "says"), OPTIONS, ids=[says for _, says in OPTIONS])
def test_options_from_python_are_checked_as_those_of_a_file(
    call: Callable[[], Any], says: str
) -> None:
    with pytest.raises(DiagnosticError) as caught:
        call()
    assert says in str(caught.value)
    assert "fault of the plugin" not in str(caught.value)


def test_numbers_of_numpy_and_lists_are_options() -> None:
    (drive,) = SCENES.run(duration=np.int64(1))
    assert drive.duration == pytest.approx(1.0)
    assert len(LOADED.falsify(evaluations=3.0, batch=np.int32(3)).outcomes) == 3


def test_several_outputs_in_one_text(tmp_path: Path) -> None:
    files = SCENES.emit(tmp_path, "json, svg { size: 300px, legend: false }").files
    assert {Path(file.path).suffix for file in files} == {".json", ".svg"}


def test_an_argument_of_another_tool_may_be_the_name_of_a_param() -> None:
    loaded: Any = roadlang.loads("param count = 8m\n" + STRAIGHT.replace("8m", "count"))
    assert loaded.sample(count="6m")[0].values["count"] == 6.0


def test_an_option_error_of_no_option_is_a_fault_of_the_plugin() -> None:
    @dataclass(frozen=True)
    class Odd(Perturber):
        """Complains of an option that it does not have."""

        name: ClassVar[str] = "odd"
        height: float = option(1.0, help="how high")

        def displacement(self, road: Any, random: Any) -> Any:
            raise OptionError("width", "is too small")

    text = STRAIGHT + "road bent from main { perturb with odd }\n"
    with pytest.raises(DiagnosticError) as caught:
        scenario(text, kinds=[Odd]).sample()
    (found,) = caught.value.diagnostics
    assert (found.code, found.help[0]) == ("RL470", "its options are height")
    assert "an OptionError of `width`, which is not one of its options" in found.message
