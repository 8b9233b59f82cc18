#: description = "The car in the target lane slows down and matches the speed of the slow leading vehicle, blocking the lane."
#: rephrasings = [
#:   "A vehicle beside drops back until it is level with the leader and stays there.",
#:   "The adversary adjusts to the pace of the slow car ahead and forms a wall with it.",
#:   "The neighbouring car decelerates to the leader's crawl, so nobody gets past.",
#:   "Driving as slowly as the vehicle in front, the car closes off the other lane.",
#:   "The driver in the target lane falls into step with the slow leader.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["LeadingAgent", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["slow"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -4.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far ahead of the leading vehicle it stays"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_ADV_AHEAD = Range(-4, 14)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do PaceOnPath(advTrajectory, LeadingAgent, globalParameters.OPT_ADV_AHEAD)
