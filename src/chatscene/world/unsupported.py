"""What Scenic has and a drive here has not: refused where it is read, rather than left undone where it is driven."""

UNSUPPORTED = {
    "ScenarioDef": "modular scenarios are not supported; write what `setup` places at the top level of the program, "
    "and what `compose` has happen as behaviors",
    "Override": "modular scenarios are not supported, nor what they override; let a behavior change what it does",
    "Record": "a program records nothing: the run keeps every track, event and metric of a drive",
    "RecordInitial": "a program records nothing: the run keeps every track, event and metric of a drive",
    "RecordFinal": "a program records nothing: the run keeps every track, event and metric of a drive",
}
"""By kind of node of Scenic's syntax tree: why it is refused, and what to write instead."""
