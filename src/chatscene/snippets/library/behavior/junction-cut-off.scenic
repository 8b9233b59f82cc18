#: description = "The vehicle cuts off the ego vehicle at the intersection and slows in front of it."
#: rephrasings = [
#:   "A car forces its way before the ego and stays there.",
#:   "The adversary dives in ahead, leaving the ego no room.",
#:   "The other driver barges into the ego's lane.",
#:   "Coming from the side, a vehicle takes the ego's way from it.",
#:   "The crossing car slots in right before the ego's bonnet.",
#:   "he shoves in front of us out of the side road and then dawdles",
#:   "Vehicle 2 entered the lane of Vehicle 1 at the intersection and proceeded slowly.",
#:   "takes our lane at crossing, then slow ahead",
#:   "Some clown chopped me up at the crossroads and then dawdled right in front of me.",
#:   "At the intersection the defendant's vehicle pulled in directly ahead of the victim's vehicle and reduced speed.",
#:   "X-traffic barges ahead of ego at jct, then drops speed.",
#:   "The crossing target enters the VUT's path within the junction at low TTC and decelerates ahead of it.",
#:   "On the crossing a motorbike takes my way and goes slower directly before me.",
#:   "Actor steals our right of way in the intersection, then lifts off in front of us; expects an AEB response.",
#:   "He came from the side, thrust himself in ahead of her in the middle of the crossing, and then, of all things, slackened off.",
#:   "That biker's going to carve you up at the lights and then slow right down under your nose.",
#:   "got cut off at the crossroads and then he slows DOWN like wtf",
#:   "A motorcyclist forced his way ahead of the car at the junction, then eased his pace under its nose.",
#:   "At the junction you usurped my client's path, and having done so you slackened your speed; correct?",
#:   "At the signal junction he put his car in my front and then going slow slow.",
#:   "Steals the road off me at the crossing, then takes it easy right on my nose.",
#:   "Path usurpation at intersection with subsequent speed reduction ahead of ego.",
#:   "CUT OFF AT THE INTERSECTION THEN HE SLOWS DOWN",
#:   "The car poached our gap at the junction and then slackened.",
#:   "From the cross street he nabs our lane and idles along it.",
#:   "Biker enters from side at x-roads, ahead of ego, reduces to crawl.",
#:   "You are robbed of your path at the junction, then held up.",
#:   "He come from side road, block my road in cross, after go slowly slowly.",
#:   "Taxi jumps in from the side at the junction, then won't hurry.",
#:   "At the crossroads a coupe coming from the left planted itself in the lane that belonged to the AV and went on at a bicycle's pace.",
#:   "A scooter that should have let us by at the intersection pushed in under our front and then took its own sweet time.",
#:   "Let the crossing car take the ego's path away inside the intersection and continue along the ego's lane at a much lower speed.",
#:   "The insured had priority; the third party joined her lane from the side road in the junction, immediately ahead, and then proceeded at a dawdle.",
#:   "Being in such a hurry to be first at the crossing, why did the man on the motorbike then potter along in our way?",
#:   "Vehicle 1 had to slow because Vehicle 2, arriving from the intersecting road, usurped its lane within the junction and kept to a low speed there.",
#:   "I was on the main road and well into the crossing when this estate came from the right, and instead of going over it turned its nose down my road, right in front of my car. Then it could hardly be persuaded to move.",
#:   "Over to our reporter at the Elm Street lights. A motorcyclist arriving from the side street pinched the way from a driverless cab in the middle of the junction, and for the next fifty yards the cab was obliged to trail after him at jogging pace.",
#:   "The cutting-in vehicle waits in the intersecting arm. It departs when the ego is close, occupies the ego's route within the junction area at a short distance ahead, and follows that route at a constant low speed, so that the ego must slow down behind it.",
#:   "I'm fourteen stone on a pushbike and even I'd have got away quicker. This car comes out of the side arm, slap across my bows in the crossroads, straightens up ahead of me in my own lane and then mooches along as if it had a puncture.",
#:   "Rule for today, friends of the show: the person who steals your path at an intersection never wants to use it. My guy swooped in from the cross street, took the spot before my hood, and then he was sightseeing, ten miles an hour.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: position = "crossing"
#: actions = ["cut-in"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.0
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes on in front of the ego"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 11)
param OPT_SLOW_SPEED = Range(1, 5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3.5
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
