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
