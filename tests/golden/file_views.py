"""What is read from files of numbers, right and faulty ones, in lines."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from roadlang import DiagnosticError, stl
from roadlang.api import read_image
from roadlang.geometry import Curve, GeometryError, Road
from roadlang.session.param_files import read_params
from roadlang_standard.read_csv import Csv
from roadlang_standard.read_ros_map import RosMap
from roadlang_standard.recorded_poses import recording
from tests.golden.comparing import SCENES
from tests.golden.summaries import array

_ROADS = {
    "x,y,width": "x,y,width\n0,0,6\n50,0,7\n100,9,8\n",
    "nothing": "",
    "one row": "x,y\n1,2\n",
    "words": "x,y\n1,2\na,b\n",
    "ragged": "x,y\n1,2\n3,4,5\n",
    "infinite": "x,y\n1,2\ninf,4\n",
    "other names": "east,north\n0,0\n50,0\n100,9\n",
    "sides": "# x_m,y_m,w_tr_right_m,w_tr_left_m\n0,0,2,3\n50,0,2,4\n100,9,3,3\n",
    "closed": "x;y\n0;0\n50;0\n50;50\n0;50\n0;0\n",
    "upper case": "X_M\tY_M\n0\t0\n50\t0\n100\t9\n",
    "quoted": '"x","y"\n0,0\n50,0\n\n100,9\n# 3,4\n',
    "no width": "x,y,width\n0,0,0\n50,0,7\n100,9,8\n",
    "four columns": "1,2,3,4\n5,6,7,8\n50,6,7,8\n",
}
_POSES = {
    "table": "time,x,y,heading\n0,0,0,0\n1,5,0,0.1\n3,9,4,0.4\n",
    "with speed": "time,x,y,heading,speed\n0,0,0,0,4\n1,5,0,0.1,3\n",
    "agents": "time,agent,x,y,heading\n0,ego,0,0,0\n0,lead,9,0,0\n1,ego,1,0,0\n1,lead,12,0,0\n",
    "no heading": "time,x,y\n0,0,0\n1,5,0\n",
    "back in time": "time,x,y,heading\n1,0,0,0\n0,5,0,0\n",
    "one row": "time,x,y,heading\n1,0,0,0\n",
    "words": "time,x,y,heading\n1,0,0,0\n2,a,0,0\n",
    "nothing": "",
    "no document": '{"agents": 3}',
    "document": '{"agents": {"ego": {"time": [0, 2], "x": [0, 2], "y": [0, 1], "heading": [0, 0]}},'
    ' "time": [0, 2]}',
}
_MAPS = {
    "right": "image: map.png\nresolution: 0.5\norigin: [3, -4, 0.2]\n",
    "negated": "image: map.png\nresolution: 0.5\nnegate: 1\n",
    "thresholds": "image: map.png\nresolution: 0.5\nfree_thresh: 0.9\noccupied_thresh: 0.95\n",
    "none free": "image: map.png\nresolution: 0.5\nfree_thresh: 0\n",
    "two numbers": "image: map.png\nresolution: 0.5\norigin: [3, 4]\n",
    "no image": "resolution: 0.5\n",
    "no resolution": "image: map.png\n",
    "below zero": "image: map.png\nresolution: -0.5\n",
    "falling": "image: map.png\nresolution: 0.5\nfree_thresh: 0.7\n",
    "above one": "image: map.png\nresolution: 0.5\nfree_thresh: 0.7\noccupied_thresh: 1.5\n",
    "other mode": "image: map.png\nresolution: 0.5\nmode: scale\n",
    "word": "image: map.png\nresolution: a\n",
    "origin": "image: map.png\nresolution: 0.5\norigin: 3\n",
    "origin of words": "image: map.png\nresolution: 0.5\norigin: [a, 1, 2]\n",
    "list": "- 3\n",
    "no yaml": "image: [\n",
    "missing": "image: nap.png\nresolution: 0.5\n",
}
_PARAMS = {
    "map": "{ a: 3m, b: 1.5, c: true, d: word, e: [1m, 2m] }",
    "list": "- { a: 3m }\n- { a: 4m, b: '2 + 3' }\n",
    "twice": "a: 3m\na: 4m\n",
    "nested": "a: { b: 3 }\n",
    "number": "3\n",
    "nothing": "",
    "empty list": "[]\n",
    "list of numbers": "- 3\n- 4\n",
    "no yaml": "a: [\n",
    "tab": "a:\t- 3\n",
    "date": "a: 2020-01-01\n",
    "null": "a:\n",
    "number as name": "3: 4m\n",
    "infinite": "a: .inf\n",
    "long": "a: 0.1000000000000000055\nb: 1e3\nc: 0x10\n",
}
_TRACES = {
    "plain.csv": "time,x,y\n0,1,2\n1,3,4\n2,5,6\n",
    "semicolons.csv": "time;x\n0;1,5\n1;2,5\n",
    "comment.csv": "# a trace\n# time, x\n0, 1\n1, 2\n",
    "units.csv": "time,x\ns,m\n0,1\n1,2\n",
    "stamps.csv": "time,x\n00:00:01.5,1\n01:02:03,2\n",
    "dates.csv": "time,x\n2020-01-01T00:00:00Z,1\n2020-01-01T00:00:01+01:00,2\n",
    "flags.csv": "time,x\n0,true\n1,False\n",
    "gaps.csv": "time,x\n0,\n1,2\n",
    "ragged.csv": "time,x\n0,1,2\n1,2\n",
    "trailing.csv": "time,x,\n0,1,\n1,2,\n",
    "words.csv": "time,x\n0,a\n",
    "twice.csv": "time,x,x\n0,1,2\n",
    "numbers.csv": "0,1\n1,2\n",
    "nothing.csv": "",
    "back.csv": "time,x\n1,1\n0,2\n",
    "drive.csv": "time,agent,x,speed\n0,ego,1,2\n0,lead,3,4\n1,ego,5,6\n1,lead,7,8\n",
    "columns.json": '{"time": [0, 1], "x": [2, 3]}',
    "records.json": '[{"time": 0, "x": 2}, {"time": 1, "x": 3}]',
    "signals.json": '{"positions": [0, 1], "signals": {"x": [2, 3]}}',
    "uneven.json": '{"time": [0, 1], "x": [2]}',
    "word.json": '{"time": [0, 1], "x": [2, "a"]}',
    "null.json": '{"time": [0, 1], "x": [2, null]}',
    "number.json": "3",
    "none.json": "{",
}


def file_lines() -> Iterator[str]:
    """Each file, and what was read or the message."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        yield from _each(folder, "road.csv", _ROADS, _road)
        yield from _each(folder, "poses.csv", _POSES, _poses)
        (folder / "map.png").write_bytes((SCENES / "sketch.png").read_bytes())
        yield from _each(folder, "map.yaml", _MAPS, _map)
        yield from _each(folder, "params.yaml", _PARAMS, _params)
        for name, text in _TRACES.items():
            yield from _each(folder, name, {"": text}, _trace)
        whole = (SCENES / "bend.png").read_bytes()
        for size in (0, 4, 20, 33, 60, 300, len(whole)):
            (folder / "a.png").write_bytes(whole[:size])
            yield from _said(folder, f"a.png of {size} bytes", lambda: _image(folder / "a.png"))


