#: description = "The car suddenly cuts in front of the ego and drives on."
#: rephrasings = [
#:   "A vehicle from the next lane swerves into the ego's.",
#:   "The adversary changes lanes right before the bonnet.",
#:   "The neighbouring car forces its way into the lane of the ego.",
#:   "An impatient driver squeezes in from beside without signalling.",
#:   "The motorbike slips over into the ego's lane just ahead.",
#:   "Somebody barges in right in front of us without a signal.",
#:   "Vehicle 2 made an unsafe lane change into the path of vehicle 1.",
#:   "Cut-in from adjacent lane, short distance.",
#:   "some muppet nipped in front of me without so much as a glance and carried on his merry way",
#:   "The box truck abruptly changed lanes directly ahead of Vehicle 1 and continued traveling.",
#:   "MC swoops in fr. of us, tiny gap, keeps going.",
#:   "The target changes lane into the path of the VUT at short headway and maintains its speed.",
#:   "The bus jumps in my lane just before me, then he drives normal.",
#:   "Cut-in actor: abrupt lane change to just ahead of the SUT, no braking afterwards, holds speed.",
#:   "A hatchback dived into the gap before his bonnet and rolled on as if it had always been there.",
#:   "There, he's gone for your gap, squeezed himself in ahead of you. At least he's keeping his speed up.",
#:   "car just snaked our spot and drove off like nothing happened smh",
#:   "A mother of two told how a minibus stole into the space before her and sped on its way",
#:   "Without warning he appropriated the space in front of my client and proceeded as if nothing had occurred",
#:   "Lorry simply put himself in front of us, no indicator nothing, then went off only",
#:   "Leave a car's length and some chancer has it off you, in he pops and off he trots",
#:   "Sudden occupation of forward gap by adjacent vehicle, speed maintained",
#:   "Motorbike STEALS my gap and just keeps riding",
#:   "The coupe pounced into our lane and pressed on.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["cut-in", "change-lane"]
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives then"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_ADV_SPEED = Range(4, 9)

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
