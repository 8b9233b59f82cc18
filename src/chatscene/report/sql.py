"""SQL over an index: one reading statement, answered by DuckDB in memory, which can reach nothing but the tables.

Whoever asks may have copied the query from somewhere, and DuckDB can read files and addresses, load extensions, and
take variables of the calling process for tables. All of that is shut, and the lock is thrown before the query is read.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from decimal import Decimal
from math import isfinite
from typing import Any, cast

from chatscene.errors import MissingExtra, QueryError
from chatscene.report.index import Index
from chatscene.runs.tables import Table

ROWS = 1_000_000  # of an answer, at most
MEMORY = "1GB"  # of what a query sorts, joins and groups; the tables of 20,000 scenes are 24 MB
_SHUT: dict[str, str | bool | int | float | list[str]] = {
    "enable_external_access": "false",  # files, addresses, other databases
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
    """The answer to a query: an Arrow table.

    Args:
        query: One statement in DuckDB's SQL that only reads, such as a SELECT.
        index: The tables that it may name.

    Raises:
        MissingExtra: DuckDB is not installed.
        QueryError: It is no SQL, names what there is not, or would do more than read these tables.
    """
    try:
        query.encode()
    except UnicodeEncodeError as error:
        raise QueryError(f"the query is no text in UTF-8: {error.object[: error.start]!r} ends there") from error
    try:
        import duckdb
    except ModuleNotFoundError as error:
        raise MissingExtra("SQL over runs needs duckdb", extra="sql") from error

    with duckdb.connect(":memory:", config=_SHUT) as connection:
        for name, table in index.tables.items():
            connection.register(name, table)
        connection.execute("SET lock_configuration = true")
        try:
            statements = connection.extract_statements(query)
            if [one.type for one in statements] != [duckdb.StatementType.SELECT]:
                kinds = " and ".join(one.type.name for one in statements) or "none"
                raise QueryError(
                    f"cannot answer {query!r}: it takes one statement that reads, such as SELECT … FROM scenes; "
                    f"this is {kinds}"
                )
            _refuse_what_does_more(connection, query)
            answer = connection.sql(statements[0]).limit(ROWS + 1).to_arrow_table()
        except duckdb.Error as error:
            raise QueryError(
                f"cannot answer the query: {error}\nA query reads the tables of the index and nothing else; "
                "chatscene sql --tables lists them with their columns"
            ) from error
    if answer.num_rows > ROWS:
        raise QueryError(f"the answer has more than {ROWS:,} rows; count or average them, or end it with LIMIT")
    return answer


def _refuse_what_does_more(connection: Any, query: str) -> None:
    """Hold every function that a query calls against those that only compute.

    DuckDB's functions can also print, log, wait, or follow an address in memory: as a table it may take those of a
    list, and elsewhere whatever has no side effect.

    Raises:
        QueryError: It calls another one, or cannot be looked through.
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
    """The rows of an answer as JSON has them: what is no number there is null, what JSON has not is text.

    Raises:
        QueryError: Two columns have one name.
    """
    names: list[str] = answer.column_names
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise QueryError(f"two columns of the answer are called {twice[0]!r}; name one of them otherwise with AS")
    return [{name: _plain(value) for name, value in row.items()} for row in answer.to_pylist()]


def _plain(value: Any) -> Any:
    plain: Any = value
    match value:
        case float():
            plain = value if isfinite(value) else None
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
