"""SVG elements as text: escaped, with short numbers, the same bytes for the same drawing."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape, quoteattr

from .hundredths import HIGHEST, LOWEST, joined

if TYPE_CHECKING:
    from roadlang.geometry import Floats


def number(value: float) -> str:
    """At most two decimals, no trailing zeros, no `-0`."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def element(tag: str, *children: str, **attributes: object) -> str:
    """`stroke_width=2` becomes `stroke-width="2"`; attributes that are None are left out."""
    parts = [f"<{tag}"]
    for name, value in attributes.items():
        if isinstance(value, float):
            parts.append(f'{_prefix(name)}"{number(value)}"')
        elif value is not None:
            parts.append(_prefix(name) + _quoted(str(value)))
    parts += (">", *children, f"</{tag}>") if children else ("/>",)
    return "".join(parts)


@lru_cache(maxsize=1024)
def _prefix(name: str) -> str:
    return f" {name.rstrip('_').replace('_', '-')}="


def _quoted(value: str) -> str:
    return _word(value) if len(value) < _LONG else _attribute(value)


def _attribute(value: str) -> str:
    return quoteattr(value) if any(map(value.__contains__, _SPECIAL)) else f'"{value}"'


_word = lru_cache(maxsize=4096)(_attribute)
"""Colors and the like, which most elements have."""
_LONG = 24


def group(children: Iterable[str], **attributes: object) -> str:
    """A `<g>` with a child on each line; nothing at all without children."""
    lines = [child for child in children if child]
    return element("g", "\n", "\n".join(lines), "\n", **attributes) if lines else ""


def text(content: str, x: float, y: float, **attributes: object) -> str:
    """A text element; control characters are left out."""
    return element("text", escape(_printable(content)), x=x, y=y, **attributes)


def title(content: str) -> str:
    """What a browser shows when the mouse rests on the parent."""
    return f"<title>{escape(_printable(content))}</title>"


def path_data(points: Floats, closed: bool = False) -> str:
    """The `d` of a polyline through (n, 2) points, the numbers as `number` writes them."""
    return "M" + numbers_text(points, " L")[:-1] + ("Z" if closed else "")


def numbers_text(values: Floats, separators: str) -> str:
    """(n, m) numbers as `number` writes them, each followed by the separator of its column."""
    import numpy as np

    exact = values * 100.0
    near = np.rint(exact)
    if not ((near >= LOWEST) & (near <= HIGHEST)).all():
        lines = zip(*[map(number, column) for column in values.T.tolist()], strict=True)
        return "".join(
            [text + end for line in lines for text, end in zip(line, separators, strict=True)]
        )
    # Halves that are not exact are rounded as they are written.
    for index in np.flatnonzero(np.abs(np.abs(exact - near) - 0.5) < _HALF).tolist():
        near.flat[index] = round(100.0 * float(number(values.flat[index])))
    return joined(near.astype(np.int64), separators)


def rho(value: float) -> str:
    """A robustness as a paper prints it."""
    shown = f"{value:.3g}".replace("-", "\N{MINUS SIGN}")
    return f"\N{GREEK SMALL LETTER RHO} = {shown}"


def _printable(content: str) -> str:
    # XML 1.0 has no way to write control characters.
    if content.isprintable():
        return content
    return "".join(char for char in content if char.isprintable())


_SPECIAL = '&<>"\n\r\t'
_HALF = 1e-6
