#: description = "The oncoming car overtakes in the ego's lane and swerves back to its own side very late."
#: rephrasings = [
#:   "he's overtaking straight at us and only just tucks back in",
#:   "Vehicle 2 was passing in the oncoming lane and returned abruptly to its own lane ahead of Vehicle 1.",
#:   "opposing overtaker, our lane, cuts back late",
#:   "The target occupies the lane of the VUT while overtaking and steers back at short distance.",
#:   "A motorcycle makes an overtaking in our lane and it returns in the last moment.",
#:   "A biker playing chicken dives back over the centre line at the death.",
#:   "The lorry passing somebody on the far side squeezes back in with a jerk.",
#:   "It stays on our side until the very end, then flicks away.",
#:   "He was overtaking straight at me and only nipped back in when I could count his teeth.",
#:   "Opposing vehicle was passing in Unit 1's lane and swerved back to its own lane just before impact.",
#:   "Truck oncoming, overtakes on our side, cuts back last sec.",
#:   "The opposing vehicle overtakes in the lane of the test vehicle and returns to its own lane at minimal time-to-collision.",
#:   "The bus from the front overtakes on my side and goes back in its lane very late.",
#:   "Opp. overtaker in our lane, jerks back to its own at very low TTC, so near miss.",
#:   "She had made up her mind that they would meet, when at the last gasp he wrenched it in front of the car he had passed.",
#:   "He's overtaking into you, he's cutting it fine, he's cutting it very fine, phew, he's back in.",
#:   "he was overtaking on my side and only swerved back when we were abt to crash",
#:   "An overtaking driver regained his own side with barely a car's length to spare before the oncoming vehicle.",
#:   "You persisted in my client's lane until the last possible instant and only then wrenched your car back.",
#:   "Opposite lorry overtaking in my lane, at the very last moment he cut back to his side, just miss.",
#:   "Overtakes right at me, cool as a cucumber, and chucks it home when I've already got my eyes shut.",
#:   "Belated return of opposing overtaking vehicle from own lane",
#:   "CLOSEST OVERTAKE EVER - swerves home with inches to spare",
#:   "The oncoming van overtakes on our side and ducks home barely in time.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "swerve"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 26.0
#: unit = "m"
#: meaning = "distance to the ego at which it goes back to its own lane"

param OPT_ADV_SPEED = Range(6, 11)
param OPT_ADV_DISTANCE = Range(8, 26)

behavior AdvBehavior():
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
