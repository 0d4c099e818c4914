"""HTML and SVG elements as text, escaped."""

from __future__ import annotations

from collections.abc import Mapping
from xml.sax.saxutils import escape, quoteattr

from ..diagnostics.printable import printable

_VOID = frozenset({"br", "hr", "img", "input", "meta"})


def element(tag: str, *children: str, **attributes: object) -> str:
    """An element with children that are written already; `class_` becomes `class`, `aria_label`
    `aria-label`. Attributes that are None are left out, True has no value."""
    shown = _attributes(attributes)
    return f"<{tag}{shown}>" if tag in _VOID else f"<{tag}{shown}>{''.join(children)}</{tag}>"


def drawing(*parts: str, **attributes: object) -> str:
    """A picture of SVG elements."""
    return f"<svg{_attributes(attributes)}>{''.join(parts)}</svg>"


def text(content: object) -> str:
    """Text, without control characters."""
    return escape(printable(str(content), keep="\n\t"))


def _attributes(named: Mapping[str, object]) -> str:
    return "".join(
        f" {_name(name)}" if value is True else f" {_name(name)}={quoteattr(str(value))}"
        for name, value in named.items()
        if value is not None
    )


def _name(name: str) -> str:
    return name.rstrip("_").replace("_", "-")
