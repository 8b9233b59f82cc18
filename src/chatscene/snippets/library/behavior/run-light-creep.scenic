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
#:   "Cross traffic's on red and a taxi is tiptoeing over regardless.",
#:   "Lorry from the side ignores red, takes an age to trundle across.",
#:   "Have a scooter ooze past its red and amble over the junction.",
#:   "Lights red stop van nosed out at funeral pace stop crossed entirely stop",
#:   "That bus is going on red, and so slow like an old turtle!",
#:   "From our left a hatchback slid forward past the stop line with the lamp still red against it and went over the junction hardly quicker than a pram.",
#:   "Facing a red indication, the crossing target nevertheless advances beyond the stop line and maintains roughly 4 km/h through the intersection.",
#:   "I couldn't believe the nerve of the cyclist, who had a perfectly good red lamp in front of him and pottered over in front of me all the same.",
#:   "V2 entered from the intersecting street against a steady red and moved through the intersection at a very low, constant speed.",
#:   "red for him, green for us, an still the coach from the side street comes sliding out and takes half a minute to get accross",
#:   "In our city they do it so: signal is red, the auto from side is slowly rolling, rolling, till he has passed whole junction.",
#:   "When they run a red they usually go for it, but not this gent. He let his Rover trickle over the line while the signal forbade it and went from one kerb to the other no faster than the ladies on the crossing.",
#:   "The violation is easily missed because nothing about it is fast. The agent on the cross street starts rolling during its red phase, clears the stop line at a snail's pace and goes on crossing at that pace right in front of the AV.",
#:   "I had the green, I'd have sworn it on the Bible, so the lorry on the side road must have had red. Yet out it came, inch by inch as if nobody would mind, and it plodded over until its tail was finally out of my way.",
#:   "You'll meet them, the ones who think a red doesn't count so long as you don't hurry. That motorbike on the right has just dribbled over its line, feet down, and it's walking itself across the whole junction in front of you.",
#:   "The lights had not changed in his favour; the footage leaves no doubt. Nevertheless the pickup's bonnet came over the line from the cross street, and it then proceeded, as one might follow a coffin, the full width of the crossroads.",
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
