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
#:   "car ahead sways about in its lane n then breaks hard",
#:   "Lorry in front wriggles left and right, then an emergency stop.",
#:   "Lead moto: serpentine within lane, abrupt braking to rest.",
#:   "Sleepy bus driver ahead wanders, wakes, slams everything on.",
#:   "TIPSY? Driver in front wobbles along then SLAMS ON",
#:   "Get the van in front of the AV to drift from one lane edge to the other a few times, and then, with no warning, stop hard.",
#:   "First came the wobbling, this side, that side, never leaving his lane; then came the brake lights, and I very nearly ended in his boot.",
#:   "The fire engine we were behind rocked from line to line as though the wheel were loose, and out of the blue it stamped to a standstill.",
#:   "The lead vehicle shows a lane-internal sinusoidal course ahead of the test vehicle; at the trigger it decelerates strongly until at rest.",
#:   "Drunk driver report: pickup ahead of caller can't hold a straight line in his lane, and just now he braked to a dead stop for nothing.",
#:   "The front car is dancing in his lane, now near to right line, now near to left line, and at last he does a full braking.",
#:   "I noticed him first because his wheels kept touching the white line on one side and then the other. I dropped back a little, thinking he was drunk or texting. A good job I did, for all of a sudden he went for the brake and stopped.",
#:   "The driver of V2 had a blood alcohol level of 1.9. Before the impact his car, leading V1 by about twenty metres, moved to and fro inside its lane in several swings, and then it was braked heavily, without cause, until it no longer moved.",
#:   "My dad says never stay behind somebody who drives like a snake. The motorbike in front of us was wiggling all along its lane, and then it went screech and it stood still, and my dad had to screech as well.",
#:   "A good one for the perception people: the truck ahead snakes gently between its lane markings for some seconds, which already looks fishy, and when the ego gets close it adds a vicious brake application down to zero. The combination is what trips the planner.",
#:   "It was past midnight when the taxi before us took to reeling, from kerb side to centre line and over to the kerb side again, like a man feeling along a corridor for the light. Then it stopped, so violently that its tail lifted.",
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
