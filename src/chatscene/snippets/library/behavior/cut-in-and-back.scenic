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
#:   "Over into ours, and over into his again, in one breath.",
#:   "Bus joins our lane, un-joins it immediately.",
#:   "Hello goodbye: scooter visits my lane for one second",
#:   "Let the lorry swap into my lane and instantly revert.",
#:   "Has the pickup honestly come across just to leave again?",
#:   "The fire engine slid in front of the robotaxi, saw the lane was no quicker, and in the same movement steered home to its own.",
#:   "Unit 2 transitioned laterally into the path of Unit 1, then without delay transitioned the other way, regaining the lane in which it had been travelling.",
#:   "I want that a motorcycle from the neighbour lane comes before the ego and directly, without staying, changes again to the lane where it was.",
#:   "He was back in his own lane before I'd even lifted off; a moment earlier the hatchback had jumped across in front of me.",
#:   "The artic's tractor and trailer both swung across ahead of us, someone must have yelled at him, and the whole lot swung away whence it came.",
#:   "Two lane changes in quick succession by the same van, the first into the subject vehicle's lane, the second undoing it: that's the test.",
#:   "Dear Sirs, I was proceeding along the dual carriageway when a coach moved over from the nearside lane and put itself before me. It did not remain. No sooner was it in than the driver steered to the left once more and resumed his previous lane.",
#:   "Ticket reopened. The tracker creates a new lead vehicle when the sedan crosses into our lane, which is right, but the sedan bounces straight out to the lane it came from and our ACC goes on braking for it several seconds after it has gone.",
#:   "When I was teaching my nephew, there was this ambulance next to us, no siren or anything. It hops in ahead of him, he panics, and I say relax, look, he's already leaving, because by then its wheel was turned and it was sliding back to its old place.",
#:   "The biker must've spotted a gap in front of my cab and gone for it, then realised there was a tailback further along. He'd hardly got his wheels in my lane before he flicked the bike the other way and rejoined the lane he'd just left.",
#:   "It happened so quick I thought I dreamt it: white van on the left, white van in front, white van on the left again. Took my lane and gave it back in about the time it takes to say so, an my tea was all over the seat.",
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
