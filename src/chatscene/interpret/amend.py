"""Step 3 again, for an edit: the facts at hand, but for those that it names, decided as those of a sentence are."""

from __future__ import annotations

from dataclasses import dataclass, replace

from chatscene.errors import EditRefused
from chatscene.interpret.decide import decide, trusted
from chatscene.read.edit import hear_edit
from chatscene.read.inflection import Form, conjugated, listed
from chatscene.settings import RetrievalSettings
from chatscene.terms.actors import Manner
from chatscene.terms.edit import Change, Edit, Facts, changes, with_edits
from chatscene.terms.frame import Clauses, Frame, certain
from chatscene.terms.scenario import Scenario, Slots


@dataclass(frozen=True, slots=True, kw_only=True)
class Amended:
    """A situation after an edit.

    Attributes:
        edit: What was to change.
        scenario: What was understood, with that changed.
        changes: Every fact that is another one now.
    """

    edit: Edit
    scenario: Scenario
    changes: tuple[Change, ...]

    def in_words(self) -> list[str]:
        """The changes, of which some follow from those that were named."""
        return [f"{one}{'' if one.fact in self.edit.named else ' (follows)'}" for one in self.changes]


def amended(scenario: Scenario, text: str, settings: RetrievalSettings) -> Amended:
    """Apply an edit: what it names changes, what follows from that follows, and all else stays as it was decided.

    Whoever edits has seen what was read, so that nothing of it is guessed any more.

    Args:
        scenario: What was understood so far.
        text: The edit.
        settings: Of the library that serves it.

    Raises:
        EditRefused: It was not understood, contradicts what stays, or changes nothing; or nobody read a sentence.
    """
    frame = scenario.frame
    if frame is None:
        raise EditRefused("only what was read from a sentence can be edited; this is a program of its own")
    facts = Facts.of(frame, scenario.slots)
    edit = hear_edit(text, facts)
    settled = replace(
        edit.facts.on(frame),
        text=with_edits(frame.text, [edit.text]),
        whole=True,
        sure=frame.sure if frame.whole else trusted(scenario, settings),
        account=None,
        mentions=(),
        unused=(*scenario.unused, *edit.unused),
        notes=scenario.notes,
    )
    after = decide(_told_anew(settled, scenario.slots), settings)
    return Amended(edit=edit, scenario=after, changes=changes(facts, Facts.of(settled, after.slots)))


def _told_anew(frame: Frame, before: Slots) -> Frame:
    """A frame that is sure of its facts; of which behavior was meant only where that one still may be."""
    beliefs = certain(frame.outright, frame.beliefs)
    if frame.outright.actions == before.actions:
        return replace(frame, beliefs=beliefs)
    does = _does(frame.outright)
    clauses = Clauses(whole=f"{frame.clauses.ego} {does}".strip(), ego=frame.clauses.ego, adversary=does)
    unmeant = dict.fromkeys(frame.beliefs.behaviors, 0.0)  # none more than another that does the same
    return replace(frame, beliefs=replace(beliefs, behaviors=unmeant, others={}), clauses=clauses)


def _does(slots: Slots) -> str:
    """What the adversary does, in plain words for the encoder."""
    kind = slots.adversary
    manner = Manner.DRIVES if kind is None else kind.row.manner
    own = [
        {Manner.WALKS: action.row.walks, Manner.RIDES: action.row.rides}.get(manner, "") or action.row.drives
        for action in slots.actions
    ]
    told = [conjugated(listed(phrases)[0], Form.SINGULAR) for phrases in own]
    plain = ", then ".join(one.replace(" {from}", "").replace("{egos}", "the ego's") for one in told)
    return f"the {'road user' if kind is None else kind.noun} {plain}".replace("{ego}", "the ego").replace(
        "{its}", "its"
    )
