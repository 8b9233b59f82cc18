#: description = "The crossing car launches into a left turn in front of the ego, gaining speed."
#: rephrasings = [
#:   "he guns it out of the side road and swings left right across us",
#:   "Vehicle 2 accelerated from the stop line into a left turn across the path of Vehicle 1.",
#:   "from the line, full throttle, left, across our bows",
#:   "The target, waiting at the line, accelerates into a left turn that crosses the lane of the VUT.",
#:   "The motorcycle starts with much gas and turns left before the ego.",
#:   "A biker snatches a gap and storms round to the left.",
#:   "The police car sprints off to its left with squealing tyres.",
#:   "Foot to the floor, the taxi nips left ahead of us.",
#:   "He shot out of the side road, swinging left in front of me and picking up speed all the way.",
#:   "Unit 2 accelerated hard into a left turn from the cross street ahead of Unit 1.",
#:   "Side-road car floors it, L-turn ahead of ego.",
#:   "The crossing target begins a left turn in front of the VUT with increasing speed.",
#:   "The motorbike from the side street turns left before me with a lot of gas.",
#:   "Cross-traffic actor does a hard-throttle left turn out in front of us; not from the opposite direction, no stop.",
#:   "He came out of the side street like a cork from a bottle and swept round left ahead of her, faster and faster.",
#:   "That one waiting on the side's going for it, he's booting it round to the left in front of you.",
#:   "she shot outta the side street going left right in front of us n kept speeding up",
#:   "A car burst from the side road, wheeling left before traffic and gaining pace throughout.",
#:   "You emerged from the minor road, to the left, ahead of my client, with your foot hard on the accelerator?",
#:   "From the side road he came fast, taking left in my front, increasing speed some more.",
#:   "Bursts out of the side turning and slings it left under my nose, faster by the yard.",
#:   "Accelerated left turn of cross traffic ahead of ego.",
#:   "CAR LAUNCHES OUT OF SIDE STREET, LEFT TURN IN MY FACE",
#:   "The police car sprang left out of the side road, quickening.",
#:   "Minor-road Subaru catapults itself into a left turn ahead of the AV.",
#:   "Left out of the cross street, revs climbing, inches from us.",
#:   "Make the motorbike at the give-way go left before us under full power.",
#:   "Quicker and quicker, the cab rounded leftwards out of Vine Street past our nose.",
#:   "Crossing traffic, left turn, speed building from zero, ego in the way.",
#:   "A saloon that had been held at the mouth of the side road took its chance, piled on the power and went round to its left in front of our car.",
#:   "Starting at the line of the intersecting road, the target follows a left-turn path ahead of the VUT with a continuous positive acceleration of 3 m/s².",
#:   "Witness was on the bench outside the bank and saw the ambulance pull from the lane by the bank, bearing left across the traffic and putting on speed all the while.",
#:   "I'd like a car from the intersecting street which, just as the robotaxi arrives, steers left ahead of it and doesn't ease off but keeps pressing the gas.",
#:   "L'auto at the side street, he starts with all the force, he turns to his left before my nose and he becomes only faster in the curve.",
#:   "The lad in the Fiesta's looking your way from that side road, he's thinking about it, and he's off, left in front of you, gunning it the whole way round.",
#:   "I was going straight on past the end of Quarry Lane and there was a biker waiting in it, one boot down. He gave it a fistful, pulled out and heeled over to the left right in front of my wheels, gaining speed with every yard he travelled.",
#:   "V2 had halted on the minor leg, perpendicular to V1's travel. Its operator entered the intersection under heavy acceleration, steering left. Data from V2 shows eleven mph as it crossed the first lane and twenty-four mph on completion of the turn ahead of V1.",
#:   "Blue lights coming out of the station road on my right, no siren. The fire engine dug its back wheels in and made its left, swinging by my front bumper, and I could hear the thing winding itself up through the gears while it was still in the bend.",
#:   "Typical for taxi men at six in the evening. They don't wait in the side street for a hole in the traffic, they make one: foot down, wheel to the left, across your bonnet, and the closer you come the harder they push the accelerator.",
#:   "Sim note on timing: the actor stands at the end of the crossing arm, not the opposite one. When the ego is near it begins a left turn through the ego's path, and because its throttle is held down, it is much faster at the exit than at the entry.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-left", "accelerate"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.3
#: high = 0.6
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_THROTTLE = Range(0.3, 0.6)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
