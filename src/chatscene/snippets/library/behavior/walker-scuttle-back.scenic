#: description = "The pedestrian shuffles into the lane, takes fright and rushes back at a run."
#: rephrasings = [
#:   "Granny creeps out, sees us and shoots back onto the pavement faster than you'd think.",
#:   "The pedestrian entered the roadway at a slow walk and then hastily retreated to the shoulder.",
#:   "ped creeps out, then rushes back",
#:   "The target enters the lane at 1 m/s and withdraws at running speed.",
#:   "The person goes very slow into the street and then quickly runs back.",
#:   "A hesitant walker tiptoes into our lane and then turns tail in a hurry.",
#:   "Someone dawdles off the kerb, gets a shock and dashes back to safety.",
#:   "The kid edges out bit by bit, then whirls round and scoots home.",
#:   "An old dear came shuffling out, got the wind up and scurried back to the pavement.",
#:   "The elderly pedestrian entered the lane at a slow walk, became frightened and ran back to the curb.",
#:   "Ped slow in, startles, runs back.",
#:   "The pedestrian target enters the lane at low speed, reverses direction and returns at running speed.",
#:   "The grandma goes slow in my lane, is afraid and runs back.",
#:   "Asymmetric return: slow walk in, panic, fast retreat to the near kerb.",
#:   "He shambled out before her, caught sight of the bonnet, and bolted for the kerb he'd come from.",
#:   "She's tottering out, ah, you've spooked her, she's legging it back where she came from.",
#:   "lady shuffled out, saw us, freaked and RAN back lol",
#:   "A pensioner edged into the road, caught sight of the car and fled to the pavement again.",
#:   "She entered at a slow walk, took alarm, and ran to the side she had left; is that your evidence?",
#:   "Ah ma came out slow slow, saw my car, got scared and ran back to the side.",
#:   "Creeps out in her slippers, sees me, lets out a yelp and she's back on the kerb like a whippet.",
#:   "Slow pedestrian lane entry with panicked running retreat.",
#:   "PEDESTRIAN PANICS AND RUNS BACK TO CURB",
#:   "A man dawdled out, spooked and skedaddled home.",
#:   "Pensioner inches into our lane, panics, sprints for the pavement again.",
#:   "Slow step in, shock, full-speed flight to the near kerb.",
#:   "She enters slow like a duck, becomes fear, goes back running.",
#:   "Let a pedestrian plod in, get scared, and race back out.",
#:   "Out at a crawl, home at a gallop: one startled lady.",
#:   "A man with a stick hobbled off the kerb into my lane, looked up, and found his legs again: he was back there in three bounds.",
#:   "Ever so gradually the woman with the pram came out before the robotaxi, until it seemed to dawn on her, and she fled to the side with it.",
#:   "The pedestrian's speed was 0.8 m/s on the way into the lane and, after a visible start, 3.5 m/s on the reverse course to the footway.",
#:   "Our witness had ventured out at a dawdle; your horn, or your headlamps, gave her such a turn that she tore back to the pavement she had come from.",
#:   "See, he's wandering in front of you with his paper, in no rush, and now that he's noticed us he's pelting back the way he came.",
#:   "At a leisurely walk the young man entered the lane of V1, was alarmed at its nearness, turned about and fled from it as fast as he could run.",
#:   "I am eighty-three and I do not run, as a rule. I had set out over the road in my own time, one foot and then the other, and I'd got to the lane when I saw that car. I can tell you I ran, all the way back to my gate.",
#:   "Target profile, two phases of opposite direction. Phase one, entry into the VUT's lane at a shuffling speed. Phase two begins abruptly within the lane: the target turns by 180 degrees and returns to the edge it set out from at sprinting speed, where it stays.",
#:   "Like a snail that's been touched. The little girl was coming out in front of our bus by tiny steps, pulling a toy dog, and the driver flashed his lights, and you never saw anything so quick: round she went and back into her mother's coat, dog flying.",
#:   "I cycle past the care home daily. There's this gent who comes over the kerb as if the road were made of treacle, and I ring, and the car behind me hoots, and he gets such a jolt that he's off back to the kerb like a sprinter.",
#:   "I'd like to test whether the AV waits for someone who's already gone. So: a person drifts slowly into its lane, appears to be frightened by it, whips round and goes running back to safety on the side where the thing had begun.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "slow", "turn-back", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.7
#: high = 1.2
#: unit = "m/s"
#: meaning = "how fast it goes out"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.2
#: high = 1.1
#: unit = "m"
#: meaning = "how far from the ego's line it turns back"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 3.6
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it runs back"

param OPT_ADV_SPEED = Range(0.7, 1.2)
param OPT_ADV_DISTANCE = Range(12, 30)
param OPT_ADV_REACH = Range(0.2, 1.1)
param OPT_ADV_SPRINT = Range(3.6, 5.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 3.14159) until abs(offsetFrom(egoRoute, self)) > 4.5
    do Halt()
