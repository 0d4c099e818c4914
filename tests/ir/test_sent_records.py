"""Records of which a scene has many are pickled by their members alone."""

from __future__ import annotations

import copy
import pickle
import pickletools
from typing import Any

import pytest

from roadlang.ir.scene import Profile, RoadPlace, Verdict

RECORDS = [
    RoadPlace("main", 3.5),
    Profile("main", (0.0, 1.0), (0.5, -0.5)),
    Verdict("near", "always (a < b)", "road", 0.5, True),
]


@pytest.mark.parametrize("record", RECORDS, ids=lambda record: type(record).__name__)
def test_they_come_back_as_they_were(record: Any) -> None:
    content = pickle.dumps(record)
    assert pickle.loads(content) == record
    assert copy.copy(record) == record
    opcodes = {opcode.name for opcode, _, _ in pickletools.genops(content)}
    assert "REDUCE" in opcodes
    assert not opcodes & {"BUILD", "NEWOBJ"}