def _each(
    folder: Path, name: str, texts: Mapping[str, str], read: Callable[[Path], Any]
) -> Iterator[str]:
    for title, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
        yield from _said(folder, f"{name} {title}", lambda: read(folder / name))


def _said(folder: Path, title: str, read: Callable[[], Any]) -> Iterator[str]:
    try:
        found = str(read())
    except (DiagnosticError, GeometryError) as error:
        found = str(error)
    yield f"{title}: " + found.replace(str(folder), "DIR").replace("\n", " / ")


def _road(path: Path) -> str:
    names = {"x": "east", "y": "north"} if "east" in path.read_text(encoding="utf-8") else {}
    return _drawn(Csv(**names).read(path))


def _drawn(found: Curve | Road) -> str:
    curve = found if isinstance(found, Curve) else found.curve
    width = "" if isinstance(found, Curve) else array(found.width.at([0.0, 9.0, 60.0]).tolist())
    points = array(np.asarray(curve.points).ravel().tolist())
    return f"{type(found).__name__} {curve.length:.9g} {curve.closed} {points} {width}"


def _poses(path: Path) -> str:
    found = recording(str(path), "ego")
    at = [array(found.at(time).tolist()) for time in (0.0, 0.5, 1.7, 9.0)]
    return f"{array(found.time.tolist())} {array(found.pose.ravel().tolist())} {at}"


def _map(path: Path) -> str:
    found = [RosMap().read(path), RosMap(width=4.0, smallest=2.0).read(path)]
    return " then ".join(
        f"{len(one.network.edges)} roads {one.network.length:.9g} {array(one.network.bounds)}"
        for one in found
    )


def _params(path: Path) -> str:
    found = read_params(str(path))
    said = [{name: source.text for name, source in one.items()} for one in found.sets]
    return f"{found.is_list} {said}"


def _trace(path: Path) -> str:
    found = [str(stl.read_trace(path))]
    if path.name == "drive.csv":
        found.append(str(stl.read_trace(path, agent="lead")))
    return " then ".join(found)


def _image(path: Path) -> str:
    pixels = read_image(path)
    return array(pixels.astype(float).ravel().tolist(), pixels.shape)
