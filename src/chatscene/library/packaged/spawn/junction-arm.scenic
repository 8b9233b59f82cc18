#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: place = "junction"
#: [variants]
#: crossing-from-left           = { side = "left", position = "crossing", y = [3.5, 20], traffic = "trafficFromLeft", origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn, right-turn; own code" }
#: crossing-from-left-at-line   = { side = "left", position = "crossing", y = [2.7, 3.4], traffic = "trafficFromLeft" }
#: crossing-from-left-far       = { side = "left", position = "crossing", y = [21, 28], traffic = "trafficFromLeft", distance = "far" }
#: crossing-from-right          = { side = "right", position = "crossing", y = [3.5, 20], traffic = "trafficFromRight", origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn, right-turn; own code" }
#: crossing-from-right-at-line  = { side = "right", position = "crossing", y = [2.7, 3.4], traffic = "trafficFromRight" }
#: crossing-from-right-far      = { side = "right", position = "crossing", y = [21, 28], traffic = "trafficFromRight", distance = "far" }
#: oncoming-at-junction         = { position = "oncoming", y = [3.5, 20], traffic = "oncomingTraffic", origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn, right-turn; own code" }
#: oncoming-at-junction-at-line = { position = "oncoming", y = [2.7, 3.4], traffic = "oncomingTraffic" }
#: oncoming-at-junction-far     = { position = "oncoming", y = [21, 28], traffic = "oncomingTraffic", distance = "far" }
#: [descriptions]
#: crossing-from-left           = "The adversary comes from the left arm of the intersection."
#: crossing-from-left-at-line   = "The adversary stands at the line of the intersection from the left."
#: crossing-from-left-far       = "The adversary approaches the intersection from the left, still a long way off."
#: crossing-from-right          = "The adversary comes from the right arm of the intersection."
#: crossing-from-right-at-line  = "The adversary stands at the line of the intersection from the right."
#: crossing-from-right-far      = "The adversary approaches the intersection from the right, still a long way off."
#: oncoming-at-junction         = "The adversary comes from the opposite arm of the intersection, toward the ego."
#: oncoming-at-junction-at-line = "The adversary stands at the line of the intersection from the opposite direction."
#: oncoming-at-junction-far     = "The adversary approaches the intersection from the opposite direction, still a long way off."

param OPT_GEO_Y = Range$y  #: [m] how far before the intersection it starts

advTrajectory = wayOf($traffic, advTurn)
advMeeting = advTrajectory.meets_at
egoMeeting = advTrajectory.ego_meets_at
acrossMeeting = egoMeeting  # from here a left turn, too, leads across the ego's way  #: unless side left
AdvAgent = new AdvClass at pointOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, advTrajectory.entry - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
