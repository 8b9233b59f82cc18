#: description = "A parked car blocks the ego's lane and the adversary is ahead of the ego in the lane to its left."
#: rephrasings = [
#:   "We must swing out round a parked vehicle, and some metres further on another is in the lane to our left.",
#:   "something stands in our lane, and the left lane that we need has a car a little in front of us",
#:   "Own lane blocked by stationary veh, target in left lane, slightly ahead.",
#:   "Vehicle 2 occupied the left lane forward of Vehicle 1 as Vehicle 1 steered around a disabled vehicle.",
#:   "The target travels in front of the VUT in the neighbouring offside lane; a stationary object closes the lane of the VUT.",
#:   "For ego the lane is closed, and left in front, in the next lane, drives the adversary.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "blockedLane", "egoRoute", "leftLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "ahead-beside"
#: blocker = true
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_BLOCKER_Y"
#: low = -3.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far along the middle of the bypass the parked vehicle stands"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 5.5
#: high = 14.0
#: unit = "m"
#: meaning = "how far ahead of the ego it starts"

param OPT_BLOCKER_Y = Range(-3, 3)
param OPT_GEO_Y = Range(5.5, 14)

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
advTrajectory = leftLane
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
