"""What an agent may read beside its tools: schema, words, files of the folder, reports of runs, pictures."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice
from urllib.parse import parse_qs, quote, unquote, urlsplit

import chatscene
from chatscene.errors import SettingsError, no_such
from chatscene.mcp.driving import REPORTS, kept_scenes, seen
from chatscene.mcp.folder import RECORD
from chatscene.mcp.tool import SCHEME, Desk
from chatscene.mcp.words import explained, listed
from chatscene.mcp.writing import SITUATIONS

TEXTS = (".scenic", *SITUATIONS, *REPORTS, ".xosc", ".toml", ".csv")
LISTED = (".scenic", ".yaml", ".yml")  # files that are listed
MOST = 100_000  # characters of a resource
PAGE = 100  # resources that are listed at a time


@dataclass(frozen=True, slots=True)
class Content:
    """What a resource holds."""

    kind: str
    text: str = ""
    picture: bytes = b""


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind:
    """A row of the table of resources.

    Attributes:
        reads: Its content, from what stands behind its name, and what is asked of it.
        behind: What stands behind its name, as a template of an address has it; empty for nothing.
    """

    says: str
    reads: Callable[[Desk, str, dict[str, str]], Content]
    behind: str = ""
    media: str = "text/plain"


def read(desk: Desk, uri: str) -> Content:
    """What stands at an address.

    Raises:
        SettingsError: Nothing does.
        ChatSceneError: It cannot be read or driven.
    """
    try:
        parts = urlsplit(uri)
        asked = {name: values[-1] for name, values in parse_qs(parts.query, max_num_fields=5).items()}
    except ValueError as error:
        raise SettingsError(f"{uri[:100]!r} is not an address: {error}; {_ADDRESSES}") from error
    if parts.scheme != SCHEME or parts.netloc not in KINDS:
        known = no_such("resource", parts.netloc[:60], KINDS) if parts.scheme == SCHEME else _ADDRESSES
        raise SettingsError(f"there is nothing at {uri[:100]!r}: {known}")
    return KINDS[parts.netloc].reads(desk, unquote(parts.path.lstrip("/")), asked)


def listed_resources(desk: Desk, begin: int) -> tuple[list[dict[str, str]], int | None]:
    """Some of the resources there are, and where the next ones begin; None where there are no more."""
    found = [*islice(_every(desk), begin, begin + PAGE + 1)]
    return found[:PAGE], begin + PAGE if len(found) > PAGE else None


def _every(desk: Desk) -> Iterator[dict[str, str]]:
    for name, kind in KINDS.items():
        if not kind.behind:
            yield {"uri": f"{SCHEME}://{name}", "name": name, "says": kind.says, "media": kind.media}
    for path in desk.folder.files():
        if path.suffix.lower() in LISTED:
            yield _address("file", str(path))
        elif path.name == RECORD:
            yield _address("report", str(path.parent))


def _address(kind: str, name: str) -> dict[str, str]:
    row = KINDS[kind]
    return {"uri": f"{SCHEME}://{kind}/{quote(name)}", "name": name, "says": row.says, "media": row.media}


_ADDRESSES = f"addresses are such as {SCHEME}://acts, {SCHEME}://file/PATH"


def _schema(_desk: Desk, _path: str, _asked: dict[str, str]) -> Content:
    from chatscene.situations.form import schema

    return Content("application/schema+json", json.dumps(schema(), ensure_ascii=False))


def _words(about: str) -> Callable[[Desk, str, dict[str, str]], Content]:
    def reads(_desk: Desk, path: str, _asked: dict[str, str]) -> Content:
        return Content("text/plain", explained(about or path) if about or path else listed())

    return reads


def _file(desk: Desk, path: str, _asked: dict[str, str]) -> Content:
    where = desk.folder.root / desk.folder.file(path, *TEXTS)
    try:
        with where.open(encoding="utf-8", errors="replace") as file:
            text = file.read(MOST + 1)
    except OSError as error:
        raise SettingsError(f"{path!r} cannot be read: {error.strerror}") from error
    return Content("text/plain", _bounded(text))


def _report(desk: Desk, path: str, _asked: dict[str, str]) -> Content:
    run = chatscene.Run(desk.folder.run(path))
    return Content("text/plain", _bounded("\n".join((str(run), "kept scenes:", *kept_scenes(run)))))


def _bounded(text: str) -> str:
    more = f"\n… more than {MOST:,} characters; the rest is left out" * (len(text) > MOST)
    return text[:MOST] + more


def _picture(desk: Desk, path: str, asked: dict[str, str]) -> Content:
    try:
        at = float(asked["at"]) if "at" in asked else None
    except ValueError:
        raise SettingsError(f"at={asked['at'][:40]!r} is not a time; give seconds, such as at=2.5") from None
    told = chatscene.story(seen(desk, path), scene=asked.get("scene"), within=desk.folder.root)
    return Content("image/png", picture=told.picture(at))


KINDS: dict[str, Kind] = {
    "schema": Kind(says="The JSON schema of a situation.", reads=_schema, media="application/schema+json"),
    "acts": Kind(says="What road users may do, with meanings.", reads=_words("Act")),
    "places": Kind(says="Where road users may start, with meanings.", reads=_words("Where")),
    "vocabulary": Kind(says="All words of a situation.", reads=_words("")),
    "word": Kind(says="One word, table, noun or path of a situation.", reads=_words(""), behind="/{word}"),
    "file": Kind(says="A program, situation, table or other text of the folder.", reads=_file, behind="/{+path}"),
    "report": Kind(says="What a run of the folder came to.", reads=_report, behind="/{+run}"),
    "picture": Kind(
        says="A moment of a drive from above; at in seconds.",
        reads=_picture,
        behind="/{+path}{?scene,at}",
        media="image/png",
    ),
}
"""By what stands behind the scheme of an address."""
