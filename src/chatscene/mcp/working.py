"""What the process does that works for an agent (`chatscene.view.child`): calls tools and reads resources.

It is a process of its own so that a call can be ended at any moment, with whatever it started.
"""

from __future__ import annotations

import base64
import os
import sys
import traceback
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits, SettingsError
from chatscene.mcp.folder import Folder
from chatscene.mcp.resources import listed_resources, read
from chatscene.mcp.tool import Answer, Desk, short
from chatscene.mcp.tools import TOOLS
from chatscene.mcp.walls import OFFLINE, stay_in
from chatscene.view.working import Answering, Question, Tell, serve


def main() -> None:
    """Work for an agent."""
    serve(working)


def working(setup: Question, tell: Tell) -> Answering:
    """Who answers, in the folder that is told first."""
    os.chdir(setup["folder"])
    reading = setup["reading"]
    folder = Folder(Path())
    for missing in stay_in(folder.root, Path(setup["temporary"]), reading.get("language_model", OFFLINE)):
        print(missing, file=sys.stderr)
    desk = Desk(folder, reading)

    def progress(what: str, done: int, total: int) -> None:
        tell({"what": what, "done": done, "total": total})

    return lambda question: answered(replace(desk, progress=progress), question)


def answered(desk: Desk, question: Question) -> dict[str, Any]:
    """What is answered to a question: what a tool says, what a resource holds, or what went wrong.

    Of what went wrong it is said whether the question names what there is not, or what it may not name: `absent`.
    """
    try:
        return _without_root(desk, _answer(desk, question))
    except ChatSceneError as error:
        return _without_root(desk, {"error": complaint(error), "absent": isinstance(error, SettingsError)})
    except Exception as error:  # noqa: BLE001 - whoever asked has an answer, and the next call another chance
        from chatscene.memory import lack_of_memory

        if (lacks := lack_of_memory(error)) is not None:
            return {"error": complaint(lacks)}
        traceback.print_exc(file=sys.stderr)
        told = f"a fault of chatscene, not of yours: {type(error).__name__}: {short(str(error), 300)}"
        return _without_root(desk, {"error": f"{told}; try another way, and report this with the server's output"})


def _answer(desk: Desk, question: Question) -> dict[str, Any]:
    if "tool" in question:
        tool = TOOLS[question["tool"]]
        said = tool.does(desk, **tool.checked(question["arguments"]))
        answer = said if isinstance(said, Answer) else Answer(said)
        return {"text": answer.text, "picture": base64.b64encode(answer.picture).decode()}
    if "resource" in question:
        content = read(desk, question["resource"])
        return {
            "text": content.text,
            "media": content.kind,
            "picture": base64.b64encode(content.picture).decode(),
        }
    found, following = listed_resources(desk, question["list"])
    return {"resources": found, "next": following}


def complaint(error: ChatSceneError) -> str:
    """What went wrong, as what, and what could be said instead."""
    lines = [f"{type(error).__name__}: {error}"]
    if isinstance(error, NothingFits | MeansSomethingElse):
        from chatscene.report.refused import refusal
        from chatscene.settings import RetrievalSettings

        text = error.text if isinstance(error, NothingFits) else ""
        told = refusal(error, text, RetrievalSettings().embedder)
        lines += [f"understood: {told['understood']}"] * bool(told["understood"])
        lines += [f"reading {one['reading']} ({one['probability']:.0%}): {one['text']}" for one in told["readings"]]
        lines += [f"this sentence works: {told['suggestion']}"] * bool(told["suggestion"])
        lines.append("next: say it in other words, or write the situation yourself: vocabulary, then build")
    return "\n".join(lines)


def _without_root(desk: Desk, answer: Mapping[str, Any]) -> dict[str, Any]:
    """The same, in which paths begin at the folder."""
    root = str(desk.folder.root)
    return {
        key: value.replace(f"{root}/", "").replace(root, ".") if isinstance(value, str) and key != "picture" else value
        for key, value in answer.items()
    }


if __name__ == "__main__":
    main()
