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
#:   "Side-street moped bending left before us, hardly quicker than a pram.",
#:   "Let a car from the cross street dawdle left through our path.",
#:   "Bike on the cross road: going left ahead, pace of a walk, over.",
#:   "Gira a la izquierda before us one car, so slow, I could walk.",
#:   "The learner from the side road took her left in front of me at a trickle",
#:   "Coming from the cross street, a vintage tourer wended its way leftward ahead of our car with no more haste than a swan changing direction on a pond.",
#:   "Crossing target: left-turn trajectory through the ego's lane at a constant 5 km/h, without standstill, with conflict-zone occupancy exceeding six seconds.",
#:   "We had to hold back for a motorcyclist out of the side street, who paddled his machine round to the left before our bumper with both feet.",
#:   "Nobody was hurt, since the hatchback which made the left turn from the intersecting road in front of V1 was going at barely two or three miles an hour.",
#:   "How long can a cyclist take over one left turn, I wondered, as the man from the side street ambled round it ahead of us.",
#:   "Wait for this lady, she's coming out of the road at the side and taking a left ahead of you, and she's doing it at tea-trolley speed.",
#:   "I drive a bin lorry, so nobody can call me a speed merchant. But the gentleman in the Honda who came out of the side road this morning made me look like one. He turned to his left in front of me at something like the rate you'd push a wheelbarrow, and I simply stood there and watched.",
#:   "The AV was approaching the junction when a cyclist in the cross street set about a left turn through its path. Weighed down with two crates of beer, he went round in a large, placid curve, at what I'd call pallbearer's pace, and without once putting a foot to the ground.",
#:   "Scene idea for the patience tests: cross traffic, one car, turning left directly ahead of the ego. The only odd thing about it is how slow it goes. It ought to take the bend at the speed of somebody out with a dog, steadily, and so occupy our path for what feels like an age.",
#:   "Dear Sirs, with regard to the broken eggs. I had to brake because a lady on a motor scooter, emerging from the lane at the side, turned left across my front. She did so at such a gentle rate that I could see her counting the house numbers. There was nothing wrong with her signal.",
#:   "It was at the four-way by the feed store. This old boy in the station wagon comes off the side road, making his left in front of the cammer, and he's feeding that wheel hand over hand like he's docking a ferry, and you could honestly stroll alongside and clean his windows while he did it.",
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
