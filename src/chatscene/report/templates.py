"""The templates of the pages; Jinja escapes all that they are given."""

from __future__ import annotations

import base64
import hashlib
from functools import lru_cache
from importlib.resources import files
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup


def fill(template: str, **values: object) -> str:
    """A whole page."""
    return _environment().get_template(template).render(**values)


def fill_section(name: str, *values: object) -> Markup:
    """A section of a page."""
    return getattr(_environment().get_template("sections.html").module, name)(*values)


def asset(name: str) -> Markup:
    """A file of ours that goes into a page as it is."""
    from markupsafe import Markup

    return Markup(_text(name))


def scripts(*names: str) -> Markup:
    """Scripts of ``page/`` as one, so that one digest allows it and nothing in it is seen from outside."""
    from markupsafe import Markup

    parts = Markup("\n").join(asset(f"page/{name}.js") for name in names)
    return Markup('"use strict";\n(() => {{\n{}}})();\n').format(parts)


def policy(script: str = "") -> Markup:
    """Content security policy: this one script, if there is one, inline styles, nothing from anywhere else."""
    from markupsafe import Markup

    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    allowed = f" script-src 'sha256-{digest}';" if script else ""
    return Markup(f"default-src 'none';{allowed} style-src 'unsafe-inline'; img-src data:")


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
