"""Maps with one fault in a byte, tag or number: read, or refused with the place."""

from __future__ import annotations

import re
from pathlib import Path

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import roadlang
from roadlang import testing
from roadlang_formats.read_opendrive import OpenDriveMap
from roadlang_formats.read_osm import OpenStreetMap
from tests.formats.small_maps import crossing
from tests.formats.test_read_osm import osm, way

OPENDRIVE = crossing()
OSM = osm(way(1, "31 33 35", lanes="3"), way(2, "13 33 53", oneway="yes"))
NUMBERS = ("nan", "inf", "-1", "0", "1e308", "", "x", "1e9", "-1e6", "9" * 20, "3", "1e-300")
_ATTRIBUTE = re.compile(r' [\w]+="([^"]*)"')
_TAG = re.compile(r"<[^>]*>")
QUIET = settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)


@st.composite
def broken(draw: st.DrawFn, text: str) -> bytes:
    """One to three faults."""
    for _ in range(draw(st.integers(1, 3))):
        kind = draw(st.sampled_from(("number", "attribute", "tag", "cut", "byte")))
        places = list((_TAG if kind == "tag" else _ATTRIBUTE).finditer(text))
        if not places:
            continue
        place = draw(st.sampled_from(places))
        start, end = place.span()
        if kind == "number":
            start, end = place.span(1)
            text = text[:start] + draw(st.sampled_from(NUMBERS)) + text[end:]
        elif kind == "cut":
            text = text[:start]
        elif kind == "byte":
            text = text[:start] + draw(st.characters(codec="utf-8")) + text[start + 1 :]
        else:
            text = text[:start] + text[end:]
    return text.encode()


def is_read_or_refused(reader: OpenDriveMap | OpenStreetMap, path: Path, content: bytes) -> bool:
    """Whether it was read. A refusal has a place in the file."""
    path.write_bytes(content)
    try:
        reader.read(path)
    except roadlang.DiagnosticError as error:
        for found in error.diagnostics:
            assert found.code in ("RL479", "RL400")
            assert found.span is not None or not content
        return False
    return True


@QUIET
@given(content=broken(OPENDRIVE))
def test_broken_opendrive_is_read_or_refused(tmp_path: Path, content: bytes) -> None:
    is_read_or_refused(OpenDriveMap(), tmp_path / "town.xodr", content)


@QUIET
@given(content=broken(OSM))
def test_broken_osm_is_read_or_refused(tmp_path: Path, content: bytes) -> None:
    is_read_or_refused(OpenStreetMap(), tmp_path / "town.osm", content)


@settings(QUIET, max_examples=25)
@given(content=broken(OPENDRIVE))
def test_broken_maps_that_are_read_become_scenes(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "town.xodr"
    if is_read_or_refused(OpenDriveMap(), path, content):
        codes = []
        try:
            testing.sample(f'network town from "{path}"\n')
        except roadlang.DiagnosticError as error:
            codes = [found.code for found in error.diagnostics]
        assert "RL470" not in codes
