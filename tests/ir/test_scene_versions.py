"""Scenes of the first schema version are read as the present one."""

from __future__ import annotations

from typing import Any

import pytest

from roadlang.ir.scene_versions import UnknownSceneSchema, current

FIRST = "roadlang.scene/1"


def read(record: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = current({"schema": FIRST, **record})
    assert found.pop("schema") == "roadlang.scene/2"
    return found


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("cross_track", "cross_track_error"),
        ("standard.cross_track", "standard.cross_track_error"),
        ("standard.speed", "standard.speed"),
        ("cross_track.other", "cross_track.other"),
    ],
)
def test_kinds_have_their_present_names(old: str, new: str) -> None:
    assert read({"signals": [{"kind": old}]}) == {"signals": [{"kind": new}]}


def test_options_have_their_present_names_and_keep_their_values() -> None:
    options = {"colour": "colour", "one": "ego", "other": "lead"}
    assert read({"options": options}) == {
        "options": {"color": "colour", "first": "ego", "second": "lead"}
    }


def test_the_other_of_a_kind_that_has_no_first_is_its_own() -> None:
    assert read({"options": {"other": "lead"}}) == {"options": {"other": "lead"}}
    assert read({"one": 1, "colour": 2}) == {"one": 1, "colour": 2}, "no options: members"


def test_a_present_scene_is_taken_as_it_is() -> None:
    record = {"schema": "roadlang.scene/2", "options": {"colour": 1}}
    assert current(record) is record


@pytest.mark.parametrize("record", [{}, {"schema": "roadlang.scene/3"}, [1], None])
def test_other_records_are_refused(record: Any) -> None:
    with pytest.raises(UnknownSceneSchema, match=r"the schema is |it names no schema, not "):
        current(record)
