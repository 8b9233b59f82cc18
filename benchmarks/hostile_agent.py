"""A hostile agent: malformed calls, paths that lead out, huge arguments, hostile files; one clear error for each?

    python benchmarks/hostile_agent.py --calls 10000 --seed 0

The server is the command, over its standard streams, in a folder with a run and with links that lead out of it. Beside
the folder lie files with a secret. Counted is, by kind of call: how many had exactly one answer, which is an error of
bounded length, and names the path where one led out; whether the secret is in any answer, whether anything changed in
the folder beside, and whether the server still works. Needs what the tests need.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from chatscene.mcp.server import MOST_ERROR
from chatscene.mcp.tools import TOOLS

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from folder_of_agents import CALLS, OUTSIDE, SECRET, SITUATION, furnished_with_run, paths_of

MOST = MOST_ERROR + 1  # characters of an error: its bound, and the sign that it was cut
AT_A_TIME = 16
BEGIN = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "hostile", "version": "1"}}
HOSTILE_PROGRAMS = (
    "import os\nego = new Car\n",
    "model chatscene.world.model\nego = new Car\nopen('../outside/secret.txt')\n",
    "model scenic.domains.driving.model\nparam map = localPath('../outside/secret.xodr')\nego = new Car\n",
    "model scenic.domains.driving.model\nego = new Car with behavior (().__class__.__base__.__subclasses__())\n",
    "model chatscene.world.model\n" + "x = 1\n" * 5_000,
    "\ud7ff" * 100,
)
HOSTILE_SITUATIONS = (
    "a: &a [x,x,x,x,x,x,x,x,x]\nb: &b [*a,*a,*a,*a,*a,*a,*a,*a,*a]\nc: &c [*b,*b,*b,*b,*b,*b,*b,*b,*b]\nothers: *c\n",
    "!!python/object/apply:os.system ['touch ../outside/made']\n",
    "map: ../outside/secret.xodr\n" + SITUATION,
    "map: /etc/passwd\n" + SITUATION,
    "[" * 5_000,
    "others: [{id: A, kind: dragon, does: [{act: fly}]}]\n",
    "a: b: c\n",
)


@dataclass(frozen=True, slots=True)
class Asked:
    """A line to the server.

    Attributes:
        line: It.
        id: Of its answer.
        says: What its error says among other things.
    """

    line: bytes
    id: Any
    says: str = ""


Call = tuple[str, Asked]
"""What it is of `KINDS`, and the line."""


def furnished(above: Path) -> Path:
    """A folder for agents with a run and hostile files, and beside it what is none of theirs."""
    folder = furnished_with_run(above / "folder")
    for number, text in enumerate(HOSTILE_PROGRAMS):
        (folder / f"hostile-{number}.scenic").write_text(text, encoding="utf-8")
    return folder


def state_of(outside: Path) -> dict[str, str]:
    """What lies somewhere, and a digest of each."""
    return {str(path): hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(outside.rglob("*"))}


def value(draw: random.Random, deep: int = 3) -> Any:  # noqa: PLR0911
    """Anything that JSON can say."""
    kinds = 9 if deep else 7
    match draw.randrange(kinds):
        case 0:
            return None
        case 1:
            return draw.choice((True, False))
        case 2:
            return draw.choice((0, -1, 2**63, 10**300, draw.randrange(10**6)))
        case 3:
            return draw.choice((1e308, -0.0, 0.5, 5e-324))
        case 4:
            return "".join(chr(draw.randrange(1, 0xD7FF)) for _ in range(draw.randrange(20)))
        case 5:
            return draw.choice(("../x", "/etc/passwd", "link/secret.yaml", "~", "a" * 600, "x\0y", "\n", "$(id)"))
        case 6:
            return "x" * draw.randrange(100_001, 300_000) if draw.random() < 0.02 else "x" * draw.randrange(3_000)
        case 7:
            return [value(draw, deep - 1) for _ in range(draw.randrange(4))]
        case _:
            return {f"k{number}": value(draw, deep - 1) for number in range(draw.randrange(4))}


def outside_name(draw: random.Random) -> str:
    """A name that leads out of the folder."""
    above = draw.choice(
        ("../outside/", "/etc/", "link/", "./../outside/", "runs/../../outside/", "link/../outside/", "//")
    )
    name = draw.choice(OUTSIDE)
    return f"link-{name}" if draw.random() < 0.2 else above + name


def line_of(number: int, method: str, params: Any) -> bytes:
    """A request."""
    return json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": params}).encode()


def call_of(number: int, tool: Any, arguments: Any) -> bytes:
    """A call of a tool."""
    return line_of(number, "tools/call", {"name": tool, "arguments": arguments})


def no_message(draw: random.Random, number: int) -> Asked:
    """A line that is no message."""
    lines = (
        (bytes(draw.randrange(32, 127) for _ in range(draw.randrange(1, 60))), None),
        (b"[" * draw.randrange(1, 5_000), None),
        (b"\xff\xfe" + bytes(draw.randrange(128, 255) for _ in range(9)), None),
        (json.dumps({"jsonrpc": "2.0", "id": number}).encode(), number),
        (json.dumps({"jsonrpc": "9", "id": number, "method": "tools/list"}).encode(), number),
        (
            json.dumps({"jsonrpc": "2.0", "id": draw.choice((1.5, None, True, [1])), "method": "tools/list"}).encode(),
            None,
        ),
        (json.dumps({"jsonrpc": "2.0", "id": number, "method": value(draw, 0) or 7, "params": [1]}).encode(), number),
        (json.dumps([value(draw) for _ in range(3)]).encode(), None),
    )
    return Asked(*draw.choice(lines))


def wrong_request(draw: random.Random, number: int) -> Asked:
    """A request that asks for what there is not, or not as it is asked."""
    line = draw.choice(
        (
            line_of(number, "".join(draw.choice("abc/") for _ in range(9)), {}),
            line_of(number, "tools/call", {"name": value(draw)} if draw.random() < 0.5 else {"arguments": {}}),
            call_of(number, "x" + draw.choice(list(TOOLS)), {}),
            call_of(number, draw.choice(list(TOOLS)), draw.choice(([1], "x", 7))),
            line_of(number, "resources/list", {"cursor": draw.choice(("x", "-1", "1" * 50))}),
            line_of(
                number,
                "resources/read",
                {"uri": draw.choice(("", "x", "file:///etc/passwd", "chatscene://no", "[" * 99))},
            ),
        )
    )
    return Asked(line, number)


def wrong_arguments(draw: random.Random, number: int) -> Asked:
    """A call whose arguments are none of the tool's."""
    tool = draw.choice(list(TOOLS))
    names = list(TOOLS[tool].arguments.model_fields)
    arguments = {name: value(draw) for name in draw.sample(names, draw.randrange(len(names) + 1))}
    wrong = {draw.choice(("nonsense", "__class__", "Part", "")): value(draw)}
    return Asked(call_of(number, tool, {**arguments, **wrong}), number)


