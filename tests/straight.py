# ruff: noqa: E501 - elements stand in one line each
"""Small scenarios on a straight road, as parts that a test puts together: an ego at 50 m, A at 100 m, 10 m/s each."""

from __future__ import annotations

from pathlib import Path

import chatscene
from chatscene.imports.openscenario import Imported, read_openscenario
from chatscene.terms.episode import Track
from chatscene.verdict.story import Story

LENGTH = 1000  # [m]
CAR = '<Vehicle name="v" vehicleCategory="car"><BoundingBox><Center x="1.4" y="0" z="0.7"/><Dimensions width="2" length="4.5" height="1.5"/></BoundingBox>{}</Vehicle>'
LANE = '<lane id="{}" type="driving" level="false"><link/><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane>'
LINE = '<geometry s="{}" x="{}" y="{}" hdg="0" length="{}"><line/></geometry>'


def road(
    *, right: str = "", left: str = "", pieces: str = "", length: float = LENGTH, more: str = "", types: str = ""
) -> str:
    """An OpenDRIVE map of one road along x, with two lanes each way where nothing else is told."""
    left = left or "".join(LANE.format(i) for i in (2, 1))
    right = right or "".join(LANE.format(-i) for i in (1, 2))
    section = f'<laneSection s="0"><left>{left}</left><center><lane id="0" type="none" level="false"/></center><right>{right}</right></laneSection>'
    plan = pieces or LINE.format(0, 0, 0, length)
    return f'<OpenDRIVE><header revMajor="1" revMinor="6"/><road name="" length="{length}" id="1" junction="-1"><link/>{types}<planView>{plan}</planView><lanes>{section}{more}</lanes></road></OpenDRIVE>'


def lane(s: float, number: int = -1) -> str:
    """A place in a lane."""
    return f'<LanePosition roadId="1" laneId="{number}" s="{s}"/>'


def put(where: str) -> str:
    """An action that puts somebody somewhere."""
    return f"<TeleportAction><Position>{where}</Position></TeleportAction>"


def speed(value: object, shape: str = "step", dimension: str = "time", amount: float = 0) -> str:
    """An action that brings somebody to a speed."""
    return f'<LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="{shape}" dynamicsDimension="{dimension}" value="{amount}"/><SpeedActionTarget><AbsoluteTargetSpeed value="{value}"/></SpeedActionTarget></SpeedAction></LongitudinalAction>'


def first(who: str, *actions: str) -> str:
    """What somebody does in Init."""
    return f'<Private entityRef="{who}">{"".join(f"<PrivateAction>{one}</PrivateAction>" for one in actions)}</Private>'


def time(value: object, rule: str = "greaterThan") -> str:
    """A time of the clock."""
    return f'<ByValueCondition><SimulationTimeCondition value="{value}" rule="{rule}"/></ByValueCondition>'


def parameter(name: str, value: object, rule: str = "equalTo", kind: str = "Parameter") -> str:
    """That a parameter or variable has a value."""
    return f'<ByValueCondition><{kind}Condition {kind.lower()}Ref="{name}" rule="{rule}" value="{value}"/></ByValueCondition>'


def of(who: str, condition: str) -> str:
    """What is asked of somebody."""
    return f'<ByEntityCondition><TriggeringEntities triggeringEntitiesRule="any"><EntityRef entityRef="{who}"/></TriggeringEntities><EntityCondition>{condition}</EntityCondition></ByEntityCondition>'


def trigger(*conditions: str, edge: str = "none", tag: str = "StartTrigger") -> str:
    """A trigger of which all conditions must hold."""
    inner = "".join(f'<Condition name="c" delay="0" conditionEdge="{edge}">{one}</Condition>' for one in conditions)
    return f"<{tag}><ConditionGroup>{inner}</ConditionGroup></{tag}>"


def event(name: str, action: str, *conditions: str, edge: str = "none") -> str:
    """An event with one action; of a road user, where it is no GlobalAction."""
    does = action if action.startswith("<GlobalAction") else f"<PrivateAction>{action}</PrivateAction>"
    return f'<Event name="{name}" priority="override"><Action name="{name} action">{does}</Action>{trigger(*conditions, edge=edge)}</Event>'


def group(who: str, *events: str, declared: str = "", times: int = 1) -> str:
    """A group of one maneuver."""
    return f'<ManeuverGroup name="group of {who}" maximumExecutionCount="{times}"><Actors selectTriggeringEntities="false"><EntityRef entityRef="{who}"/></Actors><Maneuver name="maneuver">{declared}{"".join(events)}</Maneuver></ManeuverGroup>'


def declared(kind: str = "Parameter", /, **values: object) -> str:
    """Declarations of parameters or variables, each a number."""
    inner = "".join(f'<{kind}Declaration name="{n}" {kind.lower()}Type="double" value="{v}"/>' for n, v in values.items())  # fmt: skip
    return f"<{kind}Declarations>{inner}</{kind}Declarations>"


def scenario(
    *groups: str,
    inits: str | None = None,
    entities: str | None = None,
    before: str = "",
    story: str = "",
    begins: str = "",
    stops: str = "",
    lasts: float = 8,
    catalogs: str = "",
    description: str = "a test",
) -> str:
    """A scenario that ends after some seconds."""
    both = "".join(f'<ScenarioObject name="{name}">{CAR.format("")}</ScenarioObject>' for name in ("ego", "A"))
    usual = first("ego", put(lane(50)), speed(10)) + first("A", put(lane(100)), speed(10))
    act = f'<Act name="act">{"".join(groups)}{begins or trigger(time(0, "greaterOrEqual"))}{stops}</Act>'
    return f"""<OpenSCENARIO><FileHeader revMajor="1" revMinor="2" date="2026-01-01T00:00:00" description="{description}" author="us"/>
{before}<CatalogLocations>{catalogs}</CatalogLocations><RoadNetwork><LogicFile filepath="straight.xodr"/></RoadNetwork>
<Entities>{both if entities is None else entities}</Entities>
<Storyboard><Init><Actions>{usual if inits is None else inits}</Actions></Init>
<Story name="story">{story}{act}</Story>
{trigger(time(lasts), tag="StopTrigger")}</Storyboard></OpenSCENARIO>"""


def written(folder: Path, text: str, map_text: str = "") -> Path:
    """A scenario in a folder, beside its map."""
    (folder / "straight.xodr").write_text(map_text or road())
    path = folder / "theirs.xosc"
    path.write_text(text)
    return path


def read(folder: Path, text: str, map_text: str = "") -> Imported:
    """What a scenario says."""
    return read_openscenario(written(folder, text, map_text))


def told(folder: Path, text: str, map_text: str = "", *, as_written: bool = True) -> Story:
    """A drive of a scenario."""
    return chatscene.story(written(folder, text, map_text), as_written=as_written)


def driven(folder: Path, text: str, map_text: str = "", *, as_written: bool = True) -> Track:
    """How A goes in a drive of a scenario, every 0.1 s."""
    return track_of(told(folder, text, map_text, as_written=as_written))


def track_of(found: Story) -> Track:
    """How A goes in a drive."""
    return found._episode.tracks[1]  # pyright: ignore[reportPrivateUsage]
