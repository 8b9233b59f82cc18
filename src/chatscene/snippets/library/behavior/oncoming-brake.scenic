#: description = "The oncoming car brakes hard and stops in its lane."
#: rephrasings = [
#:   "A vehicle approaching from ahead slams to a standstill.",
#:   "The opposing driver stops abruptly, leaving the way around blocked.",
#:   "The adversary coming toward the ego decelerates sharply.",
#:   "Opposing traffic halts without warning beside the obstacle.",
#:   "The motorbike from the other direction brakes to a stop in front of the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "brake", "stop"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(5, 10)
param OPT_ADV_DISTANCE = Range(15, 45)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
