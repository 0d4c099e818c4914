"""Scene files of every statement, from a seed: roads, networks, things, formulas, the world."""

# ruff: noqa: E501 (a statement, a line)

from __future__ import annotations

import random

_MAPS = (
    ("..#..\n..#..\n#####\n..#..", 12), ("#######\n..#..#.\n..#..#.\n..####.", 14),
    (".####.\n.#..#.\n##..##\n.#..#.\n.####.", 16), ("#..\n###\n..#\n..#", 18),
)  # fmt: skip


class RandomScene:
    """Draws the text of a scene, which may be refused for what it asks."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(f"scene {seed}")
        self.roads: list[str] = []
        self.params: list[str] = []
        self.things: list[str] = []
        self.network = ""

    def text(self) -> str:
        """All statements, in an order that names things before they are used."""
        draw = self.random
        parts = [self._world(), *(self._param(i) for i in range(draw.randint(1, 4)))]
        parts += [self._road(i) for i in range(draw.randint(1, 2))]
        parts += [self._derived(i) for i in range(draw.randint(0, 2))]
        if draw.random() < 0.4:
            parts.append(self._town())
        parts += [self._thing(i) for i in range(draw.randint(2, 5))]
        parts += [self._constraint(i) for i in range(draw.randint(1, 4))]
        parts.append("sample with random { attempts: 60 }")
        return "\n".join(part for part in parts if part)

    def _number(self, low: float, high: float, unit: str) -> str:
        """A value between two: a number, a range, a choice, a param or a formula of these."""
        draw = self.random
        a, b = sorted(round(draw.uniform(low, high), 1) for _ in range(2))
        kind = draw.randrange(8)
        if kind < 3 or a == b:
            return f"{b}{unit}"
        if kind == 3:
            return f"{a}{unit}..{b}{unit}"
        if kind == 4:
            return f"choice({a}{unit}, {b}{unit}, weights: [1, {draw.randint(1, 3)}])"
        if kind == 5:
            return f"normal({(a + b) / 2:.2f}{unit}, {(b - a) / 6:.3f}{unit}, within: [{a}{unit}, {b}{unit}])"
        if kind == 6 and self.params and unit == "m":
            name = draw.choice(self.params)
            return f"min(max({name}, {a}{unit}), {b}{unit})"
        return f"({a}{unit} + {b}{unit}) / 2"

    def _world(self) -> str:
        draw = self.random
        options = {
            "friction": self._number(0.4, 0.9, ""),
            "weather": draw.choice(("clear", "rain", "fog", "choice(snow, overcast)")),
            "time_of_day": draw.choice(("6h", "7.5h..19h", "90min")),
            "visibility": self._number(50.0, 400.0, "m"),
            "traffic": draw.choice(("left", "right")),
        }
        chosen = draw.sample(sorted(options), draw.randint(0, 4))
        return "world { " + ", ".join(f"{k}: {options[k]}" for k in chosen) + " }" if chosen else ""

    def _param(self, number: int) -> str:
        draw, name = self.random, f"p{number}"
        value = self._number(2.0, 9.0, "m")
        if self.params and draw.random() < 0.5:
            other = draw.choice(self.params)
            value = draw.choice(
                (f"2 * {other} - 1m", f"abs({other} - 5m) + 1m", f"({other}^2)^0.5")
            )
        self.params.append(name)
        return f"param {name} = {value}"

    def _lanes(self) -> str:
        draw = self.random
        width = self._number(2.8, 3.6, "m")
        return draw.choice((
            "lanes: 2", "lanes: 3, sidewalks: 1.8m", f"width: {self._number(6.0, 9.0, 'm')}",
            "lanes: integer(1, 4)", "lanes: 2, oneway: true", "width: 8m, lanes: 2, center_marking: double",
            f"right: [drive({width}), bike(1.5m)], left: [drive(3m), parking, sidewalk(2m)]",
            f"right: [drive, drive({width}, marking: solid), shoulder], left: [grass(1m), drive]",
            f"right: [bus({width}), drive(3m, speed_limit: 30km/h)], left: [drive, choice(bike, median)]",
        ))  # fmt: skip

    def _road(self, number: int) -> str:
        draw, name = self.random, f"r{number}"
        y = 400 * number
        if draw.random() < 0.5:
            pieces = ["straight(40m)"]
            for _ in range(draw.randint(1, 3)):
                radius = self._number(25.0, 70.0, "m")
                pieces.append(f"arc({radius}, {draw.choice((-1, 1)) * draw.randint(15, 60)}deg)")
                pieces.append(
                    f"clothoid({self._number(9.0, 25.0, 'm')}, to: {draw.randint(-2, 2)}/90m)"
                )
            source = f"segments {{ pieces: [{', '.join(pieces)}], start: (0m, {y}m), heading: {draw.randint(0, 50)}deg }}"
        else:
            points = [
                (0, y),
                (60, y + draw.randint(-9, 9)),
                (120, y + draw.randint(-30, 30)),
                (190, y),
            ]
            shown = ", ".join(f"({x}m, {v}m)" for x, v in points)
            curve = draw.choice(("", ", curve: polyline, radius: 15m"))
            source = f"waypoints {{ points: [{shown}]{curve} }}"
        self.roads.append(name)
        limit = draw.choice(
            ("", ", speed_limit: 50km/h", f", station_spacing: {draw.choice((0.5, 2))}m")
        )
        return f"road {name} {{ draw with {source}, {self._lanes()}{limit} }}"

    def _perturbed(self) -> str:
        draw = self.random
        kind = draw.choice((
            f"sine {{ amplitude: {self._number(0.2, 2.0, 'm')}, wavelength: 70m, phase: {draw.randint(0, 90)}deg",
            f"bump {{ at: {self._number(30.0, 90.0, 'm')}, height: {self._number(-2.0, 2.0, 'm')}, length: 40m",
            f"shift {{ at: 40m, offset: {self._number(-2.0, 2.0, 'm')}, length: 30m",
            "harmonics { amplitude: 0.5m..1.5m, modes: 3", "random_walk { amplitude: 1m, correlation: 30m",
        ))  # fmt: skip
        window = draw.choice(("", ", over: [20m, 110m], taper: 15m", ", over: [30m, 90m]"))
        return f"perturb with {kind}{window} }}"

    def _derived(self, number: int) -> str:
        draw, name, base = self.random, f"d{number}", self.random.choice(self.roads)
        parts = [self._perturbed() for _ in range(draw.randint(1, 2))]
        if draw.random() < 0.3:
            parts.append(draw.choice(("lanes: 2", "width: 7m", "speed_limit: 30km/h")))
        if draw.random() < 0.2:
            parts = [f"then: {draw.choice(self.roads)}", "taper: 20m"]
        self.roads.append(name)
        return f"road {name} from {base} {{\n  " + "\n  ".join(parts) + "\n}"

    def _town(self) -> str:
        draw = self.random
        rows, scale = draw.choice(_MAPS)
        control = draw.choice(("", "\n  control with stop", "\n  control with signals { green: 9s }",
                               "\n  control with all_way_stop"))  # fmt: skip
        lanes = draw.choice((
            "lanes: 2", "lanes: 4, sidewalks: 1.5m", "right: [drive(3m), bike], left: [drive(3m)]",
            "lanes: 3", "lanes: integer(2, 3)", "right: [drive, parking], left: [drive, sidewalk]",
        ))  # fmt: skip
        self.network = "town"
        selected = draw.choice(("longest", "road(1)", "any"))
        return (
            f'image plan from """\n{rows}\n""" {{ scale: {scale}m/px, legend: {{ "#": road }} }}\n'
            f"network town from plan {{\n  {lanes}{control}\n}}\n"
            f"road picked from town {{ select: {selected} }}"
        )

    def _thing(self, number: int) -> str:
        draw, name = self.random, f"t{number}"
        on = draw.choice([*self.roads, self.network or self.roads[0]])
        in_town = on == self.network and bool(on)
        place = draw.choice(
            ("random",) if in_town else ("random", "10%..80%", self._number(8.0, 60.0, "m"))
        )
        by = [thing for thing in self.things if thing.endswith(f" {on}")]
        if by and draw.random() < 0.4:
            other = draw.choice(by).split()[0]
            place = draw.choice((f"ahead_of({other}, {self._number(2.0, 9.0, 'm')})", f"behind({other}, 6m)",
                                 f"beside({other}, {draw.choice(('left', 'right'))})"))  # fmt: skip
        options = ["overlap: true"]
        if place == "random" and draw.random() < 0.6:
            options.append(f"count: {draw.choice(('2', '3', 'integer(1, 3)'))}, apart: 2m")
        beside = draw.choice(("", "side: right, offset: 0.5m..2m", "lane: outer", "facing: back",
                              "lane: -1, offset: -0.3m", "offset: 0.2m"))  # fmt: skip
        options += [beside] if beside and "(" not in place else []
        if draw.random() < 0.3:
            kind = draw.choice(("tree", "cone", "parked_car", "choice(box, rock)"))
            text = f"object {name} is {kind} on {on} at {place}"
        else:
            kind = draw.choice(("car", "van", "choice(car, truck, weights: [3, 1])", "bicycle"))
            text = f"agent {name} is {kind} on {on} at {place}"
            options.append("drive with " + draw.choice((
                "lane_follow { speed: 6m/s..9m/s }", "car_follow", "traffic", "stanley { speed: 8m/s }",
            )))  # fmt: skip
            if "count" not in "".join(options):
                self.things.append(f"{name} {on}")
        return f"{text} {{ {', '.join(options)} }}"

    def _constraint(self, number: int) -> str:
        draw, road = self.random, self.random.choice(self.roads)
        word = draw.choice(("require", "expect", "expect"))
        signal = draw.choice((
            (f"curvature({road})", "0.1/m"), (f"abs(heading({road}))", "200deg"), (f"width({road})", "12m"),
            (f"-clearance({road})", "3m"), (f"margin({road}, (-50m, -99m), (400m, 900m))", "900m"),
        ))  # fmt: skip
        operator = draw.choice(
            ("always", "eventually", "always[10m, 60m]", "eventually[0m, 40m] always[0m, 9m]")
        )
        formula = f"{operator} ({signal[0]} < {signal[1]})"
        names = [thing.split()[0] for thing in self.things]
        if names and draw.random() < 0.4:
            one = draw.choice(names)
            formula = draw.choice(
                (f"{one}.start < 150m", f"{one}.start^2 > 9m^2 or {one}.start_lane != 0")
            )
        if len(names) > 1 and draw.random() < 0.3:
            formula = (
                f"gap({names[0]}, {names[1]}) >= 0m and distance({names[0]}, {names[1]}) < 2km"
            )
        if draw.random() < 0.3:
            formula = f"({formula}) {draw.choice(('and', 'or', 'implies'))} length({road}) > 50m"
        return f"{word} c{number}: {formula}"
