"""Compiling a program: Scenic's compiler with a memory.

Scenic parses the driving library anew for every program, which takes most of a second. Here the parsed code of
each source text is kept for the life of the process, and the road network of each map likewise; the code of the library
itself, and that of the programs that were compiled last, is kept in the user's cache folder, too, for the next process.
"""

from __future__ import annotations

import ast
import gc
import hashlib
import marshal
import sys
from collections import OrderedDict
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache, lru_cache
from importlib.util import MAGIC_NUMBER
from pathlib import Path
from types import CodeType
from typing import Any, Literal

import scenic
from scenic.core import object_types
from scenic.core.distributions import needsSampling
from scenic.core.errors import ScenicError
from scenic.core.specifiers import PropertyDefault
from scenic.syntax import translator, veneer

from chatscene.errors import ChatSceneError, DoesNotCompile
from chatscene.files.caches import cache_folder, installed, keep, keep_latest, kept, only_mine, sealed
from chatscene.maps.network import install_network_memo, map_digest
from chatscene.parsing import quicken
from chatscene.terms.pointing import fault, place_in, pointed
from chatscene.terms.scene import OWN_MODEL
from chatscene.world import searched
from chatscene.world.models import STANDS_IN

_LIBRARY = (Path(str(scenic.__file__)).parent, Path(__file__).parents[1])
PROGRAMS = 256  # whose code is kept between processes, some 20 kB each

keeping = True
"""Whether code is kept between processes; a confined one, which may touch no such folder, sets it off."""

_open: list[Callable[[], None]] = []  # how to end the session that is open in this process

_names: list[dict[str, Any]] = []
"""Of the program that is compiled: Scenic drops them where no behavior reads them."""

_code: dict[tuple[bytes, str], tuple[Any, Any, bytes]] = {}


def take_process(end: Callable[[], None]) -> None:
    """Say that a session is open in this process, and how it is ended where another needs the process."""
    free_process()
    _open.append(end)


def free_process() -> None:
    """End the session that is open in this process, if any: Scenic compiles and runs one program at a time."""
    while _open:
        _open.pop()()


def _compile_stream(stream: Any, namespace: dict[str, Any], options: Any, filename: str) -> tuple[Any, str]:
    """`scenic.syntax.translator.compileStream`, with the code of a text it has seen taken from memory."""
    veneer.activate(options, namespace)
    try:
        exec(compile(translator.preamble, "<veneer>", "exec"), namespace)  # noqa: S102 - Scenic's own preamble
        namespace[translator.namespaceReference] = namespace
        source = stream.read()
        key = (hashlib.blake2b(source, digest_size=16).digest(), str(filename))
        if key not in _code:
            of_library = any(folder in Path(filename).parents for folder in _LIBRARY)
            _code[key] = _kept(source.decode("utf-8"), filename, "code" if of_library else "programs")
        code, requirements, digest = _code[key]
        translator.executeCodeIn(code, namespace)
        translator.storeScenarioStateIn(namespace, requirements, digest, options)
    finally:
        veneer.deactivate()
    return code, ""


def _kept(source: str, filename: str, kind: Literal["code", "programs"] = "code") -> tuple[Any, Any, bytes]:
    """`_translate` for a text whose code is kept between processes: that of the library, and programs."""
    if not keeping or (folder := only_mine(cache_folder(kind))) is None:
        return _translate(source, filename)
    named = hashlib.blake2b(repr((source, str(filename))).encode() + _translator(), digest_size=16)
    path = folder / named.hexdigest()
    if (content := kept(path)) is not None:  # `marshal` may break the interpreter with what is damaged
        code, digest = marshal.loads(content)
        return code, [], digest
    code, requirements, digest = _translate(source, filename)
    if isinstance(code, CodeType) and not requirements:  # these are trees, which `marshal` does not know
        keep(path, sealed(marshal.dumps((code, digest))), lasting=False)
        if kind == "programs":
            keep_latest(folder, PROGRAMS)
    return code, requirements, digest


@cache
def _translator() -> bytes:
    """What code depends on besides its text: Python and its options, Scenic, and what is done to syntax trees here."""
    ranges = sys._xoptions.get("no_debug_ranges")  # pyright: ignore[reportPrivateUsage] - Python has no other name
    options = f"{sys.flags.optimize} {ranges}"
    of_ours = b"".join(Path(one).read_bytes() for one in (searched.__file__, __file__))
    return MAGIC_NUMBER + f"{installed('scenic')} {options}".encode() + of_ours


