"""Scene files of networks, from a seed: streets, who goes first, and things placed in every way."""

# ruff: noqa: E501 (a statement, a line)

from __future__ import annotations

import random

_MAPS = (
    ("...#...\n...#...\n#######\n...#...\n...#...", 12),
    ("#########\n..#...#..\n..#...#..\n..#####..", 14),
    (".#######.\n.#..#..#.\n##..#..##\n.#..#..#.\n.#######.", 15),
    ("#....#\n.#..#.\n..##..\n..##..\n.#..#.\n#....#", 11),
    ("....#....\n#########\n....#....\n....#####\n....#....", 13),
    ("####.\n...#.\n.#####\n...#..", 16),
)


class RandomTown:
    """Draws the text of a town, which may be refused for what it asks."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(f"town {seed}")
        rows, self.scale = self.random.choice(_MAPS)
        self.rows = rows.split("\n")
        self.names: list[str] = []
        self.network = "town"
        self.lanes = list[str]()

    def text(self) -> str:
        """All statements."""
        draw = self.random
        side = draw.choice(("", "world { traffic: left }\n"))
        body = "\n".join(self.rows)
        image = f'image plan from """\n{body}\n""" {{ scale: {self.scale}m/px, legend: {{ "#": road }} }}'
        parts = [f"{side}{image}", self._town(), *self._derived(), *self._roads()]
        parts += [self._thing(number) for number in range(draw.randint(2, 4))]
        parts += [self._constraint(number) for number in range(draw.randint(1, 2))]
        return "\n".join([*parts, "sample with random { attempts: 8 }"])

    def _town(self) -> str:
        draw = self.random
        lanes = draw.choice((
            "lanes: 2", "lanes: 2, sidewalks: 1.5m", "lanes: 4, center_marking: double", "lanes: 3",
            "right: [drive(3m), bike(1.4m), sidewalk(1.5m)], left: [drive(3m), parking(2m)]",
            "right: [drive, drive(2.9m)], left: [bus(3.2m)]", "lanes: 2, oneway: true",
            "right: [drive(3m), grass(1m), drive(3m)], left: [drive(3m), sidewalk]",
        ))  # fmt: skip
        self.lanes = [f"lane: {kind}" for kind in ("bike", "bus") if f"{kind}(" in lanes]
        limit = draw.choice(("", ", speed_limit: 30km/h", ", station_spacing: 2m"))
        near = f"near: [{self._point()}, {self._point()}]"
        controls = [
            draw.choice(
                (
                    "yield",
                    "stop",
                    "all_way_stop",
                    "right_first",
                    "signals { green: 6s }",
                    f"yield {{ {near} }}",
                    f"signals {{ {near}, yellow: 1s, offset: 3s }}",
                    "stop { junctions: [1] }",
                    "yield { junctions: [1], roads: [1] }",
                    "stop { roads: [1] }",
                    "all_way_stop { junctions: [1] }",
                    "signals { green: 4s..9s, all_red: 0s }",
                )
            )
            for _ in range(draw.randint(0, 2))
        ]
        moved = (
            f", moved_at: [{self._point()}], moved_by: [(2m, -3m)]" if draw.random() < 0.2 else ""
        )
        lines = [f"{lanes}{limit}{moved}", *(f"control with {control}" for control in controls)]
        return "network town from plan {\n  " + "\n  ".join(lines) + "\n}"

    def _derived(self) -> list[str]:
        draw = self.random
        if draw.random() < 0.6:
            return []
        self.network = "bent"
        which = draw.choice(("", ", roads: [1, 2]", ", over: [5m, 30m], taper: 4m"))
        what = draw.choice((
            f"sine {{ amplitude: 0.4m..1.2m, wavelength: 40m{which} }}",
            f"harmonics {{ amplitude: 0.8m, modes: 2{which} }}",
            "shift { at: 20m, offset: 1m, length: 15m }", f"random_walk {{ amplitude: 0.6m, correlation: 20m{which} }}",
        ))  # fmt: skip
        more = draw.choice(("", "\n  lanes: 2", "\n  control with yield"))
        return [f"network bent from town {{\n  perturb with {what}{more}\n}}"]

    def _roads(self) -> list[str]:
        draw = self.random
        select = draw.choice(
            ("longest", "any", "road(2)", f"route({self._point()}, {self._point()})", "road(77)")
        )
        more = draw.choice(("", ", width: 7m", ", lanes: 2", ", speed_limit: 40km/h"))
        return [f"road picked from {self.network} {{ select: {select}{more} }}"] * draw.randint(
            0, 1
        )

    def _point(self) -> str:
        """Meters, somewhere on a road of the picture, or a bit beside it."""
        draw = self.random
        cells = [
            (x, y) for y, row in enumerate(self.rows) for x, sign in enumerate(row) if sign == "#"
        ]
        x, y = draw.choice(cells)
        height = len(self.rows)
        dx, dy = (draw.uniform(-0.4, 0.4) for _ in range(2))
        return f"({(x + 0.5 + dx) * self.scale:.1f}m, {(height - y - 0.5 + dy) * self.scale:.1f}m)"

    def _place(self, others: list[str]) -> str:
        draw = self.random
        places = ["random", "random", self._point(), self._point()]
        places += ["junction(1)", f"junction({draw.choice((1, 1, 2, 4))}, before: 6m)"]
        if others and draw.random() < 0.5:
            other = draw.choice(others)
            return draw.choice((
                f"ahead_of({other}, {draw.randint(2, 30)}m)", f"behind({other}, {draw.randint(2, 20)}m)",
                f"beside({other}, left)", f"beside({other}, right)",
            ))  # fmt: skip
        return draw.choice(places)

    def _thing(self, number: int) -> str:
        draw, name = self.random, f"t{number}"
        is_agent = draw.random() < 0.75
        kind = draw.choice(
            ("car", "van", "bus", "bicycle", "pedestrian", "choice(car, truck)")
            if is_agent
            else ("cone", "parked_car", "tree", "barrier", "sign")
        )
        options = [draw.choice((
            "lane: outer", "lane: -1", *self.lanes, "side: right, offset: 0.5m..1m",
            "side: left, offset: 1m", "facing: back", "facing: forward", "offset: 0.3m", "lane: none", *("",) * 8,
        ))]  # fmt: skip
        if draw.random() < 0.35:
            spacing = draw.choice(("", ", spacing: 7m", ", spacing: -9m", ", spacing: 8m..11m"))
            options.append(f"count: {draw.choice(('2', '3', 'integer(1, 3)'))}{spacing}")
        place = f" at {self._place(self.names)}"
        if is_agent:
            if kind != "pedestrian" and draw.random() < 0.5:
                via = [self._point() for _ in range(draw.randint(1, 2))]
                route = draw.choice(
                    (f"[{self._point()}, {', '.join(via)}]", "random", f"[{via[0]}]")
                )
                place = "" if draw.random() < 0.5 and route != "random" else place
                place = place or ("" if "[" in route else " at random")
                length = ", route_length: 120m" if route == "random" and draw.random() < 0.5 else ""
                if not place and "," not in route[8:]:
                    place = " at random"
                options = [""] if any(word in options[0] for word in ("side", "none")) else options
                options.append(f"route: {route}{length}")
            drive = draw.choice((
                "traffic", "traffic { aggression: 0.8 }", "lane_follow { speed: 7m/s }", "car_follow", "stanley",
                "traffic { speed_factor: 0.7..1.3 }",
            ))  # fmt: skip
            drive = draw.choice(("walk", "crossing")) if kind == "pedestrian" else drive
            options.append(f"drive with {drive}")
        options.append(draw.choice(("overlap: true", "overlap: true", "apart: 0.2m")))
        self.names.append(name)
        block = ", ".join(option for option in options if option)
        word = "agent" if is_agent else "object"
        return f"{word} {name} is {kind} on {self.network}{place} {{ {block} }}"

    def _constraint(self, number: int) -> str:
        draw, net = self.random, self.network
        one, other = draw.sample(self.names, 2)
        formula = draw.choice((
            f"always (curvature({net}) < 0.3/m)", f"always (clearance({net}) > -5m)",
            f"{one}.start_lane != 0", f"gap({one}, {other}) > 3m", f"distance({one}, {other}) < 90m",
        ))  # fmt: skip
        return f"{draw.choice(('require', 'expect', 'expect', 'expect'))} c{number}: {formula}"
