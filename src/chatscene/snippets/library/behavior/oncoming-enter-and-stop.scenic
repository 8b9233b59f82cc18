#: description = "The oncoming pedestrian comes along the road edge, enters the lane without warning and suddenly stops."
#: rephrasings = [
#:   "A person walking against the traffic steps into the lane and freezes.",
#:   "The pedestrian approaches from ahead, veers into the ego's way, and stands still.",
#:   "Someone who walks toward the ego slips into the carriageway and halts there.",
#:   "Facing the ego, the walker moves into its path and comes to a standstill.",
#:   "The jogger running toward the vehicle swings into the lane and stops dead.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "stop"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 3.0
#: high = 20.0
#: unit = "m"
#: meaning = "distance to the ego at which it enters the lane"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.6
#: high = 1.0
#: unit = "rad"
#: meaning = "how sharply it turns into the lane"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(1, 4)
param OPT_ADV_DISTANCE = Range(3, 20)
param OPT_ADV_ANGLE = Range(0.6, 1)
param OPT_STOP_DISTANCE = Range(0, 1)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < 2 * globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
