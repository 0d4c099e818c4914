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
    """The `d` of a polyline through (n, 2) points."""
    return "M" + "L".join(_pairs(points)) + ("Z" if closed else "")


def _pairs(points: Floats) -> list[str]:
    """`x y` of each point (n, 2), the numbers as `number` writes them."""
    import numpy as np

    hundredths = points * 100.0
    near = np.rint(hundredths)
    # Halves that are not exact, and numbers without hundredths, are rounded as they are written.
    unsure = np.abs(np.abs(hundredths - near) - 0.5) < _HALF
    if not (np.abs(near) < _GREATEST).all() or unsure.any():
        return [f"{number(x)} {number(y)}" for x, y in points.tolist()]
    whole, rest = np.divmod(np.abs(near).astype(np.int64), 100)
    parts = zip(whole.ravel().tolist(), rest.ravel().tolist(), strict=True)
    texts = iter([f"{left}{_ENDS[right]}" for left, right in parts])
    is_negative = near < 0.0
    if is_negative.any():
        minus = is_negative.ravel().tolist()
        texts = iter([_SIGNS[sign] + text for sign, text in zip(minus, texts, strict=True)])
    return [f"{x} {y}" for x, y in zip(texts, texts, strict=True)]


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
_SIGNS = ("", "-")
_ENDS = ("", *(f".{part:02d}".rstrip("0") for part in range(1, 100)))
_HALF, _GREATEST = 1e-6, 1e9
