#: description = "The car ahead stops and abruptly reverses."
#: rephrasings = [
#:   "A vehicle in front halts and rolls backwards toward the ego.",
#:   "The adversary shifts into reverse gear and backs up.",
#:   "The car stops short, then drives backward without looking.",
#:   "The driver ahead suddenly moves in reverse and blocks the lane.",
#:   "The van comes to a stand and backs into the traffic behind it.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: actions = ["stop", "reverse"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes first"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 1.0
#: high = 4.0
#: unit = "s"
#: meaning = "for how long"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.5, 1)
param OPT_ADV_SPEED = Range(1, 3.5)
param OPT_ADV_BACK_TIME = Range(1, 4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
