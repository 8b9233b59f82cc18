"""XML, written as it nests."""

from __future__ import annotations

import re
from collections.abc import Mapping
from xml.etree import ElementTree as Xml

_NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_DECIMALS = 9  # of a metre, a radian or a second


def element(tag: str, attributes: Mapping[str, str | float | bool] | None = None, *inside: Xml.Element) -> Xml.Element:
    """An element with what stands in it; numbers have at most nine decimals, and what XML cannot say is left out."""
    made = Xml.Element(tag, {name: _text(value) for name, value in (attributes or {}).items()})
    made.extend(inside)
    return made


def told(tag: str, value: str | float) -> Xml.Element:
    """An element that holds a value and nothing else, written as those of attributes are."""
    made = Xml.Element(tag)
    made.text = _text(value)
    return made


def _text(value: str | float | bool) -> str:
    match value:
        case str():
            return _NOT_XML.sub("", value)
        case bool():
            return str(value).lower()
        case int():
            return str(value)
        case _:
            return f"{value + 0.0:.{_DECIMALS}f}".rstrip("0").rstrip(".")
