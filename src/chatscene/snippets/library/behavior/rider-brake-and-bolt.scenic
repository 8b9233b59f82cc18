#: description = "The rider rides out across the lane, brakes in it, puts a foot down and then tears off to the other side."
#: rephrasings = [
#:   "A biker comes out, slams the brakes on in our lane, then guns it across.",
#:   "The bicyclist stopped abruptly while crossing the lane and then accelerated to clear it.",
#:   "bike crosses, brakes mid-lane, then accelerates over",
#:   "The two-wheeler interrupts its crossing by hard braking and resumes it with strong acceleration.",
#:   "The scooter goes across, makes a full brake, then goes away fast.",
#:   "A courier sees us, grabs the levers, reconsiders and pedals like mad.",
#:   "The moped rider halts startled in our way and then opens the throttle.",
#:   "She hits the brakes in mid-crossing, wobbles upright and sprints clear on the pedals.",
#:   "lad on a pedal bike came out over the lane, pulled up, put his foot down on the tarmac and then pelted off over the far side",
#:   "The motorcyclist rode across the lane, stopped in it with one foot on the ground, and then fled to the opposite side.",
#:   "Cyclist X-ing: brakes in our lane, foot down, then sprints off over.",
#:   "The bicyclist target crosses, halts within the VUT's lane, pauses and then completes the crossing at high acceleration.",
#:   "The bike rides across, stops in my lane with the foot on the street, then goes very quick to the other side.",
#:   "Two-wheeler crossing with dwell in lane: ride out, brake, foot down for ~1 s, then max accel to the far kerb.",
#:   "She had wheeled out before them, stopped and stood astride her bicycle, and then as suddenly was off like a hare.",
#:   "He's ridden out, he's stopped in your lane, toe on the floor, and whoosh, there he goes to the other side.",
#:   "bike came across, slammed the brakes right in our lane, foot down, then zoomed off the other side",
#:   "A moped rider pulled up midway over the lane, steadied himself with a boot, then fled to the far pavement",
#:   "You stopped your bicycle in the lane, placed a foot on the road, and then made off with all haste to the opposite side?",
#:   "Cycle fellow crossing, in the middle put brake and one leg down, then vroom gone to other side",
#:   "Out he comes, stamps on it dead ahead of me, one trainer on the tarmac, then scarpers over the far side",
#:   "Crossing two-wheeler with intermediate stop in lane and abrupt flight to the far side",
#:   "Scooter stops in front of me mid-crossing then ROCKETS away",
#:   "The courier propped mid-lane, then scooted over.",
#:   "Rides out, brakes before us, toe down, then scoots off across.",
#:   "Cyclist stops mid-lane with one leg planted, then dashes over.",
#:   "Crossing biker: brake in lane, foot on tarmac, full-throttle exit.",
#:   "bmx kid crossing, brakes in my lane, foot down, then flees over lol",
#:   "Motorcyclist crosses, pulls up in our path, props, blasts clear.",
#:   "A scooter rolled across from the side, jammed on its brakes before us, stood there a moment on one leg and then shot to the other kerb.",
#:   "Let the delivery rider come out over the AV's lane, stop in it with one shoe down, and a second later sprint for the far side.",
#:   "The rider target is to cross at normal speed, brake inside the VUT's lane, stand briefly, and leave across the lane at its maximum acceleration.",
#:   "He had one boot on the asphalt and was staring at us; then, just as I got the horn to sound, he took off and was over.",
#:   "The cyclist has crossed until my lane, there he has braked and put one foot on ground, and after that he escaped very fast to the other border.",
#:   "Caller almost hit a moped: it was coming across, stopped square in his lane, rider dabbed a foot, then it belted over to the verge opposite.",
#:   "I was on the ring road when a girl on a bicycle came straight out of the cycle path and over my lane. She saw me, hauled on both levers and put her shoe on the ground. Then she stood up on the pedals and fairly flew to the other side.",
#:   "V2, a motorcycle, entered the roadway from the right and was braked to a stop in V1's lane. The rider supported the machine with his left foot for about one second. He then departed at maximum acceleration, transversely to the road, and reached the opposite verge without contact.",
#:   "It's the indecision and then the violence of it that we want to capture. The biker rides out across us, throws the anchors out in the middle of our lane, wobbles onto one foot as he sees us coming, and then explodes away toward the far pavement.",
#:   "My neighbour's boy did it to me on his bike, the little devil. Out of the gateway and over the road, brakes squealing in front of my car, one foot down to steady himself. He grinned at me, and whoosh, he was across and up the bank on the other side.",
#:   "Nobody teaches them, that's the trouble. They come across you, they take fright and stop right where you want to be, leg out for balance like that lad on the scooter. And while you wonder what next, he has twisted the throttle and vanished over to the other kerb.",
#:   "Over our lane, brakes on, one toe down, zoom to far kerb.",
#:   "Biker halted across our bows, steadied himself by a boot, then vamoosed over.",
#:   "Crosses, clamps up mid-lane, props, bolts for the other side.",
#:   "The girl on the moped came across, jammed to a standstill before our car with a leg out, and then blasted off to the opposite verge.",
#:   "Two-wheeler crossing, interrupted by firm braking and a short foot-down dwell in the ego lane, completed by a sprint to the far edge.",
#:   "What sort of a rider comes over the road, stops bang in your lane to dangle a foot, and then flees for the far pavement?",
#:   "That delivery boy was crossing, in the middle he pressed brake, put down leg, looked at me, and like arrow he went to other side.",
#:   "Have the cyclist ride across, pull up with one shoe on the ground in front of the ego, and only then race to the opposite kerb.",
#:   "Because I'd hooted, the lad skidded to a stop on our side of the road, one foot planted; because I'd braked, he then hared off across.",
#:   "I have his trainer to thank, or rather the sound it made slapping down on the wet road. That made me look up, and there he was astride his bike, across my lane, as still as a heron. He'd come from the left. He left to the right, like a shot off a shovel.",
#:   "The scooter emerged from the alley and took to the roadway at right angles to V1's direction. In V1's lane its rider applied the brakes, came to rest, and supported himself on his left leg for a second or thereabouts. With wide-open throttle the scooter then quit the roadway on the far side.",
#:   "The tracker's opinion changes three times: crossing, stationary, crossing very fast. When it's stationary the bicycle is exactly on our path and the skeleton model shows an ankle on the asphalt. We relied on it staying. A second afterwards it's accelerating as hard as legs can manage toward the opposite footway.",
#:   "Well, that was a circus. First he wobbles out over us from the footpath, then he loses his nerve, brakes, puts his foot down right in front of you. And you did well not to go, because he found it again, his nerve, and off he went over the road like a scalded cat.",
#:   "You hear my front wheel lock at 1:12, that's the bike in front of my bike. The courier had come over from the right and anchored up square in my path, clipped out, one cleat on the floor. Don't ask me why. Then it was out of the saddle, full gas, gone between the parked cars opposite.",
#:   "It was a very small motorcycle with a very large man on it. It bore him out across our lane, and there he bethought himself, squeezed what there was to squeeze, and stretched a leg to the ground. I had time to see his moustache. The little engine shrieked and he was over and up the bank.",
#:   "Everything that had been moving stopped: the van, the bicycle before it, the wheel of the bicycle that had been ticking its way over the road. The rider's sandal was on the stones. What moved first was the sandal, and in a flurry of knees boy and bicycle were on the other side and out of sight.",
#:   "We shall need a crossing rider in three movements. He sets out over the road at an ordinary speed, brings the machine to rest with a foot on the ground inside the AV's lane, and after the dwell makes for the other edge at the highest acceleration the model permits.",
#:   "Dispatch, be advised, near miss outside the school. Kid on a mountain bike came out over both lanes, saw the bus, stopped dead in front of it straddling the crossbar, one foot down. Bus has stopped too. Kid then pedalled like mad to the opposite sidewalk and is long gone.",
#:   "In the left of my windscreen he came in, in the middle he stood and in the right he flew out. The standing was the worst, for the foot was on the ground and the motor of his Vespa only murmured, and I thought he gives me the way. But no, vroom, and over.",
#:   "I braked and he braked and for a moment we were both of us waiting on the other. He had his boot on the white line, he'd come across as far as that in front of me, see. Then he dropped the clutch, that motorbike nearly jumped from under him, and he was in the field gate opposite.",
#:   "Moped athwart us: brake, boot on road, brap, other verge.",
#:   "Cyclist coming over, anchors in our lane, tiptoe, then vanishes across!",
#:   "Over she pedals, halts before us, toes the ground, bolts on.",
#:   "His heel had been on our tarmac for a second, no more, when he stood on the pedals and flung the bike over to the opposite hedge.",
#:   "The courier's crossing has four beats, out from the right, brake in our lane, shoe down, explosion to the left-hand pavement.",
#:   "There was a squeal, a boot scraping the road right in front of us, and then a snarl, and the trail bike had finished its crossing in the ditch opposite.",
#:   "Bicycle from side street: transverse entry, halt on VUT path with one-leg support, dwell one second, remainder of crossing at sprint speed.",
#:   "I need a kid on a BMX who rides over, clamps up in front of the bus, props himself with a leg and then flees to the far kerb.",
#:   "The scooter girl she came over from the left, made stop before me, one sandal on the floor, and whoosh, like a shot to the other side.",
#:   "I've still got the picture, because of how he balanced: left foot on the white dash in the middle of my lane, right foot on the pedal, chin on his chest. He had ridden out from the farm and braked when he saw us. It's a picture of nothing, mind, taken a second later; all it shows is the other hedge, shaking.",
#:   "The chap with the ice cream bell was on his way over, and I'd slowed for him to trundle across. His front brake bit. Down came a plimsoll. So I stopped, since with a bicycle planted in your lane you stop, and when I'd stopped, what does he do but tinkle and take off for the prom like a greyhound.",
#:   "Count the feet on the road, I tell them. A rider with no feet on the road is coming through; one foot on it, he's staying. And along comes this lad on the motocross to make a liar of me. Out of the gap, stop in our lane, one foot down, staying, I say. Bang, he's in the gap on the far side.",
#:   "Regarding the second near miss: the two-wheeler's kinetic profile falls into three. It traversed as far as the centre of our lane at 15 km/h. It was then at rest there for 1.2 s, leaning to the left on its rider's leg. It then departed crosswise with all the acceleration it had, and it had left the road when we would have met.",
#:   "My wife says you could have put a coin between the letting go and the getting away. I mean that the courier had hardly got to a stop in front of us, with his toe on the cat's-eye to hold himself up, and we had hardly begun to breathe; then he'd snatched the toe up and the far kerb had him.",
#:   "We heard three things behind the wall of spray. There was a motor coming across from the right, blat, blat, blat. That stopped in front of us with a chirp, and we made out a leg, in yellow waterproof, straight as a post. The third thing was the motor again, flat out, and the leg folded and was away over to the left.",
#:   "A heron does it like this, said the child. It comes walking, and it stands on one leg, and then it flies. It was a postman with a red bicycle. He came over our road and put the one leg down in front of the car and stood on it and looked, and then he flew to the other side.",
#:   "All units, the suspect's on a stolen e-bike. He was crossing Pine from the park when he ran out in front of the delivery robot, grabbed the brakes and dropped a foot in its lane. Robot stopped. He looked it over for a second and took off, hard as that thing will go, to the north sidewalk and through the fence.",
#:   "With sixteen tonnes of gravel on, you don't enjoy surprises, and she'd three for me. Surprise the first, a pushbike from the side, straight over my road. Surprise the second, it halts under my nose with her espadrille on the deck. I'm standing up on the pedal. Third, she's up out of that saddle and off over the far side like a rocket.",
#:   "He rode out from among the stalls with the pannier swaying, and with the pannier swaying he stopped; the lamps of the van had pinned him. One toe sought the cobbles and found them. For as long as a match takes to flare he was a statue. When the match went out there was a clatter on the opposite side, and it was he.",
#:   "In the insurance form it asks \"position of the other at the moment of danger\", and I drew her motorbike square in my lane with a stick for the leg she put out. Then I'd to draw the arrows. One comes from the left to the motorbike, quite short. The other starts at the motorbike, goes to the right and off the paper, with speed lines.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "hesitate", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.8
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it rides out"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 1.25
#: unit = "m"
#: meaning = "how far from the ego's line it stops"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 1.2
#: unit = "s"
#: meaning = "how long it stands"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it tears off"

param OPT_ADV_SPEED = Range(2.8, 5)
param OPT_ADV_DISTANCE = Range(8, 28)
param OPT_STOP_DISTANCE = Range(0.2, 1.25)
param OPT_STOP_TIME = Range(0.3, 1.2)
param OPT_ADV_SPRINT = Range(5, 9)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED + 2 * globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPRINT)
