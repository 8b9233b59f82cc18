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
#:   "Opposing taxi doubles back before our nose, now heads our way.",
#:   "Oncoming scooter: half-circle into ego lane, continues in ego direction.",
#:   "He was driving at us, then he turned round and drove away from us.",
#:   "COP DOES 180 IN FRONT OF ONCOMING ROBOTAXI",
#:   "Can't a saloon coming the other way find a better place to turn round?",
#:   "I need an opposing hatchback which, when the subject vehicle is near, swings through half a turn into its lane and goes on ahead of it.",
#:   "Bonnet first it came towards me; boot first it left, since the Audi had spun itself round right across the front of my cab.",
#:   "The approaching ambulance received a new address, evidently, as it wheeled about in the road before us and made off the way we were going.",
#:   "From the contra side comes a moto, it gives a half tour on the road before my nose and is then before me, same sense.",
#:   "V2, initially eastbound and opposing V1, reversed its heading in front of V1 so that both vehicles were facing west when they made contact.",
#:   "Oncoming SUV's missed his turning, I reckon; he's throwing it about in the road ahead and he'll come out of it leading you.",
#:   "Lost tourist, most likely. I could see the hire car coming up the other side with its driver peering at a map, and when I was nearly on him he swung the wheel hard over, came about in front of me, and carried on in my direction.",
#:   "The target starts in the opposite lane. At the specified gap to the subject vehicle it turns through half a circle towards that vehicle's lane, and on completion of the arc it proceeds along the lane, now with the same heading, at its nominal speed.",
#:   "Everybody in the squad car was looking at the stolen bike behind us, not at us. They were coming towards us, and then blue lights, a howl of tyres, and they had flung the car about under our noses to go back up the road we were taking.",
#:   "My father taught me never to trust a motorcyclist who slows and looks behind him. This one was riding up to meet us, and sure enough, he heeled over, came all the way about in front of the grille, and went off up our lane.",
#:   "Ticket 902: an oncoming agent that does a one-eighty into our lane is still predicted as opposite traffic till the arc is complete. It begins in the other lane facing us and ends in ours facing away, and between those two we brake far too late.",
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
