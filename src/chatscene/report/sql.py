"""SQL over an index: one reading statement, answered by DuckDB in memory, which can reach nothing but the tables.

Whoever asks may have copied the query from somewhere, and DuckDB can read files and addresses, load extensions, and
take variables of the calling process for tables. All of that is shut, and the lock is thrown before the query is read.
DuckDB's own bound on memory knows nothing of long texts and lists in an answer, and a fault in it would end whoever
asks. So a process of its own answers, which the system holds to its bounds.
"""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, BinaryIO, cast

import pyarrow as pa

from chatscene.errors import MissingExtra, QueryError

if TYPE_CHECKING:
    from chatscene.report.index import Index
    from chatscene.runs.tables import Table

ROWS = 1_000_000  # of an answer, at most
MEMORY = "1GB"  # of what a query sorts, joins and groups; the tables of 20,000 scenes are 24 MB
PROCESSOR_TIME = 600  # [s]
_ALL_MEMORY = 4 * 2**30  # bytes of the process that answers, besides the tables
_ANSWER, _REFUSAL = b"A", b"R"
_SHUT: dict[str, str | bool | int | float | list[str]] = {
    "autoinstall_known_extensions": "false",
    "autoload_known_extensions": "false",
    "allow_community_extensions": "false",
    "python_enable_replacements": "false",  # variables of the caller as tables
    "temp_directory": "",  # what does not fit is an error and no file
    "memory_limit": MEMORY,
    "threads": "1",  # a sum is the same to the last bit each time, and so is the order of rows
}

_TABLE_FUNCTIONS = frozenset({"range", "generate_series", "repeat", "unnest", "json_each", "json_tree"})
_DRAWS = frozenset({"random", "uuid", "uuidv4", "uuidv7", "gen_random_uuid", "error"})  # of what has side effects


def ask(query: str, index: Index) -> Table:
    """The answer to a query: an Arrow table. A process of its own finds it.

    Args:
        query: One statement in DuckDB's SQL that only reads, such as a SELECT.
        index: The tables that it may name.

    Raises:
        MissingExtra: DuckDB is not installed.
        QueryError: It is no SQL, names what there is not, would do more than read these tables, or takes too much.
    """
    if find_spec("duckdb") is None:
        raise MissingExtra("SQL over runs needs duckdb", extra="sql")
    asked = pa.BufferOutputStream()
    setup = {
        "query": query,
        "tables": list(index.tables),
        "files": [str(path) for one in index.large for path in one.files],
        "selects": {
            name: [one.selects[name] for one in index.large if name in one.selects]
            for name in index.tables
            if index.large
        },
    }
    _write(asked, json.dumps(setup).encode())
    for table in index.tables.values():
        _write(asked, _packed(table))
    # -P: the working folder is no place of modules
    command = [sys.executable, "-P", "-m", "chatscene.report.sql"]
    done = subprocess.run(
        command, input=asked.getvalue(), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False
    )
    if done.returncode == 0 and done.stdout[:1] == _ANSWER:
        return _unpacked(done.stdout[1:])
    if done.returncode == 0 and done.stdout[:1] == _REFUSAL:
        raise QueryError(done.stdout[1:].decode())
    raise QueryError(
        f"cannot answer {query[:1000]!r}: it takes more than {_ALL_MEMORY // 2**30} GiB or {PROCESSOR_TIME} s of the "
        "processor, or breaks DuckDB"
    )


def main() -> None:
    """Answer the query that is on the standard input, with its tables; the answer goes to the standard output."""
    source, out = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # nothing that a query has printed is taken for an answer
    setup = json.loads(_read(source))
    packed = {name: _read(source) for name in setup["tables"]}
    _hold(_ALL_MEMORY + 4 * sum(map(len, packed.values())))
    try:
        tables = {name: _unpacked(one) for name, one in packed.items()}
        told = _ANSWER + _packed(answer(setup["query"], tables, selects=setup["selects"], files=setup["files"]))
    except QueryError as error:
        told = _REFUSAL + str(error).encode(errors="replace")
    with out:
        out.write(told)


def _hold(memory: int) -> None:
    """Have the system end this process if it takes more than so many bytes, or too long."""
    if sys.platform != "win32":
        import resource

        for what, wanted in ((resource.RLIMIT_AS, memory), (resource.RLIMIT_CPU, PROCESSOR_TIME)):
            _, hard = resource.getrlimit(what)
            most = wanted if hard == resource.RLIM_INFINITY else min(wanted, hard)
            resource.setrlimit(what, (most, hard))


def _packed(table: Table) -> bytes:
    sink = pa.BufferOutputStream()
    with pa.ipc.new_stream(sink, table.schema) as writer:
        writer.write_table(table)
    return sink.getvalue().to_pybytes()


def _unpacked(packed: bytes) -> Table:
    with pa.ipc.open_stream(packed) as reader:
        return reader.read_all()


def _write(to: Any, content: bytes) -> None:
    to.write(len(content).to_bytes(8, "big") + content)


def _read(source: BinaryIO) -> bytes:
    return source.read(int.from_bytes(source.read(8), "big"))


