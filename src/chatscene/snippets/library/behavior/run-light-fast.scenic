#: description = "The crossing car shoots through the red light at high speed."
#: rephrasings = [
#:   "some maniac blasts through the red at seventy right in front of us",
#:   "Vehicle 2 entered the intersection against the red signal at a high rate of speed.",
#:   "cross veh, red, no attempt to slow, very fast",
#:   "The target passes the stop line on red well above the speed limit, on a path that intersects that of the VUT.",
#:   "A motorbike is coming very quick and doesn't care that the traffic light is red for him.",
#:   "A racer ignores the lights and flies over the crossing.",
#:   "The biker barrels across on red flat out.",
#:   "Speeding, the other driver jumps the signal without touching the brake.",
#:   "Some boy racer shot the lights from the side at about seventy.",
#:   "The suspect vehicle ran the red light at a high rate of speed from the cross street.",
#:   "X-car blows red, v. high spd, no lift.",
#:   "The crossing target disregards the red signal and traverses the junction at high constant speed.",
#:   "A motorbike comes from the side with red light, extremely fast.",
#:   "Red-light runner at high speed, already quick before the line; no accel phase, no decel.",
#:   "The lights meant nothing to him; he went through on red like a bullet, right across her bows.",
#:   "All units, he's blown the red, he's doing seventy across the junction!",
#:   "someone just FLEW thru the red from the side like 100 mph",
#:   "A speeding car thundered through a stop signal from the side road, narrowly missing traffic.",
#:   "At what speed would you say the motorcycle was travelling when it went past the red signal; very great?",
#:   "Red light he never bother, full speed he went across from the side.",
#:   "Red as a beetroot, that light, and he comes out the side street like a shell out of a gun.",
#:   "High-speed red-signal violation of crossing vehicle.",
#:   "MANIAC BLASTS THROUGH RED LIGHT AT INSANE SPEED",
#:   "The crossing car lanced through the red.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "NHTSA pre-crash typology: running red light; own code"
#: [slots]
#: actions = ["run-light", "fast"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 60.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.5
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it shoots across"

param OPT_ADV_DISTANCE = Range(25, 60)
param OPT_ADV_SPEED = Range(12.5, 17)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED)
