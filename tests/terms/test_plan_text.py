"""Behaviors are plans: their text is read into data and printed again as it was."""

from __future__ import annotations

import ast
import contextlib
import keyword
import re
from collections import Counter
from dataclasses import replace
from functools import cache
from importlib.resources import files
from pathlib import Path

import pytest
from click.testing import CliRunner
from hypothesis import example, given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from chatscene.commands.main import main
from chatscene.errors import SnippetError
from chatscene.grow.twins import may_look_alike, same_plan, without_names
from chatscene.library.load import load_library
from chatscene.library.plan_check import acts_of, check_plan, names_read
from chatscene.library.plan_words import describe_plan
from chatscene.terms.acts import Action
from chatscene.terms.plan import (
    FUNCTIONS,
    PRIMITIVES,
    After,
    AnyOf,
    Arithmetic,
    Boolean,
    Call,
    Comparison,
    Conditional,
    Expression,
    Foreign,
    Kind,
    Name,
    Negation,
    Not,
    Number,
    Parameter,
    Phase,
    Plan,
    Range,
    Text,
    Texts,
    Until,
    Value,
    expressions_of,
    walk,
)
from chatscene.terms.plan_text import BEHAVIOR, parse_plan, plan_of, print_plan
from chatscene.terms.scenario import Component
from chatscene.terms.snippet import ParameterRange, Snippet

CROSSES = """\
param OPT_ADV_SPEED = Range(0.8, 4)
behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < 20
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
"""


def bare(source: str) -> str:
    """A text without comments and blank lines."""
    lines = (re.sub(r"\s*#.*", "", line) for line in source.splitlines())
    return "".join(f"{line}\n" for line in lines if line.strip())


def behaviors() -> tuple[Snippet, ...]:
    return load_library().of(Component.BEHAVIOR)


# Plans at random

names = st.from_regex(r"[a-z][a-zA-Z]{3,8}", fullmatch=True).filter(lambda name: not keyword.iskeyword(name))
numbers = st.integers(-99, 99) | st.floats(-99, 99).map(lambda number: round(number, 3))
opt = st.from_regex(r"OPT_[A-Z]{1,6}", fullmatch=True)


@cache
def expressions(kind: Kind, depth: int = 2) -> SearchStrategy[Expression]:
    leaves: list[SearchStrategy[Expression]] = [] if kind is Kind.TRUTH else [names.map(lambda n: Name(n, kind))]
    if kind is Kind.NUMBER:
        leaves += [numbers.map(Number), opt.map(Parameter)]
    if kind is Kind.TEXT:
        leaves = [st.text(max_size=5).map(Text)]
    if kind is Kind.ACTORS:
        leaves.append(st.just(Call("others", ())))
    if kind is Kind.TRUTH:
        leaves.append(names.map(lambda n: Comparison(Name(n, Kind.TEXT), (("==", Text("red")),))))
    if not depth:
        return st.one_of(leaves)
    number, truth = (
        st.deferred(lambda: expressions(Kind.NUMBER, depth - 1)),
        st.deferred(lambda: expressions(Kind.TRUTH, depth - 1)),
    )
    if kind is Kind.NUMBER:
        positive = number.filter(lambda e: not isinstance(e, Number))
        leaves += [
            positive.map(Negation),
            st.builds(Arithmetic, st.sampled_from("+-*/"), number, number),  # pyright: ignore[reportArgumentType]
            st.builds(Conditional, truth, number, number),
            st.tuples(number, number, number).map(lambda three: Call("max", three)),
        ]
    if kind is Kind.TRUTH:
        relation = st.sampled_from(["<", "<=", ">", ">=", "==", "!="])
        links = st.lists(st.tuples(relation, number), min_size=1, max_size=2).map(tuple)
        leaves += [
            truth.map(Not),
            st.builds(Comparison, number, links),  # pyright: ignore[reportArgumentType]
            st.builds(
                Boolean,
                st.sampled_from(["and", "or"]),  # pyright: ignore[reportArgumentType]
                st.lists(truth, min_size=2, max_size=3).map(tuple),
            ),
            st.builds(AnyOf, names, expressions(Kind.ACTORS, 0), truth),
        ]
    leaves += [
        st.tuples(*(expressions(k, depth - 1) for k in function.takes)).map(lambda args, f=function: Call(f.name, args))
        for function in FUNCTIONS.values()
        if function.gives is kind and function.takes
    ]
    return st.one_of(leaves)


