#: description = "The car accelerates, forces its way in front of the ego and pulls away."
#: rephrasings = [
#:   "He floors it beside us, elbows in and is off.",
#:   "Vehicle 1 accelerated in the adjacent lane, merged with minimal clearance and left vehicle 2 behind.",
#:   "Neighbour speeds up, tight merge, opens gap.",
#:   "The target gains speed alongside, cuts in closely before the VUT and moves ahead.",
#:   "It presses the gas and pushes inside our lane, then is far.",
#:   "A motorbike zips past the wing, dives over and leaves us standing.",
#:   "The delivery van muscles in with its engine howling and disappears up the road.",
#:   "Where the lanes merge, somebody puts on a spurt to be first.",
#:   "Cheeky git floored it, barged in front of me and cleared off up the road.",
#:   "Unit 2 accelerated past, forcibly merged ahead of Unit 1 and continued away at increasing speed.",
#:   "Moto guns it, elbows in front of ego, gone. No brake.",
#:   "Target increases speed, changes lane into a short gap in front of the VUT and continues to draw away.",
#:   "A car gives gas, pushes in before me and goes away fast.",
#:   "Rude merge but the gap opens: actor speeds up, takes our slot, then keeps pulling ahead; we should not panic-brake.",
#:   "He put his foot down, wedged himself in before her and was a dot in the distance before she'd finished swearing.",
#:   "He's going to bully his way in ahead of you and clear off, so just ease back, he'll be long gone in a moment.",
#:   "he sped up cut me off and dipped, didnt even look back",
#:   "A powerful saloon bulled its way ahead of the pensioner's car and vanished up the road.",
#:   "He gathered speed, thrust himself before my client and drew off into the distance; you saw that?",
#:   "That fellow pressed full accelerator, put himself in my front and just went off.",
#:   "Boots it, bullies his way in front of me, next thing he's a dot on the horizon.",
#:   "Forced merge ahead of ego under acceleration, with opening gap thereafter.",
#:   "CUTS ME OFF AND DISAPPEARS",
#:   "The ambulance barrelled in ahead and streaked off.",
#:   "Gets on the gas, takes the gap before us, keeps going faster.",
#:   "Fire engine surges, shoves in ahead of ego, draws off. No braking.",
#:   "It make more speed, press itself in front of me and disappear.",
#:   "Our neighbour speeds up, bags the space before our nose and leaves.",
#:   "Coupe guns past my wing, squeezes in, waves goodbye.",
#:   "A courier's van in the lane beside mine picked up speed, made me give it room at the front and then ran away from me.",
#:   "Simulate a bus which, from the next lane, puts on speed, pushes over into the slot ahead of the ego and then increases its lead.",
#:   "The artic on our left opened up, bore down on the bit of road in front of our bonnet until it was his, and roared on.",
#:   "Beside you a motorcyclist winds on the throttle; he'll nick the space ahead of you, and as he isn't slowing you needn't brake, he's only going away.",
#:   "The claimant had to yield when the other party sped up, intruded on the space before her vehicle and departed with undiminished acceleration.",
#:   "With a blip of the siren the patrol car gathered pace next to us, barged over in front, and a few seconds later we couldn't read its plate any more.",
#:   "I'd left a decent gap, as you should. Up the inside comes a pickup with its foot to the boards, makes that gap his own with about a coat of paint to spare, and then he just keeps on pulling until he's well down the road.",
#:   "The adversary starts level in the adjacent lane and is given throttle. It encroaches upon the ego's lane with little clearance to the ego's front, completes the change, and goes on accelerating so that the headway grows again; it is never braked.",
#:   "My instructor told me to let him have it. The SUV beside us was building up speed, it wanted the piece of road I was heading for, it simply took it, and by the time I had got my breath back it was two hundred yards off.",
#:   "A coach driver who was late for the ferry put on speed next to a family's car on the A20, wedged fifty seats into the room ahead of it and drove off ever faster, leaving the family shaken but with nothing to brake for.",
#:   "He told police he feared a collision as the ambulance, which had been travelling level with him, accelerated and nosed across into his lane with hardly a foot between them. It did not dawdle there, he added: it drew away from him straight afterwards.",
#:   "Throttle, elbow into our slot, and off into the distance.",
#:   "Scooter revs up, nips into our lane ahead, gone.",
#:   "He surges, wedges in ahead of me and outruns me.",
#:   "The van on our flank got a move on, helped itself to the space before our bumper and then left us for dead.",
#:   "Some lad in a tuned Corsa boots it next to me, carves in with inches to spare and just keeps going, bye then.",
#:   "The target vehicle is accelerated in the neighbouring lane, enters the VUT's lane at small longitudinal clearance and, continuing to gain speed, increases the gap.",
#:   "Bus driver behind schedule: he gives it all it has, bulldozes into the room ahead of the robotaxi and draws out of range.",
#:   "From side he is giving race, putting the nose of his lorry in my front by force, and then going away only.",
#:   "Let the fire engine gather way beside the ego, shoulder into the ego's lane close to its front, and pull clear without easing off.",
#:   "By the time I'd said a word that I shan't repeat to the insurers there was nothing left to swear at. He had wound that Transit up beside me till its engine screamed, slewed it over with my wing all but touching his back door, and taken himself off over the brow of the hill.",
#:   "The headway trace is the giveaway. It is forty metres of free road, then five, at the moment the motorcycle, having speeded up next to us, thrusts across our front; and from then on it grows, ten, twenty, fifty, because the rider never lets go of the throttle.",
#:   "I was teaching my niece to merge. Rule one, I told her, if the chap in the other lane puts on a spurt, he isn't asking. And he didn't ask: in came the estate with its rear light practically in our grille, and then it simply stretched its legs and left us in peace.",
#:   "On the day of the incident the claimant was travelling in lane two. The coach in lane one accelerated, encroached upon lane two although there was barely a car's length for it, and occupied it. It proceeded to leave the claimant's vehicle behind at increasing speed, so that her emergency braking proved unnecessary.",
#:   "I felt the air before I saw anything, the car gave a shiver. Then a wall of red was squeezing over the line on to our bit of road, with the engine note climbing. It was still climbing when the ladder at the back had got as small as a toothpick; they never once touched the brakes.",
#:   "Did I brake? I lifted, that's all, since there was a pickup's tailgate where my free road had been. He'd come up on the power beside me and butted his way over. But no need to do more: he had his foot in it all along, and the tailgate got smaller and smaller.",
#:   "Ticket 2207: false positive AEB. The actor spools up in the adjacent lane, forces a cut-in at 0.4 s gap and, important, goes on under throttle so range rate turns positive at once. Expected: soft coast; observed: full anchors on an opening gap.",
#:   "The truck on left lane was same like me. Then much black smoke from him, he becomes faster, he presses into my lane before my car so I must give him the place. After this he is always more fast and more far, I do not see him again until the toll.",
#:   "We were three abreast in the cab on our way home from the yard and none of us liked it. An ambulance, no lights, got on the gas in the lane alongside and pushed across our front as though we'd been a gap and not a lorry. There was no harm done, though, as it had pulled right away from us before the next gantry.",
#:   "There is a kind of man who cannot bear an empty space in front of another. He fed his grey saloon more and more petrol until he had his front wheels ahead of hers, he leaned it over into her lane with a hand's breadth between the two of them, and then, having won, he dwindled.",
#:   "Dash-cam notes. 0:04 you hear the V-twin opening up on the right. 0:06 the bike's rear mudguard slices into shot, way too tight, in our lane. 0:07 to 0:15 it turns into a dot, still hard on the gas.",
#:   "Revs, elbow, tail lamps, dwindling tail lamps.",
#:   "Foot down beside us, nose under ours, gone.",
#:   "Bus spurts, takes our gap by force, keeps growing smaller.",
#:   "He wound her up alongside till I'd no say in it, had the space before my bumper off me, and the next I saw of him was nothing.",
#:   "Required: adjacent motorcycle under rising throttle enters the ego's lane with a headway below 0.5 s, throttle held, so that the headway recovers by itself.",
#:   "This lorry fella beside me starts pouring on coal and leaning over, so I let him have my bit, and away he goes with never a brake light.",
#:   "My hand went to the horn when the ambulance shoved in ahead, gathering pace, but by the time it sounded there was nobody near enough to hear.",
#:   "He took speed from beside, he took my place by force, he took himself away; all what he left for me is the smoke.",
#:   "i get the merging hard part, bro squeezed in front of me like a credit card, but why was he still accelerating when he left my postcode",
#:   "It's a narrow thing, a headlamp's width, and a headlamp's width is all that there was between us. That's when I lifted. A second before, that black saloon had still been next to me with its exhaust beginning to bellow, and a second after it was two, three, six lengths up the road, and bellowing still.",
#:   "Ask yourself what you had to do about it. You eased your foot for one heartbeat, because a coach which had been putting on speed at your shoulder came over the line whether you liked it or not. You didn't brake, and you needn't have, as its back window has been shrinking ever since.",
#:   "The spray is how I know. First it was on my side window, and coming thicker, for the tanker in the next lane had begun to hurry. Then it was on my windscreen, the whole bucketful, with his mudflaps right behind it. And then the wipers could manage it, and then there wasn't any, because he'd run clean away from us.",
#:   "Distance to lead vehicle, in metres: none, none, none, 3.1, 4.0, 7.5, 13, 22, 40, out of range. The 3.1 is a patrol car which had been gaining speed on our left and forced itself into our lane at that point. All the figures after it are the reason why the braking command in line 6 of the ticket was unnecessary.",
#:   "Some people take your parking space, some people take your seat on the train. The lady in the red convertible took eleven feet of the A38 that I was just about to use; she'd put her foot down so as to be able to. She must've wanted the rest of the A38 as well, since she went on going faster and had it all to herself within the minute.",
#:   "Grandad keeps a yard of clear road ahead of him for the Lord, he says. The Lord didn't come, a motorbike did. We heard it screw itself up at our side, and then there was its back tyre, spitting, in the Lord's yard, right over our bumper. \"Let him go,\" said Grandad, but he'd gone already, he was smaller than the tax disc.",
#:   "The Claimant alleges that she was compelled to swerve. Engine data from the minibus are before the court: full load from a point at which it was abreast of her, full load at the moment of its entering her lane with a metre to spare, full load for nine seconds afterwards. A vehicle so driven isn't an obstruction for long.",
#:   "To begin with I saw his front wheel at my door, then only his back wheel, so he was on the gas. Then came his indicator, after the fact, as he was by then leaning on my bonnet and I was giving him the lane to keep my paint. What came after was a lot of noise going away.",
#:   "The air ambulance crew were talking about it, that's how I know whose siren it was. A rapid-response car built up speed in the outside lane next to the shuttle, wedged itself in under the shuttle's nose and drew off up the hill with its foot still in. The shuttle's passengers felt a dab, no more.",
#:   "In Marseille this one calls \"the door\". You are in your lane, content; the van at your side makes the motor scream, he advances, he shows you the door, which means his own, at ten centimetres of your wing, until you yield him the lane. Then, to be polite, he removes himself at always more speed, and you do not see him anymore.",
#:   "There was a gap in front of Miss Pym and there was a gap afterwards, a longer one; only for a breath between the two was there none. It was filled, that breath, with tailgate and the smell of hot oil. The truck that had put on such a spurt next to her to get there was not content with it, and ran on till it was a toy.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "accelerate"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -4.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 0.1
#: high = 0.8
#: unit = "s"
#: meaning = "for how long it presses the pedal"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_ADV_AHEAD = Range(-4, 3)
param OPT_THROTTLE = Range(0.5, 1)
param OPT_THROTTLE_TIME = Range(0.1, 0.8)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do ThrottleOnPath(egoRoute, globalParameters.OPT_THROTTLE, 0, 14)
