# ruff: noqa: E501 - elements stand in one line each
"""A small scenario of our own, and what an enemy makes of it."""

from __future__ import annotations

from pathlib import Path

CAR = '<Vehicle name="v" vehicleCategory="car"><BoundingBox><Center x="1.4" y="0" z="0.7"/><Dimensions width="2" length="4.5" height="1.5"/></BoundingBox></Vehicle>'
WALKER = '<Pedestrian name="p" pedestrianCategory="pedestrian"><BoundingBox><Center x="0" y="0" z="0.9"/><Dimensions width="0.6" length="0.6" height="1.8"/></BoundingBox></Pedestrian>'
SLOWS = '<LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="linear" dynamicsDimension="rate" value="4"/><SpeedActionTarget><AbsoluteTargetSpeed value="0"/></SpeedActionTarget></SpeedAction></LongitudinalAction>'
NEAR = '<ByEntityCondition><TriggeringEntities triggeringEntitiesRule="any"><EntityRef entityRef="ego"/></TriggeringEntities><EntityCondition><RelativeDistanceCondition entityRef="lead" relativeDistanceType="longitudinal" freespace="false" rule="lessThan" value="$near"/></EntityCondition></ByEntityCondition>'
AT = '<WorldPosition x="136.75" y="{y}" h="1.570796"/>'


def event(action: str = SLOWS, condition: str = NEAR, name: str = "brakes") -> str:
    """An event with one action and one condition."""
    return f"""<Event name="{name}" priority="overwrite">
<Action name="{name}"><PrivateAction>{action}</PrivateAction></Action>
<StartTrigger><ConditionGroup><Condition name="c" delay="0" conditionEdge="rising">{condition}</Condition></ConditionGroup></StartTrigger>
</Event>"""


def scenario(
    *,
    events: str = "",
    body: str = CAR,
    place: str = AT.format(y=-345.0),
    map_name: str = "town.xodr",
    before: str = "",
    name: str = "lead",
    more: str = "",
) -> str:
    """A scenario in which somebody ahead of the ego slows down when it comes near."""
    return f"""<?xml version="1.0"?>
{before}<OpenSCENARIO>
<FileHeader revMajor="1" revMinor="2" date="2026-01-01T00:00:00" description="a test" author="us"/>
<ParameterDeclarations><ParameterDeclaration name="near" parameterType="double" value="20"><ConstraintGroup>
<ValueConstraint rule="greaterOrEqual" value="10"/><ValueConstraint rule="lessOrEqual" value="30"/></ConstraintGroup></ParameterDeclaration></ParameterDeclarations>
<CatalogLocations/><RoadNetwork><LogicFile filepath="{map_name}"/></RoadNetwork>
<Entities><ScenarioObject name="ego">{CAR}</ScenarioObject><ScenarioObject name="{name}">{body}</ScenarioObject></Entities>
<Storyboard><Init><Actions>
<Private entityRef="ego"><PrivateAction><TeleportAction><Position>{AT.format(y=-374.0)}</Position></TeleportAction></PrivateAction></Private>
<Private entityRef="{name}"><PrivateAction><TeleportAction><Position>{place}</Position></TeleportAction></PrivateAction>
<PrivateAction><LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="step" dynamicsDimension="time" value="0"/><SpeedActionTarget><AbsoluteTargetSpeed value="5"/></SpeedActionTarget></SpeedAction></LongitudinalAction></PrivateAction></Private>
</Actions></Init>
<Story name="s"><Act name="a"><ManeuverGroup name="g" maximumExecutionCount="1"><Actors selectTriggeringEntities="false"><EntityRef entityRef="{name}"/></Actors>
<Maneuver name="m">{events or event()}</Maneuver></ManeuverGroup>{more}
<StartTrigger><ConditionGroup><Condition name="b" delay="0" conditionEdge="none"><ByValueCondition><SimulationTimeCondition value="0" rule="greaterThan"/></ByValueCondition></Condition></ConditionGroup></StartTrigger></Act></Story>
<StopTrigger/></Storyboard></OpenSCENARIO>
"""


def variants(folder: Path, inner: str) -> Path:
    """A file of parameter values for the scenario in a folder, which is `scenario` where there is none."""
    if not (theirs := folder / "theirs.xosc").exists():
        theirs.write_text(scenario())
    path = folder / "values.xosc"
    told = f'<ParameterValueDistribution><ScenarioFile filepath="theirs.xosc"/>{inner}</ParameterValueDistribution>'
    path.write_text(f"<OpenSCENARIO>{told}</OpenSCENARIO>")
    return path


ATTACKS = {
    "entities that grow": (
        scenario(before='<!DOCTYPE x [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]>\n', name="&b;"),
        "declares a document type",
    ),
    "a file as an entity": (
        scenario(before='<!DOCTYPE x [<!ENTITY f SYSTEM "file:///etc/passwd">]>\n', name="lead"),
        "declares a document type",
    ),
    "a document type elsewhere": (
        scenario(before='<!DOCTYPE OpenSCENARIO SYSTEM "http://127.0.0.1:9/evil.dtd">\n'),
        "declares a document type",
    ),
    "elements in elements": ("<a>" * 100 + "</a>" * 100, "deep in one another"),
    "many elements": ("<OpenSCENARIO>" + "<a/>" * 200_001 + "</OpenSCENARIO>", "more than 200000 elements"),
    "a long attribute": (f'<OpenSCENARIO name="{"a" * 20_000}"/>', "more than 10000 characters"),
    "a map elsewhere": (scenario(map_name="/etc/passwd"), "is not an .xodr file"),
    "a map above": (scenario(map_name="../town.xodr"), "does not lie there"),
    "a map behind a drive": (scenario(map_name="..\\town.xodr"), "does not lie there"),
    "a catalog": (
        scenario(body='<CatalogReference catalogName="../../x" entryName="y"/>'),
        "no folder that the file names has a catalog",
    ),
    "a number that is none": (scenario(place=AT.format(y="inf")), "not a number within a million"),
    "an expression that calls": (
        scenario(place=AT.format(y="${__import__(near)}")),
        "not a number that can be said here",
    ),
    "brackets without end": (
        scenario(place=AT.format(y="${" + "(" * 3000 + "}")),
        "not a number that can be said here",
    ),
    "a zoo": ("\0\1\2", "not complete XML"),
    "another language": ('<?xml version="1.0" encoding="x-nonsense"?><OpenSCENARIO/>', "XML"),
    "a body like a town": (scenario(body=CAR.replace('length="4.5"', 'length="4500"')), "is not made here"),
}
"""What an enemy tries with a file, and a part of the sentence that it is refused with."""


def alone() -> str:
    """A scenario with nobody but an ego, and no story."""
    text = scenario()
    body = text[text.index('<ScenarioObject name="lead">') : text.index("</Entities>")]
    init = text[text.index('<Private entityRef="lead">') : text.index("</Actions></Init>")]
    tale = text[text.index("<Story ") : text.index("<StopTrigger/></Storyboard>")]
    for part in (body, init, tale):
        text = text.replace(part, "")
    return text