def answer(
    query: str,
    tables: Mapping[str, Table],
    *,
    selects: Mapping[str, Sequence[str]] | None = None,
    files: Sequence[str] = (),
) -> Table:
    """The answer to a query, found in this process: it may take what DuckDB takes.

    Raises:
        QueryError: It is no SQL, names what there is not, or would do more than read these tables.
    """
    try:
        query.encode()
    except UnicodeEncodeError as error:
        raise QueryError(f"the query is not UTF-8 text: {error.object[: error.start]!r} ends there") from error
    import duckdb

    with duckdb.connect(":memory:", config=_SHUT) as connection:
        try:
            _open(connection, tables, selects or {}, files)
            statements = connection.extract_statements(query)
            if [one.type for one in statements] != [duckdb.StatementType.SELECT]:
                kinds = " and ".join(one.type.name for one in statements) or "none"
                raise QueryError(
                    f"cannot answer {query!r}: it takes one statement that reads, such as SELECT … FROM scenes; "
                    f"this is {kinds}"
                )
            _refuse_what_does_more(connection, query)
            found = connection.sql(statements[0]).limit(ROWS + 1).to_arrow_table()
        except (duckdb.Error, MemoryError, pa.ArrowException) as error:
            raise QueryError(
                f"cannot answer the query: {error}\nA query reads the tables of the index and nothing else; "
                "chatscene sql --tables lists them with their columns"
            ) from error
    if found.num_rows > ROWS:
        raise QueryError(f"the answer has more than {ROWS:,} rows; count or average them, or end it with LIMIT")
    return found


def _open(
    connection: Any, tables: Mapping[str, Table], selects: Mapping[str, Sequence[str]], files: Sequence[str]
) -> None:
    """Give a connection its tables, and shut all else."""
    if files:
        connection.execute(f"SET allowed_paths = [{', '.join(map(literal, files))}]")
    connection.execute("SET enable_external_access = false")  # files, addresses, other databases
    for name, table in tables.items():
        more = selects.get(name, ())
        connection.register(f"{name} of small runs" if more else name, table)
        if more:
            every = (f"SELECT * FROM {quoted(f'{name} of small runs')}", *more)
            connection.execute(f"CREATE TEMP VIEW {quoted(name)} AS {' UNION ALL BY NAME '.join(every)}")
    connection.execute("SET lock_configuration = true")


def literal(text: str) -> str:
    """A text in SQL."""
    return "'" + text.replace("'", "''") + "'"


def quoted(name: str) -> str:
    """A name in SQL."""
    return '"' + name.replace('"', '""') + '"'


def _refuse_what_does_more(connection: Any, query: str) -> None:
    """Hold every function that a query calls against those that only compute.

    DuckDB's functions can also print, log, wait, or follow an address in memory: as a table it may take those of a
    list, and elsewhere whatever has no side effect.
    """
    tree = json.loads(connection.execute("SELECT json_serialize_sql(?)", [query]).fetchone()[0])
    if tree.get("error", True):
        raise QueryError(f"cannot answer {query!r}: {tree.get('error_message', 'it cannot be looked through')}")
    acting = "SELECT DISTINCT function_name FROM duckdb_functions() WHERE has_side_effects"
    refused = {str(name) for (name,) in connection.execute(acting).fetchall()} - _DRAWS
    for name, as_table in _functions(tree["statements"]):
        if name in refused or (as_table and name not in _TABLE_FUNCTIONS):
            raise QueryError(
                f"cannot answer {query!r}: it calls {name}(), which does more than read the tables of the index; "
                f"of functions that give a table, it may call {', '.join(sorted(_TABLE_FUNCTIONS))}"
            )


def _functions(tree: Any) -> Iterator[tuple[str, bool]]:
    """Every function that is called in a query, and whether as a table."""
    left: list[tuple[Any, bool]] = [(tree, False)]
    while left:
        node, as_table = left.pop()
        if isinstance(node, dict):
            one = cast("dict[str, Any]", node)
            if name := one.get("function_name"):
                yield str(name).lower(), as_table
            of_table = one.get("type") == "TABLE_FUNCTION"
            left += [(child, of_table and key == "function") for key, child in one.items()]
        elif isinstance(node, list):
            left += [(child, False) for child in cast("list[Any]", node)]


def rows_of(answer: Table) -> list[dict[str, Any]]:
    """The rows of an answer as JSON has them: what JSON has not is text, infinity and NaN among it.

    Raises:
        QueryError: Two columns have one name.
    """
    names: list[str] = answer.column_names
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise QueryError(f"two columns of the answer are called {twice[0]!r}; name one of them otherwise with AS")
    return [{name: _plain(value) for name, value in row.items()} for row in answer.to_pylist()]


_BEYOND = {math.inf: "Infinity", -math.inf: "-Infinity"}


def _plain(value: Any) -> Any:
    plain: Any = value
    match value:
        case float():
            plain = value if math.isfinite(value) else _BEYOND.get(value, "NaN")
        case Decimal():
            plain = int(value) if value == value.to_integral_value() else float(value)
        case bytes():
            plain = value.hex()
        case list() | tuple():
            plain = [_plain(one) for one in cast("list[object]", value)]
        case dict():
            plain = {str(name): _plain(one) for name, one in cast("dict[object, object]", value).items()}
        case None | bool() | int() | str():
            pass
        case _:
            plain = str(value)
    return plain


if __name__ == "__main__":
    main()
