"""Ray: the contract of executors, and one run on two nodes, one of which is killed meanwhile, against processes.

    python benchmarks/two_nodes.py [--scenes 30] [--routes 4]

Needs the extra `ray`. The nodes are two raylets of this machine with a core each, joined as machines would be.
"""

from __future__ import annotations

import filecmp
import os
import socket
import tempfile
import threading
import time
from importlib import import_module
from pathlib import Path
from typing import Any

import click

from chatscene import runs
from chatscene.pipeline import search
from chatscene.runs.executor import Workers
from chatscene.settings import SearchSettings, Settings
from chatscene.testing import check_executor

TEXT = "A cyclist rides out from the left and stops in front of us."


@click.command()
@click.option("--scenes", default=30, show_default=True)
@click.option("--routes", default=4, show_default=True)
def main(scenes: int, routes: int) -> None:
    patient = {"RAY_raylet_start_wait_time_s": "120", "RAY_agent_register_timeout_ms": "600000"}
    os.environ |= {**patient, "RAY_USAGE_STATS_ENABLED": "0"}
    settings = Settings(search=SearchSettings(scenes=scenes, routes=routes))
    asked = runs.asked_run(TEXT, settings=settings, ego="sac")
    cluster: Any = import_module("ray.cluster_utils").Cluster(
        initialize_head=True, head_node_args={"include_dashboard": False, **_node()}
    )
    second = cluster.add_node(**_node())
    cluster.wait_for_nodes()
    ray = Workers(2, f"ray:{cluster.address}")
    check_executor(ray.executor)
    print("Ray keeps the contract of executors", flush=True)
    with tempfile.TemporaryDirectory() as place:
        folders = {name: Path(place) / name for name in ("processes", "two nodes", "one node killed")}
        _run(folders["processes"], asked, Workers(2))
        _run(folders["two nodes"], asked, ray)
        killer = threading.Thread(target=_kill, args=(cluster, second, folders["one node killed"]), daemon=True)
        killer.start()
        _run(folders["one node killed"], asked, ray)
        killer.join(1.0)
        print(f"a node was killed while the third ran: {not killer.is_alive()}")
        for name, folder in folders.items():
            print(f"{name}: {_compared(folders['processes'], folder)}")
    cluster.shutdown()


def _node() -> dict[str, Any]:
    """A node with a core; with ports of its own it need not wait for its agents to find theirs.

    Its address is this machine's own: Ray takes a driver's 127.0.0.1 for that, and would not find a node on loopback.
    """
    names = ("metrics_agent_port", "metrics_export_port", "dashboard_agent_listen_port", "runtime_env_agent_port")
    held = [socket.create_server(("", 0)) for _ in names]
    ports = {name: one.getsockname()[1] for name, one in zip(names, held, strict=True)}
    for one in held:
        one.close()
    return {"num_cpus": 1, **ports}


def _run(folder: Path, asked: runs.RunRecord, workers: Workers) -> None:
    search(
        runs.take_up(folder, asked), workers, lambda what, done, total: print(f"  {folder.name}: {what} {done}/{total}")
    )


def _kill(cluster: Any, node: Any, folder: Path) -> None:
    """Kill a node once two blocks are there."""
    while len(list(folder.glob("parts/*.json"))) < 2:
        time.sleep(0.02)
    cluster.remove_node(node, allow_graceful=False)


def _compared(one: Path, other: Path) -> str:
    """How the files of two runs compare, but for the record, which tells the time."""
    names = sorted(str(path.relative_to(one)) for path in one.rglob("*") if path.is_file() and path.name != "run.json")
    there = sorted(
        str(path.relative_to(other)) for path in other.rglob("*") if path.is_file() and path.name != "run.json"
    )
    differ = [name for name in names if name in there and not filecmp.cmp(one / name, other / name, shallow=False)]
    return f"{len(names)} files, {len(set(names) ^ set(there))} missing or added, {len(differ)} differ {differ}"


if __name__ == "__main__":
    main()
