#: description = "The car accelerates out of the side street, turning right into the ego's lane."
#: rephrasings = [
#:   "he guns it round the corner to squeeze in ahead of us",
#:   "Vehicle 2 accelerated from the stop line into a right turn ahead of Vehicle 1.",
#:   "right turn into our lane under hard acceleration",
#:   "The target, waiting at the line, accelerates while turning right into the lane of the VUT.",
#:   "The motorcycle turns right with full gas to be before the ego.",
#:   "A biker blasts out to the right into a gap that isn't there.",
#:   "The ambulance hurries off to its right just ahead of us, picking up speed.",
#:   "Without giving way, a hatchback scoots round to the right and puts its foot down.",
#:   "Someone came flying out of the side road, turning right into my lane with his boot down.",
#:   "Vehicle 2 pulled out of the side street, turned right into Unit 1's lane and accelerated.",
#:   "Side st. moto: R-turn into ego lane, full gas.",
#:   "The target emerges from the minor road, turning right into the VUT's lane under acceleration.",
#:   "The car comes quick out of the small street and turns right in my lane.",
#:   "Right-turner from the minor road jumps into our lane at full throttle; merges ahead instead of waiting.",
#:   "He whipped round the corner out of the lane and landed right in front of her, engine screaming.",
#:   "He's not going to wait at that side turning, he's hurrying out to the right, into your lane.",
#:   "he came flying round the corner to the right into our lane",
#:   "A motorcycle hurtled out of the side street, rounding to the right into the path of a van.",
#:   "You issued from the side street, rightward, into her lane, and you were quickening as you did so?",
#:   "From the small road he came out turning right into my lane, pressing full.",
#:   "Out of the side road like a cork, right-hand turn, into my lane, and no lifting off neither.",
#:   "Accelerated right-turn entry into ego lane from side street.",
#:   "SPEEDS OUT OF SIDE STREET RIGHT INTO MY LANE",
#:   "The motorcycle vaulted from the side street rightward into our lane.",
#:   "Hot hatch darts from the lane, right turn, hard throttle, our lane.",
#:   "Let a motorbike explode out of the side road rightwards before me.",
#:   "Side-street ambulance barrels out rightward, engine roaring, into my lane.",
#:   "He gunned it coming right out of the close, into my lane.",
#:   "Impatient cab, side street: turns right before us with everything it's got.",
#:   "The little Fiat had been at the give-way line, and as I came up it floored it round to the right, into my lane.",
#:   "From the small street on the side comes a motorcyclist, he bends right in front of us and he's making more and more speed.",
#:   "At the trigger the target leaves the minor arm, turning right into the ego's lane with a sustained positive acceleration of 3 m/s².",
#:   "You see him inching there at the mouth of the side road? Off he goes, right, foot to the boards, in front of you.",
#:   "Which is worse, that the police car emerged to the right just before me, or that it did so with its engine howling?",
#:   "Pedal mashed, a silver saloon swept right from Chapel Lane into the path of a district nurse, gaining pace all the way.",
#:   "There was a gap between me and the next man, not a big one. A girl in a convertible chose it, whipped the thing out of her street and round to its right, accelerating as if someone was timing her.",
#:   "V2 had slowed at the mouth of the intersecting street. Its driver elected to enter ahead of V1 and made a right turn into V1's lane under heavy acceleration, leaving a short curved tire mark and continuing to increase speed thereafter.",
#:   "This one's for the merging module. Somebody emerges from the side road, turning to the right and taking the lane we're in, and rather than dawdle he's on full power throughout, so the closing speed shrinks by itself if we lift.",
#:   "The biker had waited and waited at the end of his road. Seeing us he must have thought it now or never, since out he catapulted, heeled over to the right, and drew off down our lane with the exhaust crackling.",
#:   "I'm not fast on my bicycle, and I was about to pass the side turning. A big SUV that wanted my lane before I got there roared out of it, took its right-hander under my very wheel, and kept its foot buried.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-right", "accelerate"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.4
#: high = 0.8
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 40)
param OPT_THROTTLE = Range(0.4, 0.8)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 7) until abs(offsetFrom(egoRoute, self)) < 6
    do ThrottleOnPath(egoRoute, globalParameters.OPT_THROTTLE, 0, 9)