def _translate(source: str, filename: str) -> tuple[Any, Any, bytes]:
    """Scenic text to Python code, its requirements, and the hash by which Scenic tells programs apart."""
    parsed: Any
    try:
        parsed = _parsed(source, filename)
    except ScenicError:
        raise
    except Exception as error:  # a parser that loses its way in a faulty text may raise anything
        raise DoesNotCompile(
            f"Scenic's parser breaks off in {filename} with {type(error).__name__}: {error}; look for an unclosed "
            "bracket or quote, and for an empty line within brackets; chatscene library lint says which snippet it is"
        ) from error
    searched.make_searchable(parsed)
    tree: Any
    tree, requirements = translator.compileScenicAST(parsed, filename=filename)
    digest = hashlib.blake2b(ast.dump(tree).encode(), digest_size=4).digest()
    return translator.compileTranslatedTree(tree, filename), requirements, digest


def _parsed(source: str, filename: str) -> Any:
    """`scenic.syntax.parser.parse_string`, with the parts of a program that were parsed before taken from memory.

    Programs are joined from parts below `## part` lines, so that the next has most in common with those before; to
    parse is most of what is left of a compilation. Where a line that looks like one stands within a statement, the
    pieces do not parse, and the whole is.
    """
    quicken()
    first, *parts = source.split("\n## ")
    try:
        pieces = [_part(first + "\n"), *(_part(f"## {part}\n") for part in parts)] if parts else []
    except (ChatSceneError, MemoryError):  # its time is up
        raise
    except Exception:  # noqa: BLE001 - whatever it is, the whole says it with its lines
        pieces = []
    if not pieces:
        return translator.parse_string(source, "exec", filename=filename)
    statements: list[ast.stmt] = []
    lines = 0
    for text, piece in zip((first, *parts), pieces, strict=True):
        statements += ast.increment_lineno(_copied(piece), lines).body
        lines += text.count("\n") + 1
    return ast.Module(body=statements, type_ignores=[])


@lru_cache(maxsize=1024)
def _part(text: str) -> Any:
    return translator.parse_string(text, "exec")


def _copied(node: Any) -> Any:
    """A syntax tree of its own; `copy.deepcopy` does not know how to make Scenic's nodes."""
    if isinstance(node, list | tuple):
        return type(node)(_copied(one) for one in node)
    if not isinstance(node, ast.AST):
        return node
    copied = type(node).__new__(type(node))
    vars(copied).update((name, _copied(value)) for name, value in vars(node).items())
    return copied


def _resolve_once(default: Any, name: str, overridden: Sequence[Any]) -> Any:
    """`PropertyDefault.resolveFor`, which gives the same for every class that inherits a default, once for all of them.

    A class of the world model has some fifty properties and states four. To resolve all of them anew for each of its
    classes was most of the time that a program took once it was parsed, and more to free again.
    """
    if default.isAdditive or any(one.isFinal for one in overridden):
        return _resolve(default, name, overridden)
    known = vars(default).setdefault("_chatscene_resolved", {})
    if name not in known:
        known[name] = _resolve(default, name, ())
    return known[name]


_default: Any = PropertyDefault
_resolve: Any = PropertyDefault.resolveFor


@contextmanager
def _namespace(path: str | None = None) -> Generator[dict[str, Any]]:
    """`scenic.syntax.translator.topLevelNamespace`, which leaves `sys.path` alone.

    Scenic puts the working folder first while it compiles. Whatever a package imports only then, such as `colorsys`,
    would come from there, and a folder may be anybody's.
    """
    _names.append({"__name__": "__main__"} | ({"__file__": path} if path is not None else {}))
    yield _names[-1]


class _LoadedModel:
    """A world model as it was executed for one program, to be used by the next that would come to the same.

    Scenic executes it anew for each program, since it may depend on parameters: forty classes, each of fifty
    properties, which is most of what a compilation makes and of what is thrown away with a program.

    Args:
        given: The parameters that were there before it was loaded.
    """

    def __init__(self, given: Mapping[str, Any]) -> None:
        self._modules = {name: one for name, one in sys.modules.items() if isinstance(one, translator.ScenicModule)}
        self._stated = {name: value for name, value in _parameters().items() if name not in given}
        self._simulator = veneer.simulatorFactory
        for module in self._modules.values():  # else they hold on to all that the program states from here on
            module._scenario._bindGlobals(dict(_parameters()))

    def take_up(self, name: str) -> None:
        """Have it loaded in the program that is being compiled, as if it had been executed; Scenic unloads it."""
        for full, module in self._modules.items():
            package, _, own = full.rpartition(".")
            setattr(sys.modules[package], own, module)
            sys.modules[full] = module
        stated: dict[str, Any] = {one: value for one, value in self._stated.items() if one not in _parameters()}
        _parameters().update(stated)
        _veneer.simulatorFactory = self._simulator
        _veneer.currentScenario._inherit(self._modules[name]._scenario)


