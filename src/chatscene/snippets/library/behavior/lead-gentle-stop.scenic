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
