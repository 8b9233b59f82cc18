#: description = "The pedestrian crosses very slowly."
#: rephrasings = [
#:   "An elderly person shuffles over the carriageway.",
#:   "The pedestrian creeps through the lane and takes a long time about it.",
#:   "Someone plods across at a crawl, staying in the way of the ego.",
#:   "The walker dawdles over the street.",
#:   "A person with a walking frame inches across the road.",
#:   "The old lady takes for ever to get over the road.",
#:   "The elderly pedestrian crossed the roadway at a slow pace.",
#:   "ped crosses, very slow",
#:   "An old dear was pottering over the road at a glacial pace.",
#:   "The elderly pedestrian was crossing at a very slow walk, without stopping.",
#:   "Ped x-ing, dead slow, steady.",
#:   "The pedestrian target crosses at constant very low speed (below 0.5 m/s).",
#:   "Grandmother goes over the street so slowly.",
#:   "Crosser at minimum walking speed, continuous, no dwell, occupies the lane for long.",
#:   "He took his time about it, one small step after another, as if the road belonged to him.",
#:   "There's an old fellow on a cane going over, he's taking forever, just let him get there.",
#:   "this grandma is crossing sooo slow im gonna be late",
#:   "An elderly man made his way over the road at a very gentle pace as cars waited.",
#:   "The pedestrian's progress across was continuous, I grant, but exceedingly slow.",
#:   "Ah ma cross the road very slow, one small step one small step.",
#:   "I've seen glaciers get over the road quicker than this old boy.",
#:   "Prolonged lane occupancy by pedestrian of very low but constant walking speed",
#:   "LONGEST CROSSING OF MY LIFE - pedestrian in slow-mo",
#:   "The old man toddles across.",
#:   "Nan with her shopping trolley, crossing at the speed of moss",
#:   "Let a walker traverse the road at a very leisurely rate.",
#:   "Man on crutches is getting over the street little by little, never stopping.",
#:   "Elderly female crossing ahead, extremely unhurried, allow plenty of time.",
#:   "He goes from one side to other side like a slow film.",
#:   "A woman with a pram was making her way over in front of us so gradually that the indicator clicked forty times before she was through.",
#:   "The VRU target shall traverse the carriageway perpendicular to it at a uniform 0.4 m/s, without pause or change of direction.",
#:   "Somebody in carpet slippers came over from the bus stop, and we could have boiled an egg in the time he needed to reach the other kerb.",
#:   "The pedestrian was crossing from the west curb to the east at a markedly reduced walking speed and was still within the lane as V1 arrived.",
#:   "My knees being what they are, I get over that road as best I can, one little step and then the next, and cars must wait.",
#:   "In India also we respect aged people, so when one uncle was crossing in front at ant's speed, straight over, I simply kept my foot on brake.",
#:   "There was no drama in it, just length. The lady set out from the pavement with her two sticks, kept steadily on, and made perhaps a foot with every breath, so that half the street had come to a standstill before she was over.",
#:   "Please give me a pedestrian whose only peculiarity is lack of speed. He walks straight over the road ahead of the AV without halting or turning, but he needs about three times as long as anybody else would for the same distance.",
#:   "Never hoot at them. That gentleman with the walking frame left the kerb when you were miles away, he's been going steadily ever since, and he has only got as far as your lane, because that really is as quick as he can walk.",
#:   "She crossed as other people knit, without looking up and with no thought of finishing. The driver watched the grey coat progress from the left edge of his windscreen to the right, and it seemed to him that the seasons were changing.",
#:   "The child told the constable that the old man wasn't drunk and he wasn't silly, he was just slow. He went over the road in front of the blue car like when you carry a very full glass, all the way to the other side.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 1.4
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 22.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"

param OPT_ADV_SPEED = Range(0.8, 1.4)
param OPT_ADV_DISTANCE = Range(22, 52)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
