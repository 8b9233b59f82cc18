#: description = "The crossing car creeps over the line on red and crosses at walking pace."
#: rephrasings = [
#:   "the guy from the side just trickles out while his light is still red",
#:   "Vehicle 2 crept past its red signal and proceeded slowly across the travel lanes.",
#:   "red for cross traffic, veh inches across anyway",
#:   "The target moves off against a red signal and traverses the junction at no more than 12 km/h.",
#:   "A bus passes very slow the red light, like it has all the time of the world.",
#:   "A cyclist dawdles across on red in front of the ego.",
#:   "The lorry rolls gently over the stop line although it has red, and takes ages to clear.",
#:   "Although the lights are against it, the van crawls into the crossing and keeps crawling.",
#:   "He dribbled over the line on red and inched across the junction.",
#:   "Vehicle 2 rolled past the stop bar against a red signal and proceeded through the intersection at about three miles per hour.",
#:   "Red; bus edges over line, ~5 km/h across.",
#:   "The crossing target passes the stop line at red and traverses the junction at walking speed.",
#:   "The car goes very slow over red light, like a walking man.",
#:   "Slow-motion red-light runner: oozes over the stop line and takes forever to clear.",
#:   "The light was against him, yet he stole over the line and went across no faster than a man on foot.",
#:   "He's sneaking over on the red, look, barely moving, let him dribble across.",
#:   "he just kinda rolled out on red super slow like nobody would notice",
#:   "A coach sidled over the line against the signal and went over at strolling pace.",
#:   "The signal was against you, and you proceeded notwithstanding, at the pace of a man walking?",
#:   "Red light also he is coming out slowly slowly like it's nothing.",
#:   "Sneaks out on the red like a kid raiding the biscuit tin, slow as you like all the way over.",
#:   "Low-speed red-signal violation of crossing vehicle.",
#:   "SLOWEST RED LIGHT RUNNER EVER",
#:   "The crossing bus seeped past the red at a shuffle.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "slow"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.0
#: high = 3.6
#: unit = "m/s"
#: meaning = "how fast it creeps across"

param OPT_ADV_DISTANCE = Range(0, 15)
param OPT_SLOW_SPEED = Range(2, 3.6)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