@st.composite
def phases(draw: st.DrawFn, values: SearchStrategy[tuple[Value, ...]]) -> Phase:
    primitive = draw(st.sampled_from(list(PRIMITIVES.values())))
    least = sum(argument.default is None for argument in primitive.takes)
    told = primitive.takes[: draw(st.integers(least, len(primitive.takes)))]
    ends = expressions(Kind.TRUTH).map(Until) | expressions(Kind.NUMBER).map(After)
    return Phase(
        primitive.name,
        tuple(draw(expressions(argument.kind, 1)) for argument in told),
        draw(st.none() | ends),
        draw(values),
    )


local = st.builds(Value, names, expressions(Kind.NUMBER, 1))
texts = st.lists(st.text(max_size=5), min_size=2, max_size=3).map(tuple).map(Texts)
constants = st.builds(Value, names, expressions(Kind.NUMBER, 1) | expressions(Kind.TEXT, 0) | texts)


@st.composite
def plans(draw: st.DrawFn) -> Plan:
    some = draw(st.lists(phases(st.lists(local, max_size=1).map(tuple)), min_size=1, max_size=3))
    return Plan(
        phases=tuple(some),
        parameters=tuple(draw(st.lists(st.builds(Range, opt, numbers, numbers), max_size=2))),
        constants=tuple(draw(st.lists(constants, max_size=2))),
        loop=draw(st.none() | st.integers(0, len(some) - 1)),
    )


# What holds


def test_every_packaged_behavior_is_printed_again_as_it_is_written() -> None:
    for behavior in behaviors():
        plan = plan_of(behavior)
        assert isinstance(plan, Plan), f"{behavior.id}: {plan.reason}"
        assert print_plan(plan) == bare(behavior.source), behavior.id


@settings(max_examples=30)
@given(plan=plans())
def test_a_plan_is_read_from_what_it_is_printed_as(plan: Plan) -> None:
    text = print_plan(plan)
    assert parse_plan(text) == plan
    assert print_plan(parse_plan(text)) == text


@example(text="\r0")  # a line end that is none, before a number
@given(
    text=st.text() | st.text(alphabet="do Halt()\n:,=\"'[]<>1.-#\\uforsecnd").map(lambda words: f"{CROSSES}    {words}")
)
def test_a_text_is_a_plan_or_refused_whatever_it_holds(text: str) -> None:
    with contextlib.suppress(SnippetError):
        parse_plan(text)


def test_half_a_character_is_refused_with_its_line() -> None:
    with pytest.raises(SnippetError, match=r"^line 2: "):
        parse_plan("# a plan\nparam OPT_SPEED = '\ud800'\n")


@pytest.mark.parametrize("what", ["(", "-", "not "])
def test_too_many_brackets_are_refused(what: str) -> None:
    nested = CROSSES.replace("20", what * 5000 + "20" + ")" * (5000 if what == "(" else 0))
    with pytest.raises(SnippetError):
        parse_plan(nested)


def test_the_primitives_are_the_behaviors_of_the_world_model() -> None:
    world = (files("chatscene.world") / "behaviors.scenic").read_text(encoding="utf-8")
    defined = {
        name: [argument.arg for argument in ast.parse(f"def {name}({takes}): pass").body[0].args.args]  # pyright: ignore
        for name, takes in re.findall(r"^behavior (\w+)\((.*)\):", world, re.MULTILINE)
    }
    del defined["FollowLaneBehavior"]  # Scenic's, for programs of others
    assert {name: [a.name for a in p.takes] for name, p in PRIMITIVES.items()} == defined
    signature = {
        name: ", ".join(a.name if a.default is None else f"{a.name}={a.default}" for a in p.takes)
        for name, p in PRIMITIVES.items()
    }
    assert all(f"behavior {name}({takes}):" in world for name, takes in signature.items())


def test_all_that_a_plan_can_say_is_said_somewhere_in_the_library() -> None:
    said = {
        part.function
        for behavior in behaviors()
        if isinstance(plan := plan_of(behavior), Plan)
        for phase in plan.phases
        for expression in expressions_of(phase)
        for part in walk(expression)
        if isinstance(part, Call)
    }
    assert set(FUNCTIONS) == said | {"secondsTo", "onward", "exitAt"}  # which what is built of situations says


