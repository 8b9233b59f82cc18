#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: position = "behind-beside"
#: [variants]
#: adjacent-lane-behind     = { y = [6, 18], lane = "adjacentLane", back = 20, origin = "base scenario lane-changing; own code" }
#: left-lane-behind         = { y = [6, 18], lane = "leftLane", back = 20, side = "left", origin = "base scenario lane-changing; own code" }
#: left-lane-behind-blocker = { y = [8, 26], lane = "leftLane", back = 30, side = "left", maneuver = "bypass", blocker = true, blocker_y = [-3, 3] }
#: left-lane-behind-far     = { y = [35, 39], lane = "leftLane", back = 40, side = "left", place = "road", distance = "far", adversaries = ["car", "motorcycle", "emergency-vehicle"] }
#: left-lane-behind-near    = { y = [3, 6], lane = "leftLane", back = 20, side = "left", distance = "near", adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"] }
#: right-lane-behind        = { y = [6, 18], lane = "rightLane", back = 20, side = "right", origin = "base scenario lane-changing; own code" }
#: right-lane-behind-far    = { y = [35, 39], lane = "rightLane", back = 40, side = "right", place = "road", distance = "far", adversaries = ["car", "motorcycle", "emergency-vehicle"] }
#: right-lane-behind-near   = { y = [3, 6], lane = "rightLane", back = 20, side = "right", distance = "near", adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"] }
#: [descriptions]
#: adjacent-lane-behind     = "The adversary is behind the ego in the neighbouring lane."
#: left-lane-behind         = "The adversary is behind the ego in the lane to the left of the ego."
#: left-lane-behind-blocker = "A parked car blocks the ego's lane and the adversary comes from behind in the lane to its left."
#: left-lane-behind-far     = "The adversary is far behind the ego in the lane to its left."
#: left-lane-behind-near    = "The adversary is in the ego's blind spot, close behind in the lane to its left."
#: right-lane-behind        = "The adversary is behind the ego in the lane to the right of the ego."
#: right-lane-behind-far    = "The adversary is far behind the ego in the lane to its right."
#: right-lane-behind-near   = "The adversary is in the ego's blind spot, close behind in the lane to its right."

param OPT_BLOCKER_Y = Range$blocker_y  #: if blocker  #: [m] how far along the middle of the bypass the parked vehicle stands
param OPT_GEO_Y = Range$y  #: [m] how far behind the ego it starts

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),  #: if blocker
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),  #: if blocker
    with label "blocker"  #: if blocker
advTrajectory = extended($lane, $back)
advLane = advTrajectory
AdvAgent = new AdvClass at pointOn(advTrajectory, $back - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, $back - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