def path_outside(draw: random.Random, number: int) -> Asked:
    """A call that is right but for a path, which leads out."""
    tool = draw.choice([tool for tool in TOOLS if paths_of(tool)])
    path, name = draw.choice(paths_of(tool)), outside_name(draw)
    return Asked(call_of(number, tool, {**CALLS[tool], path: name}), number, f"{name!r} lies outside the folder")


def address_outside(draw: random.Random, number: int) -> Asked:
    """A resource that lies outside."""
    kind = draw.choice(("file", "report", "picture"))
    name = draw.choice(
        (outside_name(draw), outside_name(draw).replace("/", "%2f"), outside_name(draw).replace(".", "%2e"))
    )
    says = repr(unquote(name.lstrip("/")))
    return Asked(line_of(number, "resources/read", {"uri": f"chatscene://{kind}/{name}"}), number, says)


def hostile_content(draw: random.Random, number: int) -> Asked:
    """A situation or a program that is to do harm."""
    if draw.random() < 0.7:
        return Asked(call_of(number, "build", {"situation": draw.choice(HOSTILE_SITUATIONS)}), number)
    program = f"hostile-{draw.randrange(len(HOSTILE_PROGRAMS))}.scenic"
    tool, arguments = draw.choice(
        (("verify", {"what": program, "said_file": "crosses.yaml"}), ("story", {"what": program}))
    )
    return Asked(call_of(number, tool, arguments), number)


