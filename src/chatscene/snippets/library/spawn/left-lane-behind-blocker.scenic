#: description = "A parked car blocks the ego's lane and the adversary comes from behind in the lane to its left."
#: rephrasings = [
#:   "While the ego must swing out, another vehicle is behind it in the left lane.",
#:   "we have to get round a parked car and there's somebody coming up on our left",
#:   "blocked lane ahead, veh behind in left lane",
#:   "Vehicle 2 was overtaking in the left lane as Vehicle 1 steered around a disabled vehicle.",
#:   "The target travels behind the VUT in the offside lane; an obstacle stands in the lane of the VUT.",
#:   "The lane of ego is closed and in the left lane from behind comes the adversary.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "blockedLane", "egoRoute", "leftLane"]
#: provides = ["AdvAgent", "advLane", "advTrajectory"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "behind-beside"
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
#: low = 8.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far behind the ego it starts"

param OPT_BLOCKER_Y = Range(-3, 3)
param OPT_GEO_Y = Range(8, 26)

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
advTrajectory = extended(leftLane, 30)
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, 30 - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, 30 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