def test_comments_and_lines_within_brackets_change_nothing() -> None:
    spread = CROSSES.replace("ego, self)", "ego,  # who comes\n\n  self)").replace("behavior", "# so\n\nbehavior")
    assert parse_plan(spread) == parse_plan(CROSSES)


def test_what_is_left_out_has_the_default_of_its_primitive() -> None:
    paced = "behavior AdvBehavior():\n    do PaceOnPath(advLane, ego, least=3)\n"
    (phase,) = parse_plan(paced).phases
    assert (phase.argument("ahead"), phase.argument("top"), phase.argument("least")) == (
        Number(0),
        Number(25),
        Number(3),
    )
    assert print_plan(parse_plan(paced)) == paced.replace("least=3", "0, 25, 3")


def test_a_name_is_known_by_what_it_must_stand_for() -> None:
    (waits, _) = parse_plan(CROSSES).phases
    assert waits.end == Until(
        Comparison(
            Call("headway", (Name("egoRoute", Kind.PATH), Name("ego", Kind.ACTOR), Name("self", Kind.ACTOR))),
            (("<", Number(20)),),
        )
    )


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("do Halt", "do Hault", "line 3: no plan can do 'Hault'; it can do Halt"),
        ("do Halt", "take Halt", "line 3: 'take Halt ( )"),
        ("MoveAhead(globalParameters.OPT_ADV_SPEED)", "MoveAhead()", "line 4: MoveAhead must be told its speed"),
        ("OPT_ADV_SPEED)", "OPT_ADV_SPEED, 1, 2)", "line 4: MoveAhead takes (speed, turn), each once"),
        ("OPT_ADV_SPEED)", "OPT_ADV_SPEED, pace=2)", "line 4: MoveAhead takes (speed, turn), each once"),
        ("OPT_ADV_SPEED)", "OPT_ADV_SPEED, 0 < 1)", "line 4: '0 < 1' is a truth, where a number is needed"),
        ("< 20", "+ 20", "line 3: 'headway(egoRoute, ego, self) + 20' is a number, where a truth is needed"),
        ("< 20", "<", "line 3: 'headway ( egoRoute , ego , self ) <' is not an expression"),
        ("headway(", "distance(", "line 3: no plan can say 'distance(egoRoute, ego, self)'"),
        ("Range(0.8, 4)", "Uniform(1, 2)", "line 1: 'param OPT_ADV_SPEED = Uniform ( 1 , 2 )'"),
        ("    do Move", "    while True:\n        do Halt()\n    do Move", "line 6: "),
        (CROSSES, "import os\n", "line 1: 'import os'"),
        ("AdvBehavior", "Other", "line 2: "),
        ("    do Halt", "  start = 1\n    do Halt", "line 4: "),
    ],
)  # fmt: skip
def test_what_no_plan_can_say_is_named_with_its_line(old: str, new: str, said: str) -> None:
    assert old in CROSSES
    with pytest.raises(SnippetError, match=re.escape(said)):
        parse_plan(CROSSES.replace(old, new, 1))


def test_a_behavior_that_is_no_plan_is_foreign_and_says_why() -> None:
    snippet = replace(behaviors()[0], source="behavior AdvBehavior():\n    take DriveAction(0, 1, 0)\n")
    assert plan_of(snippet) == Foreign(
        "line 2: 'take DriveAction ( 0 , 1 , 0 )': a plan knows `do …`, `name = …` before that, "
        "and one loop `while True:`"
    )
    geometry = load_library().of(Component.GEOMETRY)[0]
    assert isinstance(plan_of(geometry), Foreign)


def test_an_empty_behavior_is_no_plan() -> None:
    for ending in ("", "    while True:\n", "    start = 1\n"):
        with pytest.raises(SnippetError, match="without anything to do"):
            parse_plan(f"behavior {BEHAVIOR}():\n{ending}")


# What is seen without a drive


def packaged_plans() -> list[tuple[Snippet, Plan]]:
    return [(behavior, plan) for behavior in behaviors() if isinstance(plan := plan_of(behavior), Plan)]


