#: description = "The oncoming car suddenly turns into the ego's path without signalling."
#: rephrasings = [
#:   "A vehicle approaching from ahead cuts across in front of the ego.",
#:   "The opposing driver turns off through the ego's lane with no indicator.",
#:   "The adversary, facing the ego, swings left right over its way.",
#:   "An oncoming vehicle makes an abrupt turn into the road space of the ego.",
#:   "The car coming the other way crosses the centre line and stays in the ego's path.",
#:   "he cuts right across in front of us and doesn't even indicate",
#:   "Vehicle 2, oncoming, turned across the centreline and stopped in the lane of Vehicle 1.",
#:   "opposing veh cuts in across our lane, no indicator",
#:   "car coming the other way just steered straight into my path, not a flicker of an indicator",
#:   "The oncoming vehicle abruptly turned into V1's path of travel without signaling.",
#:   "Opp. truck veers in front of us. No blinker.",
#:   "The oncoming target steers without indication into the trajectory of the VUT.",
#:   "The bus from front comes suddenly into my way and gives no light.",
#:   "Opposite-lane NPC should hook over into the SUT's planned path, blinkers off, short notice.",
#:   "With no sign of what he meant to do, the biker coming to meet them wheeled into the very path they were on.",
#:   "No signal from that van coming at you, and he's swinging over into where you're going regardless.",
#:   "the car coming the other way just turned right into us no indicator nothing",
#:   "A lorry on the opposite side steered, without so much as a flash of its lights, over the path of a school run",
#:   "Giving no indication whatever, you directed your approaching vehicle into my client's course?",
#:   "Opposite side bike suddenly cut into our way, signal also never give",
#:   "He's coming at me, I'm going at him, and out of the blue he steers over my front, indicator must've been extra",
#:   "Unsignalled turn of opposing traffic into own path",
#:   "Oncoming bus TURNS INTO ME without signaling",
#:   "The pickup facing us veered into our way unannounced.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "cut-in"]
#: position = "oncoming"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far before the middle of its way the ego is when the adversary sets off"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 15.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far beyond that middle it turns"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.5
#: high = 1.1
#: unit = "rad"
#: meaning = "how sharply it turns"

param OPT_ADV_SPEED = Range(5, 9)
param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_REACH = Range(15, 30)
param OPT_ADV_ANGLE = Range(0.5, 1.1)

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(egoRoute, self, egoRoute.eventAt) > -globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) until abs(offsetFrom(ownLane(egoRoute), self)) < 1.5
    do Halt()
