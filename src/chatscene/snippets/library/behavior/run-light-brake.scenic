#: description = "The crossing vehicle runs the red light and brakes abruptly."
#: rephrasings = [
#:   "A car ignores the signal and then slams to a standstill in the junction.",
#:   "Having jumped the lights, the adversary hits the brakes before the ego.",
#:   "The other driver crosses on red and stops short.",
#:   "Against the red a vehicle rushes in and decelerates hard.",
#:   "Cross traffic overruns the stop line on red and brakes in the middle.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "ego", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "brake"]
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 2.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_DISTANCE = Range(18, 45)
param OPT_ADV_SPEED = Range(6, 11)
param OPT_STOP_DISTANCE = Range(0, 2)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do BrakeOnPath(advTrajectory)
