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
#:   "Matched us wheel for wheel, then slid sideways into our strip.",
#:   "Get a van to run flush with us and then crowd into our lane.",
#:   "scooter level with my door 4ever then hes in MY lane, hello??",
#:   "The fire engine neither gained nor lost an inch on the ego for several seconds, and then it wedged itself over the dashes into the ego's lane.",
#:   "Longitudinal offset between the target truck and the subject vehicle is held near zero; thereafter the target reduces the lateral offset until it occupies the subject's lane.",
#:   "Since the toll booth a silver estate had been driving at my elbow as if tied to me, until it decided, without a glance, that my lane suited it better.",
#:   "He is keeping same speed by my side, not going front, not going back, and then he is giving side cut and putting his vehicle into my lane.",
#:   "Now look to your side: that minibus has been keeping you company door for door, and here he comes leaning over the line, so hand him the space.",
#:   "Did you not, having run abreast of the coach for the whole of the flyover, then steer across the broken line into the lane it was in?",
#:   "It happened on the three-lane bit by the stadium. An SUV was next to us and stayed next to us, the driver bobbing to his music at precisely our fifty-five. After a bit its wing mirror began to grow in my side window. There was paint from our door on it when we'd both pulled up.",
#:   "V2, an articulated lorry, occupied the adjacent lane with its cab in line with V1's front axle. Both speeds were 62 km/h and had been equal for at least four seconds. V2 then moved laterally and encroached upon V1's lane; V1's driver sounded the horn and yielded the width.",
#:   "I want the neighbour not to overtake and not to drop off: it should simply match whatever the robotaxi is doing for a couple of seconds. Then it comes over, with far too small a gap, and takes up station in the robotaxi's own lane so that the robotaxi has to let it in.",
#:   "My little girl was waving at the people in the bus, that's how near and how steady it was, window beside window the entire way. She stopped waving when the window came towards her. The bus was tipping over the white line into where we were driving, and I had to lift off.",
#:   "There is a sort of driver who can't see what's next to him, because what's next to him never moves. I was what's next to him. We rolled on like two cars on one train, me and this cab, and when he'd forgotten I existed he pushed in where I was.",
#:   "The motorcycle had been a steady shape at the edge of the windscreen, and Paul, grown used to it, no longer looked. It drew no nearer to the horizon than he did. So when the shape leaned and came in over the dashes, it was as though a piece of furniture had crossed the room.",
#:   "Ticket 5120, side-by-side squeeze. Adjacent actor tracks our speed, offset about half a car length, for the dwell time. Then its path switches to ours while overlap still exists, and we end up with it in our lane a couple of metres off our bumper. Blind-spot warning came, reaction did not.",
#:   "I make deliveries by e-bike and had the two of them ahead of me. The lorry and the small Renault were like a couple out dancing, same tempo, side against side. Then the lorry wanted the Renault's half of the floor, and just moved over into it, little by little, horn or no horn.",
#:   "We Spanish drive near, but this was too much. The ambulance without siren went parallel to me at identical velocity, I could touch its cross with the hand. And then, poco a poco, it has introduced itself in my lane, me being still in it!",
#:   "You'd normally expect somebody beside you to go ahead first and then change over. Not this pickup. He'd cloned my speed ever since the services, door handle to door handle, and with me still alongside he shouldered in, so that I was half on the rumble strip.",
#:   "The first thing was the scrape of the mirror, the second was his tyre on my side of the stripes. Before that, nothing: a police car and me, going along at one and the same speed, side by side, for long enough to drink a coffee. No lamps, no blinker, he just merged into us.",
#:   "Bus mirrors our speed wheel for wheel, then muscles over the dashes.",
#:   "twin beside me the whole mile, then hes sharing my lane",
#:   "Keep a van abeam for two seconds, then let it encroach.",
#:   "The police car at our flank neither crept up nor dropped away, until its wheels came over the line and we were suddenly two to one lane.",
#:   "There she hung, this scooter, dead level with the door handle, and just when I'd decided she would never do anything she started leaning on my half of the paint.",
#:   "Between us and the truck there was a constant two metres of air, for as long as a song on the radio; then one metre; then he was where we were.",
#:   "Over to Unit 4: a saloon has been running neck by neck with the school coach, it's now shouldering in on it, coach is giving up the lane.",
#:   "For the duration of the dwell phase Δx and Δv relative to the target are zero; in the subsequent phase Δy decreases until the target claims the ego's lane with insufficient room.",
#:   "Had he gone on ahead, or hung back, I would gladly have let him in. He remained at my elbow instead, and from there he pushed in on me.",
#:   "The claim form has no box for it. I was not overtaken and I overtook nobody; the coach and I had been a single broad vehicle since the filling station. Its flank then started to drift in my direction. My door mirror folded, I braked to get out of its way, and there it sat, in the lane I'd had.",
#:   "My learner keeps asking what a blind spot is. I told her it's where that ambulance has been for half a minute, its wheel turning at the exact tempo of ours. And the reason it matters is that its driver can't see you there either, which is why you've now got his rear door coming over your lane marking.",
#:   "The shade told me first. It was afternoon, the lorry stood between us and the sun, and its shadow lay on my lap without moving for the length of the viaduct. Then it slid across to my wife's lap, then the whole cabin was dark, and I had to get off the throttle because he was coming in on top of us.",
#:   "V2's position relative to V1 is unremarkable for six seconds, in that it does not change at all. At second seven the lane-departure camera of V2 registers a crossing of the common line, though V1 is still overlapping by half its length. V1 yields. At second nine, one lane contains both, V2 in front.",
#:   "There is this game children play on escalators, going down hand in hand on two of them. So went we, the cab and my Fiat, with the dashes in the middle. I was sure he has to go faster or slower if he wants anything from me. But no: he stayed as he was, and merely became my neighbour in my own lane.",
#:   "We'd an indicator tick going in the background of the tape, and it's not ours, it's the pickup's; my window was down. He's so near, and holding so perfectly still beside me, that you can hear it. Tick, tick, tick. Then you can hear my tyre on the rumble strip, since he's come over and there's only there left for me to go.",
#:   "Grandfather maintains that good manners on the road died with him at the wheel of a Rover. \"I looked across,\" he says, \"and there was a young woman in a jeep, at my very speed, putting on lipstick. I looked again, still there, other lip. I looked a third time, and her front wheel was in my lane and the rest following.\"",
#:   "Title: HE HAD ALL THE ROAD. From 0:05 to 0:19 nothing seems to happen, which is the point: the motorbike is pinned to the corner of the frame as if glued on. At 0:20 it's bigger. At 0:21 it is in the middle of the frame, on our side of the dots, and cammer's on the horn.",
#:   "Ticket says the overlap condition is not handled. Repro: neighbour in the adjacent lane with identical velocity, half a bonnet in front, stays so past the event marker. Then it steers in as though our space was free. The prediction said \"keeps lane\" to the very end, and we had to make the hole ourselves by braking.",
#:   "What I'd like is a bully rather than a racer. The fire engine should not be passing anybody; it should simply be there, flank to flank with the ego, second after second. Next it leans in, and the ego finds that the only place to be is further back, since its lane now has a fire engine in it.",
#:   "On my bicycle behind, I saw two sets of tail lamps side by side, as level as on a shelf, all along the park. Then the pair got narrower. The outer two lamps kept sliding toward the inner two until the small car's lamps went bright red and it fell behind; the big one had its lane.",
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
