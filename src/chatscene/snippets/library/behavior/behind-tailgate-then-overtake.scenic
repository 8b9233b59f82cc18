#: description = "The car behind tailgates the ego, then pulls out and overtakes it."
#: rephrasings = [
#:   "First he's up our exhaust, then he swings out and goes by.",
#:   "Vehicle 2 followed at close range, changed lanes and passed vehicle 1.",
#:   "Tailgates, pulls out, passes.",
#:   "The target closes up to the VUT, moves to the adjacent lane and overtakes.",
#:   "He pushes from behind a long time and then passes on the other lane.",
#:   "The motorbike sits in our draught before it nips round.",
#:   "A van crowds our boot until it finds the next lane free and sails by.",
#:   "A coach leans on us from the rear and finally heaves itself past.",
#:   "Had a hatchback sat on my bumper for ages, then he lost patience, nipped out and went by.",
#:   "Vehicle 2 followed V1 at an unsafe distance before pulling into the adjacent lane and passing it.",
#:   "Rear car glued to ego bumper few secs, then out + past. No braking in front.",
#:   "The rear target maintains a very short headway to the VUT, subsequently changes lane and completes a passing manoeuvre.",
#:   "The moto is driving too close behind me, after some time he goes out and passes me.",
#:   "Rear vehicle holds sub-half-second headway for a while, then moves out and goes around; no brake check afterwards.",
#:   "He hung on her tail so close she couldn't see his headlamps, until at last he swung out and was gone past her.",
#:   "See him breathing down your neck? He's itching to get by; there, he's pulled out and he's off round you.",
#:   "this guy was literally up my butt for a whole minute then finally went around lmao",
#:   "After hounding the learner's car at arm's length, the impatient driver went by it, witnesses said.",
#:   "He remained within a metre of my client's boot, and only afterwards moved out and went ahead of her; is that so?",
#:   "Behind car was sticking to my back like anything, then only he overtook and went.",
#:   "Fella was breathing down my neck all along the street, then off he hops round me. Couldn't do that at the start, could he?",
#:   "Insufficient headway from following vehicle, ending in a passing manoeuvre.",
#:   "IMPATIENT TAILGATER CAN'T WAIT, GOES ROUND",
#:   "A motorcycle nuzzled our rear bumper, then leapt past.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["adjacentLane", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "overtake"]
#: leader = false
#: place = "road"
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_GAP"
#: low = 0.8
#: high = 4.0
#: unit = "m"
#: meaning = "how much room it leaves between its bumper and the ego's"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 10.0
#: high = 14.0
#: unit = "m/s"
#: meaning = "how fast it overtakes"

param OPT_ADV_DISTANCE = Range(5, 30)
param OPT_ADV_GAP = Range(0.8, 4)
param OPT_ADV_SPEED = Range(10, 14)

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(extended(adjacentLane, 20), globalParameters.OPT_ADV_SPEED)
