"""Documents as lines that a person can compare: one for each member, one for each array of numbers.

An array is not written out: its line has its shape, its first and last number, the mean of its
numbers, the mean of their sizes, and their mean under weights that differ from place to place,
so that a change of any of them changes the line.
"""

from __future__ import annotations

import json
import math
import re
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Any

_NUMBER = re.compile(r"(?<![\w.#])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w#])")
_DIGEST = re.compile(r"(?<![\w.])(?=[0-9]*[a-f])[0-9a-f]{16,64}\b")
_SHORT = 4


def number(value: float) -> str:
    """Ten digits, and no sign of a zero."""
    if not math.isfinite(value):
        return str(value)
    return f"{value:.10g}" if value else "0"


def array(values: Sequence[float], shape: tuple[int, ...] | None = None) -> str:
    """The line of an array of numbers, those without a bound left out of its means."""
    if len(values) <= _SHORT:
        return " ".join(number(v) for v in values)
    finite = [v if math.isfinite(v) else 0.0 for v in values]
    weighted = sum(v * math.cos(0.7 * (i + 1) ** 1.1) for i, v in enumerate(finite))
    means = (sum(finite), sum(abs(v) for v in finite), weighted)
    size = "x".join(str(n) for n in shape or (len(values),))
    ends = f"{number(values[0])} .. {number(values[-1])}"
    endless = len(values) - sum(math.isfinite(v) for v in values)
    more = f" endless {endless}" if endless else ""
    return f"[{size}] {ends} means " + " ".join(number(m / len(finite)) for m in means) + more


def _numbers(value: Any) -> tuple[list[float], tuple[int, ...]] | None:
    """The numbers of an array with its shape; nothing if it is not one."""
    if isinstance(value, bool) or value is None:
        return None
    if isinstance(value, int | float):
        return [float(value)], ()
    if not isinstance(value, list | tuple) or not value:
        return None
    rows = [_numbers(item) for item in value]
    if any(row is None for row in rows):
        return None
    found = [row for row in rows if row is not None]
    if len({shape for _, shape in found}) > 1:
        return None
    return [v for row, _ in found for v in row], (len(found), *found[0][1])


def plain(text: str) -> str:
    """A text without what differs from machine to machine: digests."""
    return _DIGEST.sub("(digest)", text)


def of_json(value: Any, path: str = "") -> Iterator[str]:
    """A line for each member of a JSON document; members of objects in a list share one."""
    yield from _column([value], path)


def _column(values: list[Any], path: str) -> Iterator[str]:
    """The lines of what stands at one path of several documents."""
    present = [value for value in values if value is not None]
    if 0 < len(present) < len(values) and not isinstance(present[0], str | bool):
        where = runs(["-" if value is None else "+" for value in values])
        yield from _column(present, f"{path}({' '.join(where)})")
        return
    found = _numbers(values[0] if len(values) == 1 else values)
    if found is not None:
        yield f"{path}: {array(*found)}"
    elif all(isinstance(v, dict) and v for v in values):
        for key in dict.fromkeys(key for value in values for key in value):
            having = [value[key] for value in values if key in value]
            some = f"({len(having)} of {len(values)})" if len(having) < len(values) else ""
            yield from _column(having, f"{path}.{key}{some}" if path else str(key))
    elif all(isinstance(v, list) for v in values) and any(values):
        flat = [item for value in values for item in value]
        sizes = " ".join(runs([str(len(value)) for value in values]))
        yield from _column(flat, f"{path}[{sizes}]")
    else:
        yield f"{path}: " + " ".join(runs([_scalar(value) for value in values]))


def _scalar(value: Any) -> str:
    if isinstance(value, float):
        return number(value)
    return plain(json.dumps(value, ensure_ascii=False))


def runs(words: Sequence[str]) -> list[str]:
    """Words, those that are repeated with how often."""
    runs = [(word, len(list(group))) for word, group in groupby(words)]
    return [word + (f" *{times}" if times > 1 else "") for word, times in runs]


def of_text(text: str) -> Iterator[str]:
    """The lines of a text."""
    return (plain(line) for line in text.splitlines())


def _element(element: ET.Element) -> tuple[str, list[float]]:
    """What an element says beside its numbers, and those."""
    parts, values = [element.tag.split("}")[-1]], list[float]()
    for key, value in element.attrib.items():
        name = key.split("}")[-1]
        if name == "d":
            commands = Counter(re.findall(r"[A-Za-z]", value))
            parts.append("d=" + "".join(f"{c}{n}" for c, n in commands.items()))
            values += [float(found) for found in re.findall(r"-?[\d.]+", value)]
            continue
        values += [float(found) for found in _NUMBER.findall(value)]
        words = _NUMBER.sub("#", value).split()
        parts.append(f"{name}={' '.join(runs(words))}")
    if element.text and element.text.strip():
        parts.append(repr(plain(element.text.strip())))
    return " ".join(parts), values


def of_svg(text: str) -> Iterator[str]:
    """A line for each element of a figure; those in a row that look the same share one."""

    def lines(element: ET.Element, depth: int) -> Iterator[str]:
        for (looks, leaf), group in groupby(
            element, key=lambda child: (_element(child)[0], not len(child))
        ):
            children = list(group)
            if leaf:
                values = [v for child in children for v in _element(child)[1]]
                times = f"{len(children)} x " if len(children) > 1 else ""
                yield "  " * depth + f"{times}{looks}" + (f": {array(values)}" if values else "")
                continue
            for child in children:
                values = _element(child)[1]
                yield "  " * depth + looks + (f": {array(values)}" if values else "")
                yield from lines(child, depth + 1)

    root = ET.fromstring(text)
    looks, values = _element(root)
    yield f"{looks}: {array(values)}"
    yield from lines(root, 1)
