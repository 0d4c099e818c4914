"""An engine that somebody has started, or has not."""

from __future__ import annotations

from typing import NoReturn

import pytest

from roadlang.api import Code
from roadlang_godot.engines import running_engine
from roadlang_godot.engines.running_engine import RunningEngine
from roadlang_godot.faults import EngineError, fault


@pytest.mark.parametrize(
    ("engine", "start"),
    [
        (RunningEngine("127.0.0.1"), "`roadlang godot`"),
        (RunningEngine("127.0.0.1", 4999, "websocket"), "--port 4999 --transport websocket`"),
    ],
)
def test_where_none_answers_it_is_said_how_to_start_one(
    engine: RunningEngine, start: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def nobody(*_: object) -> NoReturn:
        raise fault(Code.GODOT_NOT_ANSWERING, seconds="5")

    monkeypatch.setattr(running_engine, "connect", nobody)
    with pytest.raises(EngineError) as raised:
        engine.connect("scene")
    (found,) = raised.value.diagnostics
    assert start in found.help[0]
    assert len(found.help) == 1


def test_what_else_can_be_done_is_said_after_that(monkeypatch: pytest.MonkeyPatch) -> None:
    def nobody(*_: object) -> NoReturn:
        raise fault(Code.GODOT_NOT_ANSWERING, seconds="5")

    monkeypatch.setattr(running_engine, "connect", nobody)
    with pytest.raises(EngineError) as raised:
        RunningEngine("127.0.0.1", otherwise="something else").connect()
    assert raised.value.diagnostics[0].help[1:] == ("something else",)
