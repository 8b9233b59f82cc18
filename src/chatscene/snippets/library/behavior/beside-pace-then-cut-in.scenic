#: description = "The car stays level with the ego and then squeezes over into its lane."
#: rephrasings = [
#:   "He rides along right next to us and then just leans on us until we give way.",
#:   "Vehicle 2 travelled alongside vehicle 1 and then moved laterally into it.",
#:   "Side by side for a while, then merges into us.",
#:   "The target keeps station beside the VUT and then performs a lane change into the occupied space.",
#:   "He is driving parallel with us and then comes in, no looking in the mirror.",
#:   "The truck hangs in our blind spot's reach and crowds us off the lane.",
#:   "A bus next to us shoves over as if we weren't there.",
#:   "Door to door at first, then the motorbike shoulders its way into our lane.",
#:   "This lorry ran neck and neck with me for a bit and then just shoved over into my bit of road.",
#:   "The bus matched Unit 1's speed in the adjoining lane and thereafter encroached into Unit 1's lane of travel.",
#:   "Veh abreast, same spd, holds; then squeezes in on ego.",
#:   "Target travels side by side with the VUT at equal velocity for several seconds before moving laterally into the VUT's lane.",
#:   "The motorbike goes same speed next to me, long time, then pushes himself inside my lane.",
#:   "Actor parks in our blind spot at zero delta-v, then forces a merge with hardly any gap.",
#:   "He kept door to door with her, not gaining and not falling back, and then he leaned in and pinched her lane.",
#:   "He's been riding alongside you matching your speed; any second now he'll muscle in, so be ready to give way.",
#:   "this car stayed RIGHT next to me forever then just leaned into my lane like hello??",
#:   "The coach ran door to door with the saloon before edging it out of its lane, an onlooker said.",
#:   "For some seconds the two were abreast, were they not, whereupon the lorry came over into the space my client occupied?",
#:   "The bus was coming same-same speed beside me, then slowly slowly pushing inside my lane.",
#:   "He's cruising at my elbow, not a foot ahead, not a foot behind, and then he thinks he'll have my lane as well.",
#:   "Sustained parallel running followed by lateral intrusion into ego lane.",
#:   "RIDES NEXT TO ME THEN TRIES TO TAKE MY LANE",
#:   "The truck shadowed our flank and then muscled into our lane.",
#:   "Rides abreast of us, then barges across into our lane.",
#:   "He hung at my wing mirror, then moved over on me.",
#:   "Let the lorry mirror the ego's speed before wedging into its lane.",
#:   "Level with me for ages... then he wanted MY bit of tarmac",
#:   "Coach alongside, equal speed, subsequently crowding into subject's lane.",
#:   "The police bike had kept exactly in step with us along the whole frontage, and then its rider nudged across the dashes into where we were.",
#:   "Adjacent target matches the longitudinal velocity of the vehicle under test for a defined dwell, then initiates a lateral manoeuvre into the VUT's lane at close range.",
#:   "See how that van has been glued to your side window? He doesn't know you exist, and here he comes, over the line into your space.",
#:   "Our cyclist's mirror-cam, no, sorry, our dash cam shows it: the hatchback sits shoulder to shoulder with us, then tips across the marking onto us.",
#:   "Monsieur was rolling beside me at the same rhythm during maybe ten seconds and after he has pushed himself in my corridor without the indicator.",
#:   "I lost my front wing because the bus, having travelled wheel to wheel with me since the lights, took it into its head to claim the lane I was in.",
#:   "It was eerie, that ambulance. Whatever I did with my foot it did too, so that its door stayed beside my door like a picture on a wall; and then, quite calmly, it came sideways and there was no longer any lane left for me.",
#:   "Bug from yesterday's run. NPC truck holds zero relative speed next to the ego for a second or two, nose slightly proud of ours, then slides across the divider and occupies our lane. Planner had assumed it would stay on its own side as nothing had changed before.",
#:   "On approach the other driver neither dropped behind nor drew away from Vehicle 1. They were side against side. According to Witness B, the pickup then closed in from the neighbouring lane until Vehicle 1 had to give ground, although there was plainly no gap for it.",
#:   "Podcast guest: so there's this motorbike tucked in next to me, same pace to the decimal, and I'm thinking he'll go any moment. He doesn't. He just shuffles over, inch by inch, till he's in the lane I'm driving in.",
#:   "Cab alongside us like a Siamese twin for the whole straight, then it tilts over the line and elbows us out of our own lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: changing lanes, same direction; own code"
#: [slots]
#: actions = ["pace", "cut-in"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 32.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -4.0
#: high = 4.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"

param OPT_ADV_DISTANCE = Range(0, 32)
param OPT_ADV_AHEAD = Range(-4, 4)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, min(7, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2), 16, 1.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and abs(headway(advLane, ego, self)) < 8
    do PaceOnPath(advLane, ego, min(7, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2), 16, 1.5) for 1.5 seconds
    do PaceOnPath(egoRoute, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 2.5)
