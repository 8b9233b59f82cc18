#: description = "The car noses slowly into the intersection, then dashes across."
#: rephrasings = [
#:   "he edges out bit by bit and then suddenly goes for it",
#:   "Vehicle 2 crept forward into the intersection, then accelerated rapidly across.",
#:   "creeps out, then full gas over",
#:   "The target enters the junction at walking pace and then accelerates strongly across the path of the VUT.",
#:   "The car comes out slowly slowly, and suddenly it jumps forward.",
#:   "A taxi inches forward to see better and then bolts over.",
#:   "The biker rolls out gingerly before opening the throttle wide.",
#:   "First it pokes its bonnet out, then it sprints across.",
#:   "He inched his nose out into the crossroads, bit by bit, then went hell for leather over it.",
#:   "Unit 2 edged slowly into the intersection and then abruptly sped across.",
#:   "Van creeps in, then guns it across.",
#:   "The target vehicle enters the junction at very low speed, then accelerates strongly to clear it.",
#:   "First the car goes slow slow into the crossing, then very fast over.",
#:   "Two-phase actor: sneak into junction at crawl, then punch it.",
#:   "It poked out its snout as though testing the water, and then it made a mad bolt for the other side.",
#:   "See him sneaking out, he's peeping, he's peeping, and now he's made a run for it.",
#:   "he was like slooowly poking out n then BOOM across",
#:   "A van stole into the intersection at a crawl before shooting over to the far side.",
#:   "You ventured out by degrees, sir, and having ventured you then made all haste across?",
#:   "First he is coming little little into junction, then suddenly he ran the car to other side.",
#:   "Sneaks his bonnet out an inch at a time, I slow down for him, then he legs it over anyway.",
#:   "Tentative intersection entry of crossing vehicle followed by rapid clearance",
#:   "CREEP... CREEP... ZOOM! Nearly got him",
#:   "The truck tiptoes into the crossing and then bolts.",
#:   "Pickup peeking out at the crossroads, peeking, then whoosh, straight over.",
#:   "Ambulance: dead-slow entry to the junction, then rapid clearance to far side.",
#:   "I want a rider who sidles into the junction and then blasts over.",
#:   "Zuerst it feels forward into the crossing, after this it sprints over.",
#:   "a bit out, a bit more out, then WHAM floored it across",
#:   "From the side street a lorry stuck its cab out foot by foot, and just when I'd made up my mind to go, it thundered over ahead of me.",
#:   "What are we to make of a driver who slinks into the intersection like a burglar and then leaves it on the other side like a getaway car?",
#:   "The SUV finished its crossing at a furious rate, although it had begun it at barely a trickle, its bumper nudging out past the hedge.",
#:   "Phase one: target advances into the intersection at 1 m/s. Phase two: target applies full throttle and vacates the conflict zone on the opposite side.",
#:   "Let him poke about in the mouth of the junction, he can't see yet. Hang on, he's made his mind up now, he's belting over.",
#:   "V2 protruded gradually into the intersection from a side road before its operator abruptly gave it full power and shot through to the opposite leg.",
#:   "I was on my bicycle, so I read front wheels. This taxi's were turning ever so slowly as it stole past the give-way line into the crossroads, and I thought he'd seen me; then the engine barked and he'd scooted over to the other side in a blink.",
#:   "My client maintains that the fire engine was almost stationary when its cab emerged into the junction. It then, in a complete change of manner, was driven across with great haste, so that the distance which had seemed ample to her was ample no longer.",
#:   "Dash-cam from a reader in Leeds: hatchback comes from the left, the bonnet slides into view, a bit more bonnet, a bit more, painfully timid. And then it's as though somebody's stung the driver, because he simply hurls the thing over the crossroads before the camera car gets there.",
#:   "The ego approaches an ordinary crossroads. A motorcyclist from the cross street should first dribble into it, feet almost down, to see round the parked lorries, and once we are near he should crack the throttle and streak to the far side.",
#:   "Sir, the tempo truck from side road was coming inch, inch, inch only into the junction, so I thought he is giving me way. When I reached near, the driver pressed full race and rushed it to the opposite road.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.5
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it noses out"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -7.0
#: high = -3.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 1.0
#: unit = "s"
#: meaning = "how long it pauses before it dashes"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(0, 20)
param OPT_SLOW_SPEED = Range(1.5, 3)
param OPT_STOP_DISTANCE = Range(-7, -3.5)
param OPT_STOP_TIME = Range(0.3, 1)
param OPT_THROTTLE = Range(0.7, 1)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advMeeting) < 12 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until self.pose[3] > 1 and distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
