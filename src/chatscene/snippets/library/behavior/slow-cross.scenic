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
