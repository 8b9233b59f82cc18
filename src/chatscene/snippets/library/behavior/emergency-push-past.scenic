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
#:   "Siren in our boot, a sidestep, and whoosh, it's ahead.",
#:   "Police bike: nose to our tail, out, thundering by.",
#:   "Ambulance presses, jinks round us and is a dot.",
#:   "For the trial a fire engine shall come up until it almost touches the robotaxi's tail, then swing into the free lane and be driven by at full power.",
#:   "I had the whole grille of the paramedic's car in my mirror, a second later its flank in my window, and then just its dust.",
#:   "The doctor's car came until one metre to my back, then it broke out to the side and went away past me like a shot.",
#:   "There was no more than a breath between us and the police van before it ducked out and belted on ahead, blues going.",
#:   "We want the priority vehicle to crowd the ego's rear first and only then break out sideways and flash by under full throttle.",
#:   "mummy the nee-naw was nearly kissing our car and then it jumped to the side and zoomed away in front!",
#:   "My hearing aid whistles whenever there's a siren close, so I knew. It was whistling like a kettle, with that ambulance right on top of my boot for a second or two, and I'd hardly begun to look for a lay-by when a yellow wall tore along my right side and was gone.",
#:   "Statement of the bus inspector: the pump ladder had come down the hill behind a small car and for a moment I thought it would climb on it, there was so little between them. It swerved out to the free lane, the engine screaming, and by the zebra it had a hundred metres' lead on that car.",
#:   "What do you do when the blues are so near behind that you can only see half of them? Nothing hasty. This one gave you about two heartbeats of that, didn't he, and then he helped himself to the other lane, shot along your side, and now he's just a noise up the hill.",
#:   "In the rear camera the police car grows until the picture is nothing but radiator; it remains like that for a second and a half. Next you've got it in the side camera, blurred. In the front camera it's already shrinking, at some seventy to our forty. I couldn't have asked for a better log.",
#:   "Being overtaken by a fire engine sounds like fun until it's you. I felt its horn in my teeth, it was that close to my spare wheel. Then the pressure went to one side of me, a long red roaring thing with ladders, much faster than I was, and afterwards there was this lovely silence.",
#:   "Narrative: V1 had slowed to approximately 25 mph. A marked EMS unit reduced its spacing to V1's rear bumper to less than ten feet, remained so briefly, moved over to the adjoining lane and passed V1 at a speed the witnesses put at 65. V1's operator reported being \"rattled\" but unhurt.",
#:   "I know that they save lives, but it must not be with mine. The ambulance has stuck itself on me, horn, light, everything, no distance any more. Then it has left my lane and has pulled by with such a speed that my car was shaking, and my groceries fell off the seat.",
#:   "Behind us a blue flicker got into the cab and began to crawl over the ceiling. \"He's going to hit us,\" she said, for his lamps had sunk out of sight under our tailgate. But he heaved the thing out, and it bellowed by so fast that our wing mirror folded in.",
#:   "The shuttle didn't yield fast enough for them, that's the long and short of it. So these paramedics run right up its backside, sit there a tick to make their point, then hoof it round into the next lane and away like the clappers, and the passengers get an eyeful of stretcher.",
#:   "On the ward later I met the crew. \"We were pushing you a bit,\" the driver admitted, \"I could've read your tax disc from behind.\" I told him it wasn't the pushing that had scared me, it was when he popped out and blew past with everything that engine had.",
#:   "Marshal to control. Rapid response unit is through. It had a saloon in its way, got up to within a yard of her, hung on for a second, stepped out to the vacant lane and is now well clear of her, doing a ton by the look of it. Saloon's pulled over, driver a bit shaky.",
#:   "Siren in our spine, sidestep, comet.",
#:   "Blues kissed our boot, popped sideways and were history.",
#:   "Fire engine: on our heels, out, gone ahead like thunder.",
#:   "An ambulance crew that had almost climbed into our back seat lost patience, put it in the free lane and left us standing with the windows rattling.",
#:   "All I could read in the glass was half a word, ECNALUB, then it was beside me at the side window, and then it was a wail up the hill.",
#:   "Please stage a police car that first breathes on the AV's rear plate for a second or two and only thereupon leaves the lane and rockets ahead.",
#:   "The firemen's captain apologised: they'd been near enough to our tail to smell our exhaust before they broke out and went by at twice our pace.",
#:   "Two beats of that horn at my very back, a swing into the next lane, and the paramedic motorbike was so far on that I'd to squint.",
#:   "With what distance did the fire tender sit behind you before it swung out and blazed by, madam? One metre, sir, I felt its heat.",
#:   "Of the whole thing I have three pictures. In the first there's no road behind us but a chrome bumper and blue everywhere. In the second the bumper has gone from the mirror and a yellow-green chessboard is tearing along by my door. In the third it's before us, small, and the leaves are still coming down.",
#:   "My mother was driving me to the very hospital it came from. It stuck itself to our rear screen, howling, and she said, \"Where am I supposed to go?\" She needn't have worried. One breath later it had helped itself to the lane alongside, its engine went up a whole octave, and we were looking at its back doors.",
#:   "For the yield module the interesting part is the order. First the gap at the rear goes from thirty metres to three and is held there; our planner starts looking for a place to pull in. Then the gap in question is simply empty, because the appliance has gone into the lane next door and is coming by at plus forty.",
#:   "I braked a little, which I shouldn't have, and I heard its air brakes curse me. So near was that ladder truck that its headlamps shone over my roof on to the road ahead. The shine swung away to one side. I was overtaken by noise, then by red, a very long red, and then by a terrible wind.",
#:   "Told from the other vehicle: we'd a cardiac on board and a Micra in front. I brought her up till I could see the lady's hair grips, gave it a second for her to think, she didn't think, so I took us out round her and buried my foot. She was a dot in the mirror by the garage.",
#:   "The dog began first, it hates them. There was blue on the headrests; I could not see the thing's lights any more, they were under my window sill. So it was going to hit me, I thought. Instead the blue ran round the inside of the car like water, from the back to the side to the front, and drained away uphill.",
#:   "In Bavaria one makes a lane for them, but I had no time. The emergency doctor was at once so close that I've seen the coffee in his cup holder. A moment he waited like this. Then he has pulled on the left lane and shot away before me, and my hat was moved by it.",
#:   "Some people say the driverless car obstructed the police. I was stood at the crossing. The police van ran up on it till you couldn't have slid a pizza box between them, sat there for as long as it takes to swear, jinked out to the empty lane and went off like a firework. Obstructed for two seconds at most.",
#:   "Recorder evidence. Rear proximity alert, 14:05:31. Alert continuous until 14:05:33, the unit following with less than ten feet of clearance. Left blind-spot alert, 14:05:33. Forward camera acquires the unit, lights active, 14:05:34, pulling away at approximately 70 mph. Vehicle 1 maintained 38 mph throughout.",
#:   "You've been told to keep calm, and you did, well done. Nobody likes to be leaned on by eighteen tons of fire brigade with its horn going. What did you see next? Right, it left your mirror. And where did it turn up? Alongside, going like the clappers, and off up the road. That's all they wanted, the other lane and a bit of courage.",
#:   "wasnt even mad. cop car comes up SO close i can see him chewing, siren on, i freeze. like one second, two. then vwip, other lane, floors it, and hes past me and past the next three. my coffee did a full lap of the cupholder",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["adjacentLane", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "overtake", "fast"]
#: position = "behind"
#: place = "road"
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
