#: description = "The car cuts in front of the ego and weaves from side to side there."
#: rephrasings = [
#:   "Some joker pulls in ahead and snakes about so we can't get by.",
#:   "Vehicle 2 changed into the lane of vehicle 1 and then swerved repeatedly within it.",
#:   "Cut-in followed by snaking in our lane.",
#:   "The target merges in front of the VUT and continues with lateral oscillation.",
#:   "It goes in our lane and makes zigzag before us.",
#:   "A show-off on a motorbike drops in before us and slaloms.",
#:   "The lorry moves over on us, its trailer swinging left and right.",
#:   "A drunk comes across from the next lane and staggers on under our nose.",
#:   "idiot on a scooter dived in ahead of me and then wouldn't hold a line, wiggling about all over the lane",
#:   "Suspect moved in directly ahead of the victim's car and then drifted left and right within the lane several times, possible DUI.",
#:   "Van: in front of us, then snaking in lane.",
#:   "After cutting in, the target oscillates laterally about the lane centre ahead of the VUT.",
#:   "The car goes in before me and then he makes like drunk, left and right in my lane.",
#:   "Post-merge NPC should apply sinusoidal steering within our lane instead of tracking the centreline.",
#:   "The bus had bullied its way in, and there it swayed before them like a cow going home.",
#:   "He's pinched your space and now he's wobbling to and fro right in front of you, don't try to pass him.",
#:   "she jumps in front of us and starts swerving side to side like shes texting",
#:   "The patrol car took up a place before the shopper and wandered from edge to edge, holding her back",
#:   "Having inserted himself before my client, did you or did you not then wander all over that lane?",
#:   "Rickshaw style he comes inside ahead of us and then left-right left-right he is dancing in our lane",
#:   "Nicks my space, then he's waltzing about in it so I can't get by either side",
#:   "Lane intrusion ahead followed by unstable lateral motion within the lane",
#:   "Van cuts me off then starts WOBBLING everywhere",
#:   "The scooter hopped in before us and shimmied.",
#:   "Moves over right ahead of us and then can't keep straight.",
#:   "Pickup squeezes in before the AV and wanders lane edge to lane edge.",
#:   "He barges in front, then tacks like a sailing boat.",
#:   "Taxi takes our gap and starts zigzagging before our bonnet.",
#:   "I want a motorbike that slots in ahead, then swings from side to side.",
#:   "The minibus forced its way into the space before my bonnet, and from then on it lurched left, right, left, never settling.",
#:   "Having changed lane closely ahead of the ego, the target continues with a repeated side-to-side motion within that lane.",
#:   "First the lorry is coming into my lane near before me, and after he swims from one line to the other line.",
#:   "Why would anybody nip into a gap that small and then spend the next half mile rolling about in it like a drunken sailor?",
#:   "Dispatch, silver saloon just jumped in ahead of a cab, he's all over the lane now, left, right, might be intoxicated.",
#:   "So this ambulance shoves in ahead of us, okay, and then it's wiggling its tail the whole time, we cannot get past.",
#:   "I left a proper gap, as one does, and a lad in a hot hatch swooped into it. Then for the fun of it he kept swinging the nose to one side and the other, so that I didn't know where to look.",
#:   "V2 merged into the space immediately preceding V1. Following the merge V2 was seen to oscillate between the lane markings on at least four occasions, and its driver later admitted to having been awake for thirty hours.",
#:   "Hold back here. That coach has just come over into your lane right in front, and see how he's drifting to the line, back, over to the other line? Somebody's tired, so don't you dare squeeze by.",
#:   "The scooter slid into the narrow room before their radiator with a centimetre to spare. There it began a kind of dance, leaning one way and then the other, a red tail lamp swinging to and fro in the dusk.",
#:   "A caravan outfit pulled over from the next lane, tight in front of us. The thing set to snaking straight away, wagging across the lane like a dog's tail, while my wife held on to the door handle.",
#:   "Nips into my gap and then can't keep still in it.",
#:   "He's in front of us now, waltzing from kerb line to centre line.",
#:   "Ambulance swoops before our bonnet, then wags along left-right-left.",
#:   "Somebody in a hired van helped himself to the space in front of us, and there he went yawing along as if the tyres were made of jelly.",
#:   "Test step: adjacent actor moves laterally into the ego's lane ahead of it and from then on drives a sine curve about the lane centre.",
#:   "First it steals the place before me, this motorcycle, and then it is drawing one S behind the other with his wheel.",
#:   "Fire tender has barged in front of a hatchback and it's rocking about from side to side there, could be a load shift, over.",
#:   "Want a scene for the new tracker: hearse leaves the next lane for ours, just ahead, and then its rear end swims left and right for good.",
#:   "why would u shove in front of someone if ur just gonna slosh about like soup, i couldnt get by on either side",
#:   "I'd blame the wind if there had been one. A pantechnicon that had been in the lane next door came over in front of me with hardly a bonnet's length to spare, and its tail lamps then described great slow swings, now showing me the verge on the left, now the barrier on the right.",
#:   "A cow in the box, it turned out, had got loose. All I knew was that this horse trailer, having helped itself to my braking distance, would neither settle nor go straight: hazard tape flapping to the left, to the right, to the left again, with me sitting behind it and praying.",
#:   "The subject vehicle had an empty lane ahead of it until frame 2210. From 2210 to 2260 the neighbouring taxi occupies it, entering at a clearance of six metres. In all later frames the taxi's centroid oscillates about the lane axis, peak to peak 1.1 m, with a period of some three seconds.",
#:   "Did you not tell the constable that you had \"a bit of fun\" with the old lady? You put your motorbike into the space she'd left before her, and you leaned it over to one hand and to the other, over and over, grinning in your mirror, so that she dared neither pass nor press on.",
#:   "The bus must have been sliding on that black ice since the lights. It had shifted over into the lane just before our nose, and never found its feet there; its big illuminated number drifted to one side, hung, drifted to the other, and the standing passengers went with it like weed in a tide.",
#:   "Breathe out, that's it, and give him more room. He did take your space, yes, and rudely, but look at him since: nose to the left, nose to the right, nose to the left. Phone, I should think, or drink. As long as he's squirming about up there you sit back here.",
#:   "What a dance! I was with my students in the minibus when a scooter from the left lane inserted itself directly before us, and the boy who drove it had music in his ears. You could see the song: he was balancing to this side, to that side, to this side, the whole boulevard.",
#:   "Title: THIS is why I leave a gap and then regret it. At 0:14 the white pickup slides over in front, at 0:17 he starts, and he doesn't quit till the clip ends. Left line, right line, left line, ladder on the roof going like a metronome. Don't overtake one of those.",
#:   "My claim concerns whiplash from repeated braking. The other driver entered my lane immediately ahead, and afterwards never held a course for more than a second, swinging across the width of it in both directions, so that each time I thought I might go by on one side he was there again.",
#:   "On my pushbike I'd never dare what this police car did to us in the shuttle. Out of the parallel lane, tight over our front, no room at all, and then rolling left and right and left like somebody trying to warm his tyres behind a safety car. We were seasick by the bridge.",
#:   "He'd been drinking since noon and thought himself a clever driver. So he tucked the coupé in right before the little green car, neat as a pin, he thought. From the little green car they saw it differently: two red lamps lurching over to the ditch, over to the line, over to the ditch.",
#:   "First he had my space, then he couldn't sit still.",
#:   "Over into our lane, then left edge, right edge, forever.",
#:   "Stolen gap, wagging tail: coach ahead of us.",
#:   "A pickup shouldered in before us and from that moment its tail lamps went like windscreen wipers, one side, other side, so that nobody dared pass.",
#:   "After the neighbour has taken the place ahead of the robotaxi, its lateral position should swing about the lane middle in a regular rhythm, about three seconds a swing.",
#:   "We were keeping our distance like good citizens when a hearse took it away from us, and afterwards it swam before us like a carp.",
#:   "Mum asked why the ambulance was dancing, because it had jumped in front and now its back went to me, to Mum, to me, to Mum.",
#:   "The reason for my horn is that the scooter, having popped into my safety gap, then painted an invisible letter S on the lane again and again.",
#:   "Attention patrols: a minibus has forced itself in ahead of a bread van by the retail park and is now rolling from one line to the other continuously.",
#:   "Look at the rain on the road. It kept the record for a few seconds, and what it recorded was one track coming in from the next lane, close before us, and then curving to and fro between the lines, like the trail of a snail with doubts. The taxi that had made it was at the upper end, still doing it.",
#:   "It was no use looking past him. He'd nicked the piece of road in front of my bonnet without a thank-you, and whenever I leaned to see by his right, there was his right; when I leaned the other way he'd arrived there, too. A tanker, mark you. The slosh inside must have been something to hear.",
#:   "The sat-nav had just said \"continue for eight miles\". I'd a whole empty lane to do it in. Then a fairground lorry helped itself to that emptiness from the side, and its trailer took up a kind of waltz, oom to the barrier, pah-pah to the verge. I continued for eight miles at the back of a waltz.",
#:   "There are two parts in this log, and only the first is a textbook merge: from the adjacent lane, gap at the end of it seven metres. The second is why I'm writing. The motorcycle's heading then alternates, plus six degrees, minus six degrees, for as long as we have it ahead, and our speed control follows each swing.",
#:   "She flashed the lamps, but it wasn't anger that had made the man do it. He had let himself in, with inches to spare, between her and the long clear road; and there, like somebody who looks for a dropped coin, he strayed to the left of the lane, and strayed to the right of it, and could not leave off.",
#:   "Before you ask, I did see him check his mirror. The van slid across into my braking room and I thought, all right, you're in, get on with it. Get on with it he did not. His ladders pointed at the hedge, then at the oncoming, then at the hedge. I hung back, I'd seen a load come off a van like that.",
#:   "V2 moved from the number one lane to the number two lane approximately 25 feet ahead of V1. Over the next half mile its brake lamps remained dark, yet its lateral placement varied, in the words of the V1 operator, \"line to line, like a dog on a leash.\" V2's steering linkage was later found to be loose.",
#:   "On my commute I have a cat's-eye count going, I'm that bored. The fellow in the camper who'd butted in ahead of me was covering the left row, then the right row, then the left. You couldn't have got a bicycle by him. Not once, in two miles, did I see both rows at the same time.",
#:   "He put himself before my nose like the cork in the bottle, this police moto, and I've waited that he makes me a sign to stop. No sign. He was only balancing, a bit at left, a bit at right, a bit at left, in the same lane always, for warm up his tyres I suppose. Me I was sweating.",
#:   "Your honour saw the video. A space opened before the plaintiff; the defendant's van, from the adjoining lane, was in it before one could say knife. What follows, I put it to you, isn't driving. The rear doors go over to the one marking, back over to the other, and so on, till the film ends.",
#:   "rear seat of the robotaxi, half asleep. audi dives in right in front, ok whatever, our car brakes. then the audi starts doing like a slalom with no cones?? inside our lane, side side side side. my drink was going round in the cup in time with it. driver was eating noodles, WITH CHOPSTICKS",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "weave"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 38.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 1.0
#: high = 7.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.5
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.8
#: high = 1.3
#: unit = "m"
#: meaning = "how far it swings to either side"

param OPT_ADV_DISTANCE = Range(10, 38)
param OPT_ADV_AHEAD = Range(1, 7)
param OPT_ADV_SPEED = Range(2.5, 5)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.3)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(egoRoute, 6) until abs(offsetFrom(egoRoute, self)) < 1
    do WeaveOnPath(egoRoute, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 3.2)
