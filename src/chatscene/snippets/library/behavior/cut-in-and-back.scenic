#: description = "The car cuts into the ego's lane and at once goes back to where it came from."
#: rephrasings = [
#:   "Somebody darts in ahead of us, changes his mind and hops back to his own lane.",
#:   "Vehicle 2 encroached fully on the lane of vehicle 1 and then returned to its original lane.",
#:   "Cut-in aborted: in, then out again to same side.",
#:   "The target enters the path of the VUT and reverts to its initial lane.",
#:   "It comes in, it goes out again, he cannot decide.",
#:   "The truck starts to take our lane, gets honked at and withdraws.",
#:   "A scooter rider swoops across our nose and then peels back out.",
#:   "The indecisive neighbour moves over, thinks better of it and retreats.",
#:   "He nipped into my lane, then changed his mind and popped straight back to his own.",
#:   "Vehicle 2 merged in front of Vehicle 1 and immediately returned to its original lane.",
#:   "Bus into ego lane, instantly back out to own lane. In-out.",
#:   "Target performs a lane change into the VUT's lane followed at once by a return to its initial lane.",
#:   "The truck comes in my lane and at the same moment he goes again to his old lane.",
#:   "Aborted merge: neighbour enters our lane fully, then bails back to where it started; the tracker flips targets twice.",
#:   "He darted in ahead of her and just as quickly thought better of it and slid back to where he'd been.",
#:   "He's in, no, he's out again; can't decide which lane he wants, that biker, just let him go back.",
#:   "he came in my lane for like half a sec then noped out again",
#:   "The van darted in front of the bus and, just as fast, withdrew to the lane it had left.",
#:   "So your client came over into her lane and forthwith withdrew to his own; what was the purpose of that?",
#:   "He came inside my lane and immediately went back to his own lane only, confused fellow.",
#:   "In he comes, out he goes. Make your mind up, mate, which lane d'you want?",
#:   "Momentary incursion into ego lane with immediate withdrawal to lane of origin.",
#:   "CHANGES LANE... NOPE, CHANGES BACK",
#:   "The motorcycle dipped into our lane and ricocheted home.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: changing lanes; own code"
#: [slots]
#: actions = ["cut-in", "turn-back"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -10.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -1.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(-10, 25)
param OPT_ADV_AHEAD = Range(-1, 8)
param OPT_ADV_SPEED = Range(5, 7)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED)
