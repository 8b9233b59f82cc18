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
#:   "Cop car crowds my rear, jinks out, gone like a shot.",
#:   "Ambulance right up behind, moves out, flashes by flat out.",
#:   "Let a fire engine breathe down our neck, then swing out and roar past.",
#:   "Blue lights on our tail, out he darts and away past us.",
#:   "Police bike hugs the ego's back, sidesteps, screams by.",
#:   "The paramedic car sat an arm's length behind for a second or two, ducked into the neighbouring lane and tore past us.",
#:   "The firemen came so near that I saw only red in the mirror, after they changed on the other side and flew along me.",
#:   "An appliance on call reduced its following distance to almost nothing, left the lane and overtook the subject vehicle with full power.",
#:   "Did the ambulance driver not first press up against your back, and only then pull out and rush by you at great speed?",
#:   "Suddenly there's a huge siren at my back window, he's touching me nearly, then whoosh, round the outside and miles ahead.",
#:   "Rear priority vehicle: closes to two metres, dwells, lane change, full throttle, past the VUT before it finds a gap to yield.",
#:   "I was slow to move over, I admit it. The rapid-response car came right up to my tow bar, wailing, hung there for a breath, and then veered out and shot by me like I was parked.",
#:   "You'll hear the siren before you see it. It'll come up so close behind you that you can read nothing but the grille; keep straight, because it's going to step out into the other lane and hurtle on ahead.",
#:   "There was a rush of blue over the ceiling of the cab. The police car hung for a heartbeat a metre from our rear, shouldered out of the lane, and went howling by, with the wind of it rocking us.",
#:   "V1 was being followed at minimal distance by a marked fire-department unit with lights activated. The unit then departed the lane to the left and went by V1 under hard acceleration, continuing toward an alarm downtown.",
#:   "We in the tram stop saw it. The ambulance is pushing the little white robot car, so to say, with one metre only, then it goes to the outside and overtakes with a terrible speed.",
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
