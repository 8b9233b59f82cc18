#: description = "The oncoming pedestrian suddenly runs into the lane toward the ego."
#: rephrasings = [
#:   "A person coming the other way breaks into a run and enters the ego's path.",
#:   "The pedestrian heads for the ego on foot and speeds up into its lane.",
#:   "Someone jogging against the traffic swerves in front of the vehicle at a sprint.",
#:   "The walker from ahead accelerates slantwise into the carriageway.",
#:   "Facing the ego, a runner rushes into the roadway.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "accelerate"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 2.0
#: unit = "m/s"
#: meaning = "how fast it goes at first"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 4.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 28.0
#: unit = "m"
#: meaning = "distance to the ego at which it runs"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.3
#: high = 0.9
#: unit = "rad"
#: meaning = "how sharply it turns into the lane"

param OPT_ADV_SPEED = Range(0.8, 2)
param OPT_ADV_SPRINT = Range(4, 7)
param OPT_ADV_DISTANCE = Range(10, 28)
param OPT_ADV_ANGLE = Range(0.3, 0.9)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < 2 * globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
