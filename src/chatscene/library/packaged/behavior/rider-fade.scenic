#: description = "The cyclist ahead sprints off, tires and slows to a crawl."
#: adversaries = ["bicycle"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "slow"]
#: position = "ahead"

param OPT_ADV_SPRINT = Range(6, 8)  #: [m/s] how fast it sprints
param OPT_ADV_TIME = Range(1.5, 3)  #: [s] how long it sprints
param OPT_ADV_DISTANCE = Range(0, 25)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_SLOW_SPEED = Range(1, 2.4)  #: [m/s] how fast it crawls

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPRINT) for globalParameters.OPT_ADV_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
