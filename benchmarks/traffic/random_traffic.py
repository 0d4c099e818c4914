"""Random traffic scenes, as scene files: crossings, three arms, offset arms, towns; all rules."""

from __future__ import annotations

from random import Random

CONTROLS = (
    "",
    "control with signals {{ green: {green}s, yellow: {yellow}s, all_red: 2s, offset: {offset}s }}",
    "control with yield",
    "control with stop",
    "control with all_way_stop",
)


def scene_text(seed: int, left: bool = False) -> str:
    """A scene file; the same for one seed, but for the side on which traffic drives."""
    draw = Random(seed)
    plan = draw.choice((_crossing, _three_arms, _town, _offset_arms))(draw)
    lanes = draw.choice((2, 2, 2, 4))
    control = draw.choice(CONTROLS).format(
        green=draw.randint(6, 20), yellow=draw.choice((2, 3, 4)), offset=draw.randint(0, 30)
    )
    limit = draw.choice((30, 50, 50, 60))
    count = draw.randint(8, 24)
    side = "traffic: left" if left else ""
    return f"""
image plan from \"\"\"
{plan}
\"\"\" {{ scale: {4 * lanes if lanes == 2 else 14}m/px }}
network town from plan {{
  lanes: {lanes}, speed_limit: {limit}km/h
  {control}
}}
agent cars is choice(car, van, weights: [4, 1]) on town at random {{
  count: {count}, route_length: 1500m
  drive with traffic {{ speed_factor: 0.8..1.2, aggression: 0..1, headway: 0.8s..1.6s }}
}}
world {{ {side} }}
"""


def _crossing(draw: Random) -> str:
    arms = [draw.randint(10, 18) for _ in range(4)]
    width, height = arms[0] + arms[1] + 1, arms[2] + arms[3] + 1
    rows = [["."] * width for _ in range(height)]
    rows[arms[2]] = ["#"] * width
    for row in rows:
        row[arms[0]] = "#"
    return _text(rows)


def _three_arms(draw: Random) -> str:
    left, right, down = (draw.randint(10, 18) for _ in range(3))
    rows = [["#"] * (left + right + 1)]
    rows += [["."] * left + ["#"] + ["."] * right for _ in range(down)]
    return _text(rows)


def _offset_arms(draw: Random) -> str:
    """Two roads that meet a third from its two sides, some way apart."""
    first, apart, last = draw.randint(8, 14), draw.randint(6, 10), draw.randint(8, 14)
    width = first + apart + last
    up = [["."] * width for _ in range(draw.randint(8, 14))]
    down = [["."] * width for _ in range(draw.randint(8, 14))]
    for row in up:
        row[first] = "#"
    for row in down:
        row[first + apart] = "#"
    return _text([*up, ["#"] * width, *down])


def _town(draw: Random) -> str:
    """Streets around blocks."""
    columns = [0]
    rows = [0]
    for lines in (columns, rows):
        for _ in range(draw.randint(2, 3)):
            lines.append(lines[-1] + draw.randint(9, 13))
    text = [
        ["#" if x in columns or y in rows else "." for x in range(columns[-1] + 1)]
        for y in range(rows[-1] + 1)
    ]
    return _text(text)


def _text(rows: list[list[str]]) -> str:
    return "\n".join("".join(row) for row in rows)