MODELS = 4  # that are kept loaded per process: one for each map and each set of parameters that stand before it
_models: OrderedDict[tuple[object, ...], _LoadedModel] = OrderedDict()
_shared: ContextVar[tuple[object, ...]] = ContextVar("shared", default=())
"""What programs have in common that may use one world model; empty for a program that has its own."""


def _parameters() -> dict[str, Any]:
    """The parameters of the program that is being compiled, as Scenic has them."""
    return _veneer._globalParameters


def _load_model(namespace: dict[str, Any], name: str) -> None:
    """`scenic.syntax.veneer.model`, which takes up a world model that was loaded for such a program before."""
    given, shared = dict(_parameters()), _shared.get()
    told = sorted((one, repr(value)) for one, value in given.items() if one != "route")
    key = (*shared, name, *told)
    if not shared or veneer.activity != 1:
        _model(namespace, name)
    elif (loaded := _models.get(key)) is not None:
        loaded.take_up(name)
        _model(namespace, name)
    else:
        _model(namespace, name)
        _models[key] = _LoadedModel(given)
        while len(_models) > MODELS:
            _models.popitem(last=False)


_veneer: Any = veneer
_model: Any = veneer.model


def _extend_scenic() -> None:
    translator.compileStream = _compile_stream
    veneer.model = _load_model
    translator.topLevelNamespace = _namespace
    install_network_memo()
    if _default.resolveFor is _resolve_once:
        return
    _default.resolveFor = _resolve_once
    for each in vars(object_types).values():  # values that Scenic states become defaults, which can be known again
        stated: dict[str, Any] = vars(each).get("_scenic_properties", {}) if isinstance(each, type) else {}
        stated.update({name: PropertyDefault.forValue(value) for name, value in stated.items()})


@contextmanager
def _without_collecting() -> Generator[None]:
    """Let the garbage collector rest.

    A compilation makes many objects and drops few, and half its time would go into looking through map and library.
    """
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


@contextmanager
def _sharing(what: tuple[object, ...]) -> Generator[None]:
    token = _shared.set(what)
    try:
        yield
    finally:
        _shared.reset(token)


def compile_program(
    source: str,
    *,
    map_path: Path,
    route: int,
    filename: str = "<program>",
    called: str = "",
    model: str = OWN_MODEL,
    own: bool = False,
) -> Any:
    """Compile a program for one route of one map. A session that is open in this process is ended.

    Args:
        source: Scenic text.
        map_path: The map.
        route: Which of the routes that its geometry asks for.
        filename: What Scenic calls the text.
        called: What error messages call it; empty for the same.
        model: The world model that it is written for; ours that stands in for it is loaded.
        own: Whether it is of a user's own, whose code may do anything to the world model that it has; another one has
            that of the program before, if that comes to the same.

    Returns:
        Scenic's scenario; its `names` are those of the program that are drawn; none of one for our own model.

    Raises:
        DoesNotCompile: With Scenic's message and the line.
        MapError: The map has no such route.
    """
    free_process()  # else Scenic stops half-way, and counts a compilation ever after that none can go beside
    _extend_scenic()
    parameters: Mapping[str, Any] = {"map": str(map_path), "route": route}
    shared = () if own or model != OWN_MODEL else (map_digest(map_path),)
    try:
        with _without_collecting(), _sharing(shared):
            _names.clear()
            scenario = translator.scenarioFromString(
                source, filename=filename, params=parameters, model=STANDS_IN[model], mode2D=True
            )
            drawn = {} if model == OWN_MODEL else {n: one for n, one in _names[-1].items() if needsSampling(one)}
            _names.clear()
            setattr(scenario, "names", drawn)  # noqa: B010 - a class of somebody else's
            return scenario
    except (ChatSceneError, MemoryError):
        raise
    except ScenicError as error:
        line = getattr(error, "lineno", None)
        file = getattr(error, "filename", None) or filename
        where = f"line {line} of {called if called and file == filename else file}" if line else called or filename
        place = place_in(error, filename)
        shown = f"\n{pointed(source, place)}" if place else ""
        raise DoesNotCompile(f"Scenic refuses {where}: {error}{shown}".rstrip()) from error
    except Exception as error:  # the program's own code, which may raise anything
        why = fault(error, filename, source)
        raise DoesNotCompile(f"{called or filename} fails while it is set up: {why}") from error
