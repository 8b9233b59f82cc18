#: description = "The crossing car turns left in front of the ego at walking pace."
#: rephrasings = [
#:   "he takes forever to get himself round to the left, right across our nose",
#:   "Vehicle 2 executed a slow left turn across the path of Vehicle 1.",
#:   "left turn, crawling, cuts our lane",
#:   "The target turns left from the cross street at no more than 14 km/h, crossing the lane of the VUT.",
#:   "The bike turns to the left but so slow that the ego must wait.",
#:   "A scooter potters round to its left without any hurry.",
#:   "An elderly driver eases the car leftward through the junction at a snail's pace.",
#:   "The cyclist bends left across the ego's way, barely moving.",
#:   "car from the side came round to the left in front of me about as quick as a milk float",
#:   "V2 made a left turn in front of V1 at approximately walking speed.",
#:   "Bicycle from side: L turn before us, v. slow.",
#:   "The crossing target turns left ahead of the VUT at 5 km/h without stopping.",
#:   "The motorbike from the side goes left before me, but so slow like a man who walks.",
#:   "Side-road left-turner with crawl speed; occupies the conflict zone far too long but never halts.",
#:   "It came out of the side street and bent its way round to the left before them as if it had the whole afternoon.",
#:   "He's doing his left turn in front of you, and isn't he taking his time, I could get out and push him round.",
#:   "guy turning left in front of us at like grandma speed pls hurry up",
#:   "An elderly motorist eased through a left turn so slowly that approaching traffic had to wait",
#:   "You took the left turn before my client at no more than a walk, and you never stopped?",
#:   "That scooter taking left in front of us so slow, like bride walking to stage",
#:   "Left he's going, in front of me, some time this week with any luck",
#:   "Low-speed left turn of crossing traffic in front of own vehicle",
#:   "SLOWEST left turn ever right in front of me",
#:   "The cyclist oozed round to the left before us.",
#: ]
#: adversaries = ["car", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-left", "slow"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.8
#: high = 3.9
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(4, 18)
param OPT_SLOW_SPEED = Range(2.8, 3.9)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