KINDS: dict[str, tuple[float, Callable[[random.Random, int], Asked]]] = {
    "no message": (0.15, no_message),
    "wrong request": (0.15, wrong_request),
    "wrong arguments": (0.35, wrong_arguments),
    "a path outside": (0.2, path_outside),
    "an address outside": (0.1, address_outside),
    "hostile content": (0.05, hostile_content),
}
"""How many of the calls are of each kind, and one of it."""


def calls(count: int, seed: int) -> Iterator[Call]:
    """So many calls, drawn by a seed."""
    draw = random.Random(seed)
    names, shares = list(KINDS), [share for share, _ in KINDS.values()]
    for number in range(1, count + 1):
        kind = draw.choices(names, shares)[0]
        yield kind, KINDS[kind][1](draw, number)


def fault_of(answer: dict[str, Any], says: str) -> str:
    """What is wrong with an answer; empty if it is one clear error, which says so."""
    if "error" in answer:
        text = answer["error"]["message"]
    elif answer["result"].get("isError"):
        text = answer["result"]["content"][0]["text"]
    else:
        return f"no error: {json.dumps(answer)[:200]}"
    if not text.strip() or len(text) > MOST:
        return f"an error of {len(text)} characters"
    if "a fault of chatscene" in text or "Traceback" in text:
        return f"unclear: {text[:200]}"
    return "" if says in text else f"about something else: {text[:200]}"


def attacked(folder: Path, count: int, seed: int) -> tuple[Counter[tuple[str, str]], bool, list[str]]:
    """What came of each kind of call, whether the server works at the end, and what was wrong."""
    command = [sys.executable, "-m", "chatscene", "mcp", str(folder)]
    found, wrong = Counter[tuple[str, str]](), list[str]()
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdin
        assert process.stdout
        process.stdin.write(line_of(0, "initialize", BEGIN) + b"\n")
        process.stdin.flush()
        process.stdout.readline()
        batch: list[Call] = []

        def ask() -> None:
            assert process.stdin
            assert process.stdout
            process.stdin.write(b"".join(one.line + b"\n" for _, one in batch))
            process.stdin.flush()
            waiting = list(batch)
            for _ in batch:
                said = process.stdout.readline()
                answer = json.loads(said)
                mine = next(call for call in waiting if call[1].id == answer["id"])
                waiting.remove(mine)
                kind, one = mine
                fault = fault_of(answer, one.says) or ("the secret" if SECRET.encode() in said else "")
                found[kind, "fault" if fault else "one clear error"] += 1
                if fault:
                    wrong.append(f"{kind}: {one.line[:200]!r}: {fault}")
            batch.clear()

        for call in calls(count, seed):
            batch.append(call)
            if len(batch) == AT_A_TIME:
                ask()
        if batch:
            ask()
        process.stdin.write(call_of(0, "vocabulary", {"about": "cut-in"}) + b"\n")
        process.stdin.flush()
        last = json.loads(process.stdout.readline())
        process.stdin.close()
        alive = process.wait(60) == 0 and not last["result"].get("isError") and not process.stdout.read()
    return found, alive, wrong


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--calls", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="hostile-") as above:
        folder = furnished(Path(above))
        before, began = state_of(folder.parent / "outside"), time.monotonic()
        spent = os.times().children_user + os.times().children_system
        found, alive, wrong = attacked(folder, asked.calls, asked.seed)
        spent = os.times().children_user + os.times().children_system - spent
        unchanged = state_of(folder.parent / "outside") == before
        beside = sorted(path.name for path in folder.parent.iterdir()) == ["folder", "outside"]
    print(f"{asked.calls} calls, seed {asked.seed}: {time.monotonic() - began:.0f} s, {spent:.0f} s of processor time")
    for kind in KINDS:
        right, faults = found[kind, "one clear error"], found[kind, "fault"]
        print(f"| {kind} | {right + faults} | {right} |")
    print(f"outside unchanged: {unchanged and beside}; the server works at the end: {alive}; faults: {len(wrong)}")
    for line in wrong[:20]:
        print(line)


if __name__ == "__main__":
    main()
