"""What was built otherwise than it was read is told."""

from dataclasses import replace

from chatscene.interpret.otherwise import otherwise
from chatscene.report.accounting import told_first
from chatscene.report.sections import heading
from chatscene.report.understood import Understood, understand
from chatscene.runs import asked_run
from chatscene.runs.record import SituationRecord
from chatscene.terms.acts import Action
from chatscene.terms.snippet import Tried
from fake_run import asked

UNREAD = "a van ahead of us brakes hard because of a xylophone"


def told(understood: Understood) -> list[str]:
    return told_first(understood.as_dict())


def test_where_everything_is_as_it_was_said_nothing_is_told() -> None:
    assert told(understand("a car ahead brakes hard")) == []


def test_a_road_user_that_is_shown_as_another_kind_is_told_and_words_that_were_not_read_come_first() -> None:
    lines = told(understand(UNREAD))
    assert lines == ["not understood, so possibly missing from the scenes: 'xylophone'", "'a van' is shown as a car"]


def test_what_was_chosen_after_a_better_choice_failed_is_told_with_all_that_it_adds() -> None:
    understood = understand("a car ahead brakes hard")
    scenario, retrieval = understood.scenario, understood.retrieval
    assert retrieval is not None
    tried = (Tried(snippet_ids=("behavior/another-brake",), reason="it never brakes"),)
    match = retrieval.behavior
    slots = replace(match.snippet.slots, actions=(Action.BRAKE, Action.SWERVE), leader=True)
    behavior = replace(match, snippet=replace(match.snippet, slots=slots))
    lines = otherwise(scenario, replace(retrieval, behavior=behavior, tried=tried), [])
    assert lines[0].startswith("instead of behavior/another-brake, which no drive showed, behavior/lane-brake: ")
    assert lines[1:] == ("added: the adversary leaves its line once, abruptly", "added: a slow vehicle ahead")
    slots = replace(slots, actions=(Action.SWERVE,), leader=None)
    behavior = replace(match, snippet=replace(match.snippet, slots=slots))
    assert otherwise(scenario, replace(retrieval, behavior=behavior), []) == ("instead of brake: swerve",)


def test_an_act_that_comes_along_without_a_word_is_not_an_addition() -> None:
    assert told(understand("a van cuts in")) == ["'a van' is shown as a car"]


def test_the_head_of_the_page_tells_it_before_what_was_read() -> None:
    page = heading(asked_run(UNREAD), understand(UNREAD).as_dict(), "")
    assert page.index("possibly missing from the scenes") < page.index("is shown as a car") < page.index("Read as")


def test_a_contact_that_was_said_and_never_comes_is_told() -> None:
    hit = "contact: {}\nothers: [{id: A, kind: car, starts: {where: ahead}, does: [{act: brake}]}]"
    for text, collided, right in ((hit, 0, True), (hit, 1, False), (hit.removeprefix("contact: {}\n"), 0, False)):
        record = asked(situation=SituationRecord(name="it", text=text), counts={"ran": 4, "collided": collided})
        assert bool(told_first({}, record)) is right