def with_halt(line: str) -> Plan:
    """The plan of `CROSSES` with another first phase."""
    return parse_plan(CROSSES.replace("do Halt() until headway(egoRoute, ego, self) < 20", line))


SPEED = ParameterRange(name="OPT_ADV_SPEED", low=0.8, high=4, unit="m/s")


def test_no_packaged_plan_has_a_fault_and_each_says_of_itself_what_it_shows() -> None:
    for behavior, plan in packaged_plans():
        assert list(check_plan(plan, behavior.parameters)) == [], behavior.id
        claimed = {action: action in behavior.slots.actions for action in acts_of(plan)}
        assert acts_of(plan) == claimed, behavior.id


def test_what_a_plan_reads_is_what_its_snippet_requires() -> None:
    for behavior, plan in packaged_plans():
        own = {"self", "ego", *(value.name for phase in plan.phases for value in phase.values)}
        asked = {part.actor for phase in plan.phases for e in expressions_of(phase) for part in walk(e)
                 if isinstance(part, AnyOf)}  # fmt: skip
        assert names_read(plan.phases) - own - asked == set(behavior.requires) - {"ego"}, behavior.id
        assert {constant.name for constant in plan.constants} == set(behavior.provides) - {BEHAVIOR}, behavior.id


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("do Halt()", "phase 1, Halt, never ends, so nothing after it is ever done"),
        ('do Halt() until crossSignal == "red"', "phase 1, Halt, ends at once or never"),
        (
            "do Halt() for headway(egoRoute, ego, self) seconds",
            "phase 1, Halt: 'headway(egoRoute, ego, self)' is no sec",
        ),
        ("do MoveAhead(gap(self, ego)) for 2 seconds", "'gap(self, ego)' is no speed [m/s]"),
        ("do Halt() until gap(self, ego) < self.pose[3]", "'gap(self, ego) < self.pose[3]' takes one measure for anot"),
        ("do Halt() for gap(self, ego) - globalParameters.OPT_ADV_SPEED seconds", "takes one measure for another"),
        ("do Halt() for globalParameters.OPT_TIME seconds", "OPT_TIME is read and not declared"),
        ("side = 1\n    do Halt() for 2 seconds", "nothing uses the value side"),
    ],
)
def test_a_fault_of_a_plan_is_named(line: str, said: str) -> None:
    (fault,) = check_plan(with_halt(line), (SPEED,))
    assert said in fault


@pytest.mark.parametrize(
    "line",
    [
        "do Halt() for gap(self, ego) / globalParameters.OPT_ADV_SPEED seconds",
        "do Halt() until gap(self, ego) < 3 * globalParameters.OPT_ADV_SPEED",
        "do TurnOff(1.5, 4)",
    ],
)
def test_measures_that_fit_are_no_fault(line: str) -> None:
    assert list(check_plan(with_halt(line), (SPEED,))) == []


def test_a_parameter_that_no_phase_reads_is_a_fault() -> None:
    idle = parse_plan(CROSSES.replace("globalParameters.OPT_ADV_SPEED", "2"))
    assert list(check_plan(idle, (SPEED,))) == ["OPT_ADV_SPEED changes nothing, no phase reads it"]


def test_a_loop_whose_last_phase_never_ends_is_a_fault() -> None:
    looped = "behavior AdvBehavior():\n    while True:\n        do MoveAhead(2) for 1 seconds\n        do Halt()\n"
    assert list(check_plan(parse_plan(looped), ())) == ["phase 2, Halt, never ends, so nothing after it is ever done"]


@pytest.mark.parametrize(
    ("phases", "acts"),
    [
        (["MoveAhead(2)"], {Action.REVERSE: False, Action.STOP: False, Action.HESITATE: False}),
        (["MoveAhead(0) for 2 seconds", "Halt()"], {Action.REVERSE: False, Action.HESITATE: False}),
        (["MoveAhead(2) for 2 seconds", "Halt()"], {Action.REVERSE: False, Action.HESITATE: False}),
        (["MoveAhead(2) for 2 seconds", "Halt() for 1 seconds", "MoveAhead(2)"], {Action.REVERSE: False}),
        (["Halt() for 1 seconds", "ReverseStraight(2)"],
         {Action.REVERSE: True, Action.STOP: False, Action.HESITATE: False}),
    ],
)  # fmt: skip
def test_a_plan_says_of_itself_only_what_is_sure(phases: list[str], acts: dict[Action, bool]) -> None:
    text = "".join(f"    do {phase}\n" for phase in phases)
    assert acts_of(parse_plan(f"behavior AdvBehavior():\n{text}")) == acts


