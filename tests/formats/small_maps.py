"""Small OpenDRIVE maps, written by hand."""

from __future__ import annotations

from collections.abc import Sequence

MARK = '<roadMark sOffset="0" type="broken"/>'


def lane(id: int, width: str | float = 3.5, type: str = "driving", inside: str = "") -> str:
    """A lane; `width` in meters, or elements, `inside` goes before it."""
    across = (
        width if isinstance(width, str) else f'<width sOffset="0" a="{width}" b="0" c="0" d="0"/>'
    )
    return f'<lane id="{id}" type="{type}">{inside}{across}{MARK}</lane>'


def linked(predecessor: int | None = None, successor: int | None = None) -> str:
    """The links of a lane."""
    found = "" if predecessor is None else f'<predecessor id="{predecessor}"/>'
    found += "" if successor is None else f'<successor id="{successor}"/>'
    return f"<link>{found}</link>"


def section(s: float, left: Sequence[str] = (), right: Sequence[str] = ()) -> str:
    """A lane section, lanes from the left to the right."""
    sides = "".join(
        f"<{side}>{''.join(lanes)}</{side}>"
        for side, lanes in (("left", left), ("right", right))
        if lanes
    )
    center = '<center><lane id="0" type="none"><roadMark sOffset="0" type="solid"/></lane></center>'
    return f'<laneSection s="{s}">{center}{sides}</laneSection>'


TWO_WAY = section(0, [lane(1)], [lane(-1)])


def piece(
    s: float, x: float, y: float, heading: float, length: float, shape: str = "<line/>"
) -> str:
    """A piece of a reference line."""
    return (
        f'<geometry s="{s}" x="{x!r}" y="{y!r}" hdg="{heading!r}" length="{length!r}">'
        f"{shape}</geometry>"
    )


def road(
    id: str | int,
    length: float,
    pieces: str,
    lanes: str = TWO_WAY,
    *,
    junction: int = -1,
    inside: str = "",
    name: str = "",
) -> str:
    """A road; `inside` are further elements."""
    return (
        f'<road id="{id}" name="{name}" length="{length!r}" junction="{junction}">{inside}'
        f"<planView>{pieces}</planView><lanes>{lanes}</lanes></road>"
    )


def link(**ends: str) -> str:
    """The links of a road: `predecessor="road 3 end"`, `successor="junction 9"`."""
    found = ""
    for tag, written in ends.items():
        kind, id, *contact = written.split()
        at = f' contactPoint="{contact[0]}"' if contact else ""
        found += f'<{tag} elementType="{kind}" elementId="{id}"{at}/>'
    return f"<link>{found}</link>"


def xodr(*elements: str, header: str = "") -> str:
    """A file."""
    head = f'<header revMajor="1" revMinor="6">{header}</header>'
    return (
        '<?xml version="1.0"?>\n<OpenDRIVE>\n' + "\n".join((head, *elements)) + "\n</OpenDRIVE>\n"
    )


def straight(id: str | int, x: float, y: float, length: float = 60.0, **options: str) -> str:
    """A road that runs east from (x, y)."""
    return road(id, length, piece(0, x, y, 0.0, length), **options)  # type: ignore[arg-type]


def crossing() -> str:
    """Roads 1 from the west and 2 to the east meet road 3 from the south in junction 100. Of the
    turns there is none from 2 to 3."""
    arms = [
        road(1, 40.0, piece(0, -50, 0, 0.0, 40.0), inside=link(successor="junction 100")),
        road(2, 40.0, piece(0, 10, 0, 0.0, 40.0), inside=link(predecessor="junction 100")),
        road(
            3,
            40.0,
            piece(0, 0, -50, 1.5707963267948966, 40.0),
            inside=link(successor="junction 100"),
        ),
    ]
    one = section(0, (), [lane(-1, inside=linked(-1, -1))])
    quarter = 15.707963267948966
    inner = [
        road(
            10,
            20.0,
            piece(0, -10, 0, 0.0, 20.0),
            one,
            junction=100,
            inside=link(predecessor="road 1 end", successor="road 2 start"),
        ),
        road(
            11,
            20.0,
            piece(0, 10, 0, 3.141592653589793, 20.0),
            section(0, (), [lane(-1, inside=linked(1, 1))]),
            junction=100,
            inside=link(predecessor="road 2 start", successor="road 1 end"),
        ),
        road(
            12,
            quarter,
            piece(0, -10, 0, 0.0, quarter, '<arc curvature="-0.1"/>'),
            section(0, (), [lane(-1, inside=linked(-1, 1))]),
            junction=100,
            inside=link(predecessor="road 1 end", successor="road 3 end"),
        ),
        road(
            13,
            quarter,
            piece(0, 0, -10, 1.5707963267948966, quarter, '<arc curvature="-0.1"/>'),
            one,
            junction=100,
            inside=link(predecessor="road 3 end", successor="road 2 start"),
        ),
    ]
    turns = [(1, 10, -1), (2, 11, 1), (1, 12, -1), (3, 13, -1)]
    junction = '<junction id="100" name="crossing">' + "".join(
        f'<connection id="{place}" incomingRoad="{incoming}" connectingRoad="{connecting}" '
        f'contactPoint="start"><laneLink from="{source}" to="-1"/></connection>'
        for place, (incoming, connecting, source) in enumerate(turns)
    )
    return xodr(*arms, *inner, junction + "</junction>")
