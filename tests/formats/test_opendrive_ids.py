"""A map that is read and written again has the same roads under the same ids: OpenSCENARIO files
and programs that name them still fit."""

from __future__ import annotations

from pathlib import Path
from xml.etree.ElementTree import tostring

import roadlang
from roadlang.commands import emitted_files
from tests.formats.opendrive_reader import ReadFile
from tests.formats.small_maps import crossing, piece, road, xodr


def again(folder: Path, *, more: str = "", **maps: str) -> ReadFile:
    """The file that is written of maps, each a network."""
    for name, text in maps.items():
        (folder / f"{name}.xodr").write_text(text)
    networks = "".join(f'network {name} from "{name}.xodr"\n' for name in maps)
    scene = roadlang.loads(networks + more, folder=folder).sample()[0]
    return ReadFile.of(emitted_files("opendrive", scene.record, scene.registry)["xodr"].decode())


def two(first: int, second: int) -> str:
    return xodr(
        road(first, 50.0, piece(0, 0, 0, 0, 50)),
        road(second, 60.0, piece(0, 0, 90, 0, 60), name="High Street"),
    )


def outside(found: ReadFile) -> dict[int, float]:
    return {id: road.length for id, road in found.roads.items() if road.junction < 0}


def test_roads_keep_their_ids(tmp_path: Path) -> None:
    assert outside(again(tmp_path, town=two(0, 7))) == {0: 50.0, 7: 60.0}


def test_connecting_roads_and_junctions_have_others(tmp_path: Path) -> None:
    before = ReadFile.of(crossing())
    found = again(tmp_path, town=crossing())
    assert outside(found) == outside(before)
    assert len(found.roads) > len(outside(found))


def test_roads_outside_of_networks_get_the_ids_that_follow(tmp_path: Path) -> None:
    more = "road own { draw with waypoints { points: [(0m, 40m), (70m, 40m)] } }\n"
    found = again(tmp_path, town=two(3, 7), more=more)
    assert outside(found) == {3: 50.0, 7: 60.0, 8: 70.0}


def test_of_two_maps_with_the_same_ids_neither_keeps_them(tmp_path: Path) -> None:
    found = again(tmp_path, town=two(3, 7), other=two(7, 9).replace('y="0"', 'y="300"'))
    assert sorted(outside(found)) == [1, 2, 3, 4]


def test_roads_without_a_name_get_none(tmp_path: Path) -> None:
    """`emit opendrive` calls them `town/0`, which is no street."""
    once = again(tmp_path, town=two(0, 7))
    names = [road.element.attrib["name"] for road in once.roads.values()]
    assert names == ["town/0", "High Street"]
    (tmp_path / "again.xodr").write_text(tostring(once.root, encoding="unicode"))
    scene = roadlang.loads('network town from "again.xodr"', folder=tmp_path).sample()[0]
    assert [road.street for road in scene.record.roads] == ["", "High Street"]


def test_a_name_like_that_in_a_file_of_others_is_one(tmp_path: Path) -> None:
    (tmp_path / "town.xodr").write_text(two(0, 7).replace("High Street", "A9/3"))
    scene = roadlang.loads('network town from "town.xodr"', folder=tmp_path).sample()[0]
    assert [road.street for road in scene.record.roads] == ["", "A9/3"]
