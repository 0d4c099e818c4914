"""SVG elements as text: escaped, with short numbers, the same bytes for the same drawing."""

from __future__ import annotations

from collections.abc import Iterable
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
        f" {name.rstrip('_').replace('_', '-')}={quoteattr(_text_of(value))}"
        for name, value in attributes.items()
        if value is not None
    )
    if not children:
        return f"<{tag}{shown}/>"
    return f"<{tag}{shown}>{''.join(children)}</{tag}>"


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
    pairs = [f"{number(x)} {number(y)}" for x, y in points.tolist()]
    return "M" + "L".join(pairs) + ("Z" if closed else "")


def rho(value: float) -> str:
    """A robustness as a paper prints it."""
    shown = f"{value:.3g}".replace("-", "\N{MINUS SIGN}")
    return f"\N{GREEK SMALL LETTER RHO} = {shown}"


def _text_of(value: object) -> str:
    return number(value) if isinstance(value, float) else str(value)


def _printable(content: str) -> str:
    # XML 1.0 has no way to write control characters.
    return "".join(char for char in content if char.isprintable())
