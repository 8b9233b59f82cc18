#: description = "The car ahead brakes and makes a U-turn across the road."
#: rephrasings = [
#:   "The car in front of us slams on and flips a U-turn.",
#:   "Vehicle 2 attempted a U-turn from the travel lane in front of vehicle 1.",
#:   "Lead brakes hard, U-turn left.",
#:   "The target decelerates strongly and turns round through 180 degrees ahead of the VUT.",
#:   "It makes a big brake and is turning back the whole way on the street.",
#:   "The taxi before us sees a fare on the other side and whips around.",
#:   "The police car ahead does an about-turn right there to chase someone.",
#:   "A motorcyclist in front checks hard, then doubles back the way he came.",
#:   "The car in front dabbed the brakes and spun round to go back the way we'd come.",
#:   "The lead vehicle slowed and made a U-turn, blocking both directions of travel.",
#:   "Truck ahead slows, turns about, now facing us.",
#:   "The lead vehicle decelerates and performs a 180-degree turn across the carriageway.",
#:   "The bus before me brakes and turns around to the other direction.",
#:   "Lead in same lane flips heading by 180 and leaves in the opposite direction.",
#:   "He had forgotten something, it seemed, for he slowed, wheeled right about in front of her and headed home.",
#:   "Squad car in front is flipping around, hold back till he's facing the other way.",
#:   "he braked in front of me and pulled a full 180 across the street",
#:   "The car ahead slowed and then doubled back across both lanes.",
#:   "The leading vehicle checked its speed and, in full view of my client, put itself about to return whence it came.",
#:   "Front taxi slow down then make U-turn just like that, block whole road.",
#:   "Realises he's going the wrong way, on with the brakes and he's turning the whole shebang round in front of me.",
#:   "Direction reversal of preceding vehicle across the carriageway after braking",
#:   "GPS said TURN AROUND so he did, right in front of me",
#:   "The van in front slows and swivels about across the street.",
#:   "Cab ahead brakes and swings right round, now facing our way.",
#:   "Leading van slows, comes about, heads back where it came from.",
#:   "Have the ambulance in front brake and U-ie across the street.",
#:   "Biker up front checks his speed, loops round across the road.",
#:   "driver in front realised braked did a uey over both lanes",
#:   "We had been behind the coach for a mile when it hauled its speed down and turned itself round completely, sweeping its long side across the road.",
#:   "The lead target reduces its speed strongly and then reverses its heading through a full half circle, leaving in the opposite direction on the other side.",
#:   "Careful with taxis, because if one in front of you brakes with no reason he's probably about to spin the wheel and go back the other way.",
#:   "The vehicle which was driving before me has made a braking and then a half-tour on the avenue, cutting all the street in order to go home.",
#:   "Control, the pickup I was following has dropped anchor and flipped round through one-eighty, he's facing the way we came, over.",
#:   "Was my client to foresee that the lorry in front, having braked, would wheel about in the roadway and present its flank to her?",
#:   "He must have seen the parking spot on the far side, for the man in the little red hatchback ahead of me lifted, braked, and cranked the wheel as far as it would go. Round he came, over the centre line, until I was looking at his headlights.",
#:   "V1 was following V2, a motorcycle, at about forty feet. The operator of V2 braked to a near stop and turned through 180 degrees to the left across the roadway in order to travel back in the direction from which both vehicles had come. V1's driver had little time.",
#:   "Now a fire engine doesn't turn on a sixpence, but ours in front had evidently been sent to the wrong end of town. Its brake lights glared, it nearly halted, and then it came ponderously round across the whole width of the street to go back for the other end.",
#:   "Scenario request from the taxi-rank pilot: the lead car, travelling in the ego's lane ahead, decelerates sharply and performs a turn-around over the opposing lane, ending up driving toward where the ego came from. For part of this time it is broadside on and fills the road.",
#:   "Dash cam comment: everyone's slating the SUV but cammer was too close. Yes, it braked in front of him, and yes, it then doubled round on itself across the road like it owned the place, but if you leave two seconds you simply sit and watch it finish.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: making a U-turn; own code"
#: [slots]
#: actions = ["u-turn"]
#: place = "road"
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 35.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it turns round"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 6.0
#: high = 7.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_DISTANCE = Range(15, 35)
param OPT_BRAKE = Range(0.6, 1)
param OPT_ADV_SPEED = Range(2.2, 3.2)
param OPT_TURN_RADIUS = Range(6, 7)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.5
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(7)
