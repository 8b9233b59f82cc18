#: description = "The car ahead weaves in its lane like a drunk and suddenly brakes."
#: rephrasings = [
#:   "The drunk in front of us wobbles left and right and then stamps on the brake.",
#:   "Vehicle 2 was swerving within its lane before it abruptly decelerated and stopped.",
#:   "Lead snaking in lane, then hard stop.",
#:   "The target oscillates laterally in front of the VUT and finishes with emergency braking.",
#:   "The driver ahead goes zigzag, maybe he sleeps, and then he brakes much.",
#:   "The lorry before us sways to and fro, wakes up and jams everything on.",
#:   "A motorcyclist ahead snakes about and then hauls the machine to a stop.",
#:   "Our leader meanders on his phone, looks up, panics, halts.",
#:   "The bloke in front was all over the shop, must've been plastered, then out of nowhere he hit the brakes.",
#:   "The lead vehicle was observed drifting from side to side within its lane, consistent with impairment, and then braked suddenly.",
#:   "Lead wandering L/R like DUI, then abrupt brake to stop.",
#:   "The lead target exhibits lateral oscillation within the lane, followed by unannounced braking.",
#:   "The car in front drives like drunk man, left right, and suddenly he brakes.",
#:   "Drunk-driver lead: swerving sinusoid first, then unprovoked hard brake to standstill.",
#:   "He rolled about before her like a sailor on shore leave, and then without rhyme or reason he jammed it to a stop.",
#:   "He's had a skinful, that one, look at him swaying, and now he's slammed on, hang back!",
#:   "car ahead was swerving side to side like wasted and then just braked",
#:   "A suspected drink-driver lolled about his lane ahead of other traffic and then pulled up without cause.",
#:   "Your vehicle would not keep a straight course, my lady's witness says, and then, quite suddenly, you braked?",
#:   "Front car was going zig zag in his lane like drunkard, after that sudden brake.",
#:   "Pickled, he must be, rolling about the lane in front like a ferry, then on go the brakes.",
#:   "Erratic lateral lane wandering of lead vehicle culminating in sudden stop.",
#:   "DRUNK DRIVER AHEAD SWAYS THEN BRAKES",
#:   "The motorbike ahead reeled in its lane, then clawed to a stop.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "brake", "stop"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -25.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.5
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.7
#: high = 1.2
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-25, 5)
param OPT_ADV_SPEED = Range(5.5, 7.5)
param OPT_ADV_AMPLITUDE = Range(0.7, 1.2)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) for 2 seconds
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 3.4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and abs(offsetFrom(advTrajectory, self)) < 0.7
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
