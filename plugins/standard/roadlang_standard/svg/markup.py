"""SVG elements as text: escaped, with short numbers, the same bytes for the same drawing."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape, quoteattr

if TYPE_CHECKING:
    from roadlang.geometry import Floats


def number(value: float) -> str:
    """At most two decimals, no trailing zeros, no `-0`."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def element(tag: str, *children: str, **attributes: object) -> str:
    """`stroke_width=2` becomes `stroke-width="2"`; attributes that are None are left out."""
    shown = "".join(
        [
            f'{_prefix(name)}"{number(value)}"'
            if isinstance(value, float)
            else _prefix(name) + _quoted(str(value))
            for name, value in attributes.items()
            if value is not None
        ]
    )
    if not children:
        return f"<{tag}{shown}/>"
    return f"<{tag}{shown}>{''.join(children)}</{tag}>"


@lru_cache(maxsize=1024)
def _prefix(name: str) -> str:
    return f" {name.rstrip('_').replace('_', '-')}="


def _quoted(value: str) -> str:
    return f'"{value}"' if _PLAIN(value) else quoteattr(value)


def group(children: Iterable[str], **attributes: object) -> str:
    """A `<g>` with a child on each line; nothing at all without children."""
    lines = [child for child in children if child]
    return element("g", "\n", "\n".join(lines), "\n", **attributes) if lines else ""


def text(content: str, x: float, y: float, **attributes: object) -> str:
    """A text element; control characters are left out."""
    return element("text", escape(_printable(content)), x=x, y=y, **attributes)


def title(content: str) -> str:
    """What a browser shows when the mouse rests on the parent."""
    return element("title", escape(_printable(content)))


def path_data(points: Floats, closed: bool = False) -> str:
    """The `d` of a polyline through (n, 2) points, the numbers as `number` writes them."""
    return "M" + _joined(points) + ("Z" if closed else "")


def _joined(points: Floats) -> str:
    import numpy as np

    hundredths = points * 100.0
    near = np.rint(hundredths)
    # Halves that are not exact, and numbers without hundredths, are rounded as they are written.
    unsure = np.abs(np.abs(hundredths - near) - 0.5) < _HALF
    if not (np.abs(near) < _GREATEST).all() or unsure.any():
        return "L".join([f"{number(x)} {number(y)}" for x, y in points.tolist()])
    if len(_texts) > _MOST_TEXTS:
        _texts.clear()
    pieces = [" "] * (2 * near.size)
    pieces[3::4] = ["L"] * len(points)
    pieces[::2] = map(_texts.__getitem__, near.astype(np.int64).ravel().tolist())
    return "".join(pieces[:-1])


class _Hundredths(dict[int, str]):
    """The text of so many hundredths, which many points have: written when first looked up."""

    def __missing__(self, hundredths: int) -> str:
        text = self[hundredths] = number(hundredths / 100.0)
        return text


def rho(value: float) -> str:
    """A robustness as a paper prints it."""
    shown = f"{value:.3g}".replace("-", "\N{MINUS SIGN}")
    return f"\N{GREEK SMALL LETTER RHO} = {shown}"


def _printable(content: str) -> str:
    # XML 1.0 has no way to write control characters.
    if content.isprintable():
        return content
    return "".join(char for char in content if char.isprintable())


_PLAIN = re.compile(r"[^&<>\"\n\r\t]*\Z").match
_texts = _Hundredths()
_MOST_TEXTS = 100_000
_HALF, _GREATEST = 1e-6, 1e9
