#: description = "The emergency vehicle closes up on the ego's bumper, pulls out and storms past."
#: rephrasings = [
#:   "The ambulance is all over our bumper with its siren, then swings round us.",
#:   "The emergency vehicle approached closely from behind, changed lanes and passed at speed.",
#:   "EMS on tail, pulls out, passes fast.",
#:   "The emergency vehicle closes on the VUT, changes lane and overtakes at high speed.",
#:   "The fire truck pushes from behind with the horn and goes around.",
#:   "Blue lights fill our mirror until the police car leaps out and by.",
#:   "Having honked at our tail in vain, the paramedics barge past.",
#:   "A fire engine looms up behind and bulldozes its way round us.",
#:   "An ambulance came flying up to my boot, whipped out and roared by me.",
#:   "Fire apparatus approached rapidly from the rear, pulled around Unit 1, and passed at high speed.",
#:   "Police car on our tail, pulls out, blasts past.",
#:   "The priority vehicle closes from behind to a very short headway, moves out laterally and overtakes with a large speed difference.",
#:   "Ambulance comes very near behind me, goes out and passes very fast.",
#:   "Rear EV closes to near zero gap then overtakes at speed; it does get by (contrast with the one that only tailgates).",
#:   "It filled his mirror with blue light, leaned out and thundered past before he could make room.",
#:   "Fire engine right on your rear, hold your line, he's coming round you now and he's really shifting.",
#:   "cop car was ON me and then swung round and flew by",
#:   "A fire engine raced up behind the motorist, swung out and swept by.",
#:   "The ambulance came up hard upon my client's rear, drew out, and was past him in an instant.",
#:   "Ambulance behind horn horn horn, then he came out and overtook in full speed.",
#:   "Fire wagon practically in my boot, then out he goes and wallops by, nearly took my light off the roof.",
#:   "High-speed passing of own vehicle by priority vehicle after closing to minimal rear separation",
#:   "AMBULANCE GIVES ME ONE SECOND then blows by",
#:   "The police van crowds our tail, jumps out and hurtles by.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["adjacentLane", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "overtake", "fast"]
#: position = "behind"
#: place = "road"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 36.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_GAP"
#: low = 0.8
#: high = 5.0
#: unit = "m"
#: meaning = "how much room it leaves between its bumper and the ego's"

param OPT_ADV_DISTANCE = Range(15, 36)
param OPT_ADV_GAP = Range(0.8, 5)

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 16) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(advTrajectory, self, ego) < (ego.length + self.length) / 2 + 6
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 16) for 1.5 seconds
    do ThrottleOnPath(extended(adjacentLane, 20), 1, 0, 16)
