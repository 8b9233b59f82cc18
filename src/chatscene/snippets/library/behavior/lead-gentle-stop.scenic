#: description = "The car ahead slows down gradually, comes to a stop and stands in the lane."
#: rephrasings = [
#:   "The car in front eases off little by little until it isn't moving any more, and then it blocks us.",
#:   "Vehicle 1 reduced its speed smoothly and ended up stationary in the through lane.",
#:   "Lead veh decelerates softly to zero, remains in lane.",
#:   "The target brakes at a comfortable rate to standstill ahead of the VUT.",
#:   "The truck before us is getting slower and slower and at the end it stands.",
#:   "A coach ahead glides to a halt, no drama, and stays put in our way.",
#:   "The motorbike in front rolls out softly and waits there in the middle of the lane.",
#:   "We watch the lead vehicle lose pace bit by bit until it is an obstacle at rest.",
#:   "the car ahead just eased off bit by bit till it wasn't moving at all, and stayed put",
#:   "The vehicle preceding V1 reduced speed gradually, came to a complete stop in the lane and remained there.",
#:   "Truck ahead loses speed smoothly -> v=0, stays in lane.",
#:   "The lead vehicle decelerates mildly (1.5 m/s²) to standstill and remains stationary in the lane.",
#:   "The bus in front goes slower and slower, soft, and then stands and doesn't move more.",
#:   "Lead: comfort-level decel to zero, then hold. No panic stop.",
#:   "Little by little the motorbike in front had lost its pace, until it stood quite still on the road before them.",
#:   "Nice progressive braking from the one in front, all the way to a standstill, and he's not going anywhere, so wait behind.",
#:   "car in front just slowly slowly slowed down and now its just parked in our lane",
#:   "Without any drama, a bus let its speed ebb away and came to stand in the road, holding up followers",
#:   "There was no sharp braking; the vehicle before you simply lost speed by degrees and stood?",
#:   "The car in front reduce slowly slowly, then stop there nicely like his father's road",
#:   "He's tapering off, tapering off, and now we're both sat here going nowhere",
#:   "Gradual lead-vehicle deceleration to standstill; stationary lead in lane",
#:   "Motorbike ahead slows down... and down... and just STAYS there",
#:   "The lorry ahead petered out and stood.",
#:   "Bus in front: losing way, losing way, stationary. Remains in lane.",
#:   "Lead motorbike fades to nothing and plants itself before you.",
#:   "Have the ambulance we follow ease down softly and then simply stand there.",
#:   "Devant nous the truck brakes very soft until zero, and there it rests.",
#:   "The saloon ahead bled off its speed, halted, and has stayed halted.",
#:   "With the gentleness of a chauffeur carrying a bishop, the driver in front took the way off his limousine until it stood, and stand it did.",
#:   "At trigger, the vehicle preceding the ego applies no more than 1 m/s², reaches zero velocity in lane and remains so until the end of the test.",
#:   "There it was, immobile in the lane ahead of the robotaxi, having got there by a long, even, unhurried braking that nobody could have called sudden.",
#:   "When the truck in front of me runs out of diesel it doesn't jerk, it just dwindles, and so it did till it was a roadblock.",
#:   "No harsh pedal from him up ahead, feel how he's squeezing it off. Now his wheels have stopped turning, and we're stopping too, because there he sits.",
#:   "My car was following a police car which became slower by small steps, came to rest in the middle of our lane and did not move again.",
#:   "I had been behind the same coach since the market town. Round about the mill its driver began to brake, only so lightly that I hardly noticed, and he kept that up until the coach stood still in the lane. We were all still sitting behind it ten minutes later.",
#:   "To whom it may concern: the vehicle in front of mine did not stop abruptly, whatever the other side claims. It slackened its pace over a hundred metres or more, became stationary in the carriageway, and was standing there, lights on, when I was struck from the rear.",
#:   "For a baseline ACC check we want nothing dramatic. The lead car cruises, then coasts into mild braking, its velocity trickling down to nothing, and once it has come to rest it occupies the lane for good. Anything with a panic brake, or with a restart, is a different ticket.",
#:   "From up in the cab you see everything early, and I could see the biker ahead of me rolling the throttle off. He drifted down through forty, thirty, twenty, ten, put both boots on the tarmac, and there he was, planted in the lane with half a mile of lorries at his back.",
#:   "The queue was still out of sight when the van preceding the test vehicle began shedding speed, tenderly, the way one sets a cup on a saucer. By the time we reached it there was no motion left in it, and it sat squarely in the lane for the remainder of the recording.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: lead vehicle decelerating; own code"
#: [slots]
#: actions = ["slow", "stop"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.17
#: high = 0.24
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(5, 30)
param OPT_BRAKE = Range(0.17, 0.24)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
