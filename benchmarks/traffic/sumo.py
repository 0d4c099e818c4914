"""The crossing in SUMO, if it is installed."""

from __future__ import annotations

import math
import os
import shutil
import subprocess
import tempfile
from pathlib import Path
from xml.etree import ElementTree

from .demand import ALL_RED, CAR, YELLOW, Demand

FROM = 400.0
"""Meters before the stop line at which cars come into SUMO."""
ARMS = ("north", "east", "south", "west")
"""Clockwise: who comes from one and turns left leaves by the next."""
LEAVES_BY = {"left": 1, "straight": 2, "right": 3}


def sumo_program(name: str) -> str | None:
    """The path of `sumo` or `netconvert`."""
    home = os.environ.get("SUMO_HOME")
    return shutil.which(name) or (shutil.which(name, path=f"{home}/bin") if home else None)


def sumo_throughput(demand: Demand) -> int | None:
    """Cars that cross a stop line in the time of the demand; None without SUMO."""
    sumo, netconvert = sumo_program("sumo"), sumo_program("netconvert")
    if sumo is None or netconvert is None:
        return None
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        _write_network(folder, demand)
        signals = f"--tls.green.time={demand.green} --tls.yellow.time={YELLOW}"
        signals += f" --tls.allred.time={ALL_RED} --tls.left-green.time=0 --tls.layout=opposites"
        _run(folder, netconvert, "-n=n.xml", "-e=e.xml", "-o=net.xml", "--no-turnarounds=true",
             *signals.split())  # fmt: skip
        _write_cars(folder, demand)
        _run(folder, sumo, "-n=net.xml", "-r=cars.xml", f"--end={demand.duration}",
             "--step-length=0.1", "--time-to-teleport=-1", "--vehroute-output=out.xml",
             "--vehroute-output.exit-times=true", "--vehroute-output.write-unfinished=true",
             "--no-step-log=true", f"--seed={demand.seed}")  # fmt: skip
        found = ElementTree.parse(folder / "out.xml").getroot()
        routes = [one.find("route") for one in found.iter("vehicle")]
        return sum(1 for one in routes if one is not None and _has_left(one))


def _has_left(route: ElementTree.Element) -> bool:
    """Whether a car has left the first edge of its route."""
    return float(route.get("exitTimes", "-1").split()[0]) >= 0.0


def _run(folder: Path, *words: str) -> None:
    subprocess.run(words, cwd=folder, check=True, capture_output=True)


def _write_network(folder: Path, demand: Demand) -> None:
    center = '<node id="c" x="0" y="0" type="traffic_light"/>'
    nodes, edges = [center], []
    for number, name in enumerate(ARMS):
        angle = math.pi / 2 * (1 - number)
        x, y = (2.0 * FROM * trig(angle) for trig in (math.cos, math.sin))
        nodes.append(f'<node id="{name}" x="{x:.2f}" y="{y:.2f}"/>')
        lanes = f'numLanes="{demand.lanes // 2}" speed="{demand.speed}"'
        edges.append(f'<edge id="{name}_in" from="{name}" to="c" {lanes}/>')
        edges.append(f'<edge id="{name}_out" from="c" to="{name}" {lanes}/>')
    (folder / "n.xml").write_text(f"<nodes>{''.join(nodes)}</nodes>")
    (folder / "e.xml").write_text(f"<edges>{''.join(edges)}</edges>")


def _write_cars(folder: Path, demand: Demand) -> None:
    net = ElementTree.parse(folder / "net.xml").getroot()
    length = max(
        float(one.get("length", "0")) for one in net.iter("lane")
        if str(one.get("id")).startswith("north_in")
    )  # fmt: skip
    rows = []
    for number, cars in enumerate(demand.arms):
        for car in cars:
            at = max(car.distance, 0.0)
            depart = max(0.0, (at - FROM) / demand.speed)
            begin = max(length - min(at, FROM), CAR)
            leaves = ARMS[(number + LEAVES_BY[car.turn]) % 4]
            rows.append((depart, begin, f"{ARMS[number]}_in {leaves}_out"))
    rows.sort()
    text = "".join(
        f'<vehicle id="{number}" type="car" depart="{depart:.2f}" departPos="{begin:.2f}" '
        f'departLane="best" departSpeed="max"><route edges="{edges}"/></vehicle>'
        for number, (depart, begin, edges) in enumerate(rows)
    )
    kind = f'<vType id="car" length="{CAR}" minGap="2.0"/>'
    (folder / "cars.xml").write_text(f"<routes>{kind}{text}</routes>")
