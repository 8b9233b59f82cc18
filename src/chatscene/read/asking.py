"""Step 2 of 9 by a language model: the same slots, filled by whoever the user has configured.

Paper: section 3.3, step ii, and its appendix on prompts (whose words are not used here). The reference asks for three
texts and retrieves with them; here the model fills the typed slots that the offline reader fills, so that everything
after it is the same.
"""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

from pydantic import BaseModel, ConfigDict, Field

from chatscene.errors import LanguageModelError
from chatscene.models.language.protocol import Example, LanguageModel, Prompt
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import concluded
from chatscene.terms.frame import About, Frame, Note, certain
from chatscene.terms.scenario import Control, Distance, EgoState, Maneuver, Occluder, Place, Position, Side, Slots, Why


class Decomposition(BaseModel):
    """What a model is asked for: the slots, and what the adversary does in a few words."""

    model_config = ConfigDict(extra="forbid")

    behavior: str = Field(description="what the adversary does, in a few words", max_length=300)
    adversary: AdversaryKind | None
    actions: list[Action] = Field(max_length=6)
    side: Side | None
    position: Position | None
    occluder: Occluder | None
    maneuver: Maneuver | None
    place: Place | None
    control: Control | None
    leader: bool
    blocker: bool
    distance: Distance | None
    group: bool
    lanes: int | None = Field(ge=1, le=3)
    two_way: bool | None
    ego: EgoState | None


SYSTEM = f"""You read descriptions of dangerous traffic situations for a driving simulator and fill in a form.
The ego (also: we, our car, the vehicle under test, vehicle 1) is the car that is tested. The adversary is the road
user who endangers it. Fill in only what the text says or what follows from it; use null, false or an empty list for
everything else. Sides are the ego's own left and right.
actions: what the adversary does, in order, never what the ego does.
position: ahead (in the ego's lane), roadside (beside the road, on foot or two wheels), beside, ahead-beside, behind,
behind-beside (neighbouring lanes), oncoming, crossing (on a side arm of a junction), far-corner (at the road that the
ego turns into), kerb (a vehicle standing at the edge of the road).
maneuver: what the ego does; bypass means around something parked in its lane, through the opposite lane.
ego: what the ego does at the pedals, if the text says so: stands (at a red light, in a queue, broken down), sets-off
(from standing), slow (all the time), slows-down, brakes (hard), stops; never how it reacts to the adversary.
leader: a slow vehicle drives ahead of the ego, besides the adversary. blocker: something is parked in the ego's lane.
Words for actions: {", ".join(Action)}."""


def _form(behavior: str, **slots: Any) -> str:
    blank: dict[str, Any] = {
        "adversary": None, "actions": [], "side": None, "position": None, "occluder": None, "maneuver": None,
        "place": None, "control": None, "leader": False, "blocker": False, "distance": None, "group": False,
        "lanes": None, "two_way": None, "ego": None,
    }  # fmt: skip
    return json.dumps({"behavior": behavior} | blank | slots)


EXAMPLES = (
    Example(
        "A child runs out from behind a parked van on our right and freezes in the lane.",
        _form("the child runs across the road and stops", adversary="pedestrian",
              actions=["cross", "accelerate", "stop"], side="right", position="roadside", occluder="parked-car"),
    ),
    Example(
        "Ego turning left at signalised crossroads, oncoming lorry does not slow down but accelerates.",
        _form("the truck accelerates into the junction", adversary="truck", actions=["accelerate"],
              position="oncoming", maneuver="left-turn", place="four-way", control="signal"),
    ),
    Example(
        "We want to overtake a slow tractor and move to the left lane; a taxi alongside keeps level with us.",
        _form("the car keeps level with the ego", adversary="car", actions=["pace"], position="beside",
              maneuver="lane-change-left", place="road", leader=True),
    ),
    Example(
        "While I go around a broken-down car in my lane, a motorcycle comes towards me and swerves.",
        _form("the motorcycle swerves", adversary="motorcycle", actions=["oncoming", "swerve"], position="oncoming",
              maneuver="bypass", place="road", blocker=True),
    ),
    Example(
        "Vehicle 1 was proceeding straight through the intersection on green when an ambulance from the left entered "
        "against the red and came to rest in the middle.",
        _form("the ambulance runs the red light and stops", adversary="emergency-vehicle",
              actions=["run-light", "stop"], side="left", position="crossing", maneuver="straight", place="junction",
              control="signal"),
    ),
    Example(
        "I was stationary at the lights when a van came up from behind and did not stop.",
        _form("the van drives on into the ego", adversary="car", actions=["follow"], position="behind",
              place="junction", control="signal", ego="stands"),
    ),
    Example("bus ahead of us brakes hard", _form("the bus brakes hard", adversary="bus", actions=["brake"],
                                                 position="ahead")),
)  # fmt: skip


def ask(model: LanguageModel, frame: Frame) -> Frame:
    """Fill the slots of a sentence by asking a language model.

    Args:
        model: Who is asked.
        frame: The sentence as our own reader read it; the answer where the model gives none.

    Returns:
        The frame, in which the model's facts are sure; its notes say who read it, and where the two readers differ.
    """
    try:
        form = model.reply(Prompt(system=SYSTEM, examples=EXAMPLES, text=frame.text), Decomposition).answer
    except LanguageModelError as error:
        return replace(frame, notes=(*frame.notes, Note(about=About.OFFLINE, said=(str(error),))))
    slots = concluded(
        Slots(
            **form.model_dump(exclude={"behavior", "actions", "leader", "blocker", "group"}),
            actions=tuple(dict.fromkeys(form.actions)),
            leader=form.leader or None,
            blocker=form.blocker or None,
            group=form.group or None,
            site=frame.outright.site,  # which the form does not ask for
        )
    )
    differ = [
        Note(about=About.DIFFERENT, said=(name, model.name, str(new), "the offline reader", str(old)))
        for name, new in slots.said().items()
        if (old := frame.beliefs.likeliest(name)) not in (None, new)
    ]
    return replace(
        frame,
        clauses=replace(frame.clauses, adversary=form.behavior.strip() or frame.clauses.adversary),
        outright=slots,
        beliefs=certain(slots, frame.beliefs),
        unused=tuple(one for one in frame.unused if one.why not in (Why.WORDS, Why.LANGUAGE)),  # it knows more
        notes=(Note(about=About.READER, said=(model.name,)), *differ),
        reader=model.name,
        whole=False,
    )
