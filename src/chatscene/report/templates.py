"""The templates of the pages; Jinja escapes all that they are given."""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import files
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup


def fill(template: str, **values: object) -> str:
    """A whole page.

    Args:
        template: Name of its file.
        values: What it shows; text is escaped, markup is not.
    """
    return _environment().get_template(template).render(**values)


def fill_section(name: str, *values: object) -> Markup:
    """A section of a page.

    Args:
        name: Name of its macro in ``sections.html``.
        values: What it shows; text is escaped, markup is not.
    """
    return getattr(_environment().get_template("sections.html").module, name)(*values)


def asset(name: str) -> Markup:
    """A file of ours that goes into a page as it is."""
    from markupsafe import Markup

    return Markup(_text(name))


def _text(name: str) -> str:
    return files("chatscene.report").joinpath(name).read_text(encoding="utf-8")


@lru_cache(maxsize=1)
def _environment() -> Environment:
    from jinja2 import Environment, FunctionLoader, StrictUndefined

    return Environment(
        loader=FunctionLoader(_text),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
