#: description = "The car overtakes the ego, moves in front of it and then crawls along."
#: rephrasings = [
#:   "Overtakes us in a hurry, only to dawdle in front of our nose.",
#:   "Vehicle 2 passed vehicle 1, merged back and continued at very low speed.",
#:   "Passes, pulls in, then snail's pace.",
#:   "The target overtakes the VUT, changes into its lane and holds a low velocity.",
#:   "First he must overtake, after he goes slowly slowly.",
#:   "A bus rushes by to reach its stop and trickles along before us.",
#:   "The scooter lad whizzes round and then pootles.",
#:   "Having got ahead, the van settles at walking speed and holds the queue.",
#:   "Went past me, pulled in front and then dropped to about five miles an hour, what was the point of that?",
#:   "Unit 2 passed Unit 1, merged ahead of it and then proceeded at an unreasonably slow speed.",
#:   "Car o/takes, tucks in ahead of ego, then dawdles. No stop.",
#:   "The target passes the VUT, merges into its lane and then continues at a very low speed.",
#:   "The motorbike passes me, comes before me and after that drives so slow.",
#:   "Pass, merge, then go-slow: actor gets ahead and acts as a rolling roadblock.",
#:   "He'd been in such a hurry to be ahead of her, and once he was, he loitered along at a walking pace.",
#:   "Typical, he had to get in front of you, and now he's dawdling; just stay back behind him.",
#:   "bro overtook me just to go 10 in front of me?? why",
#:   "The motorist passed the van, took the space before it, and then ambled on at little more than a jog.",
#:   "You were so pressed that you passed her and took the road ahead of her, and then you loitered?",
#:   "He overtook and came to my front, and now he is going slow slow like Sunday walk.",
#:   "All that fuss to get by and nab my spot, and what's he do? Slows to a potter.",
#:   "Passing and merge ahead of ego with subsequent unduly low speed.",
#:   "OVERTAKES ME JUST TO DRIVE SLOWER",
#:   "The motorcycle passed us, slipped in front and languished.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "cut-in", "slow"]
#: leader = false
#: maneuver = "straight"
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.5
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 3.0
#: high = 10.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"
#: [[parameters]]
#: name = "OPT_ADV_CRAWL"
#: low = 1.2
#: high = 2.8
#: unit = "m/s"
#: meaning = "how fast it crawls"

param OPT_ADV_SPEED = Range(11.5, 15)
param OPT_ADV_AHEAD = Range(3, 10)
param OPT_ADV_CRAWL = Range(1.2, 2.8)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, globalParameters.OPT_ADV_CRAWL)
