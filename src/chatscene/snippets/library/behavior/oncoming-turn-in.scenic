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
#:   "Approaching SUV slung itself into our path, indicators dead.",
#:   "Moped from the opposite direction steers into us, no signal shown.",
#:   "Have an oncoming van veer into the ego's path unsignalled.",
#:   "Coach, opposite way, turned in front of you, never winked a light.",
#:   "He came from front and all at once turned in my way, no blinker",
#:   "Without giving any signal, the lorry which had been coming towards me put its wheel over and was all at once in the piece of road I needed.",
#:   "The opposing target shall leave its lane abruptly, direction indicators off, and move into the predicted path of the VUT.",
#:   "She swore that the car opposite had shown no flashing light at all before it bent out of its own lane and barred hers.",
#:   "V2 was approaching from the opposite direction and, with no turn signal activated, abruptly steered over the center line into the space in front of V1.",
#:   "Did that biker coming at us think we could read his mind, swinging into our way like that with his indicators switched off?",
#:   "Expect the unexpected: that hatchback facing you looked as if he'd stay put, gave nothing away, and has just turned into the road under your wheels.",
#:   "I had the green lane ahead to myself, or so it seemed. Out of the stream coming the other way a pickup suddenly slewed over into my path, no indicator, no look, and when I got my breath back it was filling my windscreen.",
#:   "Note for the agent library: oncoming vehicle, nominal until very late, then an immediate steering input that brings it into the ego's lane at an angle. Turn signals must remain off, because the point is that the intent cannot be known beforehand.",
#:   "My wife says I shouted something not fit for print. A bus that had been coming towards us all along the parade just hooked over into our way, with not one bulb flashing on that whole enormous side of it.",
#:   "There's a fine irony in the footage. The lorry coming the other way has seven orange lamps on its flank, and none of them so much as blinks before it lunges over into the path of the robotaxi and ends up in front of its bumper.",
#:   "The judge wanted to know how much notice the claimant had had. None, was the answer: the motorcyclist had been heading the opposite way, he had put out neither hand nor lamp, and in an instant he was in the claimant's path.",
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
