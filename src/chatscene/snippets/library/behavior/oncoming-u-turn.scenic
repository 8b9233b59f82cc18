#: description = "The oncoming car makes a U-turn in front of the ego."
#: rephrasings = [
#:   "he's coming the other way and just swings round right in front of us",
#:   "Vehicle 2, travelling in the opposite direction, executed a U-turn ahead of Vehicle 1.",
#:   "opposing veh, U-turn across our lane",
#:   "The oncoming target turns through 180 degrees into the lane of the VUT.",
#:   "A taxi from the contrary direction turns around and drives then in our direction.",
#:   "A biker facing us does a one-eighty and ends up ahead.",
#:   "The police car opposite whips round to go after somebody.",
#:   "Coming toward the ego, it spins about and carries on the way we are going.",
#:   "the cab coming the other way spun right round in front of me to go back where he came from",
#:   "The oncoming vehicle made a U-turn directly in front of V1.",
#:   "MC opp.: 180 right before us.",
#:   "The oncoming target reverses its direction of travel by a U-turn ahead of the VUT.",
#:   "The police from front turns around before me and drives then in my direction.",
#:   "Opposite NPC flips heading by 180° ahead of the SUT and ends up in our lane, same way.",
#:   "It had been coming to meet them; it swung about full circle under their bonnet and showed them its tail lights.",
#:   "That car's decided he's going the wrong way, he's flipping it round in the road right in front of you.",
#:   "the car coming at us just flipped a full 180 right in front of us",
#:   "An approaching patrol car spun about before traffic and set off the way it had come",
#:   "You reversed your direction entirely, did you not, under the nose of my client's oncoming car?",
#:   "Opposite bike suddenly took U-turn in front of us only, no sense",
#:   "He's coming towards me, changes his mind about the whole journey and swings it right round under my bumper",
#:   "About-turn of opposing traffic in front of own vehicle",
#:   "Oncoming car pulls a FULL 180 right in my face",
#:   "The taxi facing us pivoted about before our bonnet.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "u-turn"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 22.0
#: high = 42.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns round"

param OPT_ADV_SPEED = Range(4, 6)
param OPT_ADV_DISTANCE = Range(22, 42)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(2.9, globalParameters.OPT_ADV_SPEED, 3.5)
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