def test_a_turn_by_an_angle_is_to_its_side_or_round() -> None:
    for angle, act in ((1.5, Action.TURN_LEFT), (-1.5, Action.TURN_RIGHT), (3.1, Action.U_TURN), (-3, Action.U_TURN)):
        assert acts_of(with_halt(f"do TurnOff({angle}, 4)"))[act]


def test_a_plan_is_told_in_words_a_line_a_phase() -> None:
    library = load_library()
    assert describe_plan(parse_plan(library.get("behavior/lead-stop-and-go").source)) == (
        "1. keeps pace with the ego along its way, OPT_ADV_AHEAD + 6 * OPT_STOP_TIME m ahead, up to 16 m/s, at least "
        "at 5 m/s, until what the ego has left on the ego's route to the start of the manoeuvre is under "
        "OPT_ADV_DISTANCE and what the ego has left on the ego's route to be level with it is over 0.85 * "
        "(OPT_ADV_AHEAD + 6 * OPT_STOP_TIME)",
        "2. brakes along its way by OPT_BRAKE, until its speed is under 0.05",
        "3. stops and stands, for OPT_STOP_TIME s",
        "4. follows its way at OPT_ADV_SPEED m/s, for 2.5 s",
        "again from 2",
    )


def test_a_snippet_is_shown_with_its_plan_in_words_or_why_it_has_none(tmp_path: Path) -> None:
    shown = CliRunner().invoke(main, ["library", "show", "behavior/lead-stop-and-go"]).output
    assert "\nagain from 2\n" in shown
    source = load_library().get("behavior/lead-stop-and-go").source
    assert max(map(len, source.splitlines())) > 80
    assert source.strip() in shown, "no line of code is cut, however narrow the terminal"
    (tmp_path / "behavior").mkdir()
    foreign = '#: description = "It waits."\n\nbehavior AdvBehavior():\n    wait\n'
    (tmp_path / "behavior" / "waits.scenic").write_text(foreign, encoding="utf-8")
    own = CliRunner().invoke(main, ["library", "show", "behavior/waits", "--library", str(tmp_path)]).output
    assert "no plan: line 3: 'wait'" in own


@given(plan=plans())
@settings(max_examples=30)
def test_every_plan_can_be_told_and_checked(plan: Plan) -> None:
    assert len(describe_plan(plan)) >= len(plan.phases)
    list(check_plan(plan, ()))
    acts_of(plan)


# What two plans have in common


def test_plans_are_the_same_whatever_their_parameters_are_called() -> None:
    plan = parse_plan(CROSSES)
    assert same_plan(plan, parse_plan(CROSSES.replace("OPT_ADV_SPEED", "OPT_ADV_SPEED_IN_LANE")))
    assert same_plan(plan, parse_plan(CROSSES.replace("0.8", ".80")))
    assert not same_plan(plan, parse_plan(CROSSES.replace("0.8", "0.9")))
    assert not same_plan(plan, parse_plan(CROSSES.replace("< 20", "< 21")))
    assert not same_plan(plan, Foreign("line 1"))


def test_what_stops_and_goes_in_another_order_does_not_look_alike() -> None:
    waits = parse_plan(CROSSES)
    goes = with_halt("do MoveAhead(3) for 2 seconds")
    assert not may_look_alike(waits, goes)
    assert may_look_alike(waits, with_halt("do Park() for 3 seconds"))
    assert not may_look_alike(goes, with_halt("do MoveAhead(3) for 1 seconds\n    do Halt() for 1 seconds"))
    looped = """\
behavior AdvBehavior():
    while True:
        do MoveAhead(3) for 1 seconds
        do Halt() for 1 seconds
"""
    assert may_look_alike(goes, parse_plan(looped))
    assert may_look_alike(waits, Foreign("line 1"))


def test_no_two_packaged_plans_are_the_same() -> None:
    told = Counter((without_names(plan), snippet.slots.side) for snippet, plan in packaged_plans())
    assert not [plan for plan, count in told.items() if count > 1]
