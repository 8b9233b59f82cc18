#: description = "The rider comes into the ego's lane, makes a U-turn in it and rides back to the side it came from."
#: rephrasings = [
#:   "A cyclist rides out, loops right round in front of us and goes home again.",
#:   "The bicyclist entered the roadway, executed a U-turn in the travel lane, and returned to the shoulder.",
#:   "bike out, loops in lane, back",
#:   "The two-wheeler enters the VUT's path, turns through 180 degrees and leaves on the same side.",
#:   "The scooter comes on the lane, makes a circle and drives back.",
#:   "A teenager circles on his BMX through our lane.",
#:   "The moped rider has forgotten something and wheels about before our bumper.",
#:   "She pedals off the kerb, does an about-turn and vanishes where she came from.",
#:   "A lad on a bike swung into my lane, did a loop in it and pedalled off to the same side he'd come from.",
#:   "The cyclist rode into Unit 1's lane, reversed direction within it and returned to the side of the road from which he came.",
#:   "Bike in from side, 180 in ego lane, back to same side.",
#:   "The cyclist target enters the VUT's lane, turns through 180 degrees in it and leaves towards its side of origin.",
#:   "The bicycle comes in my lane, makes a round and rides again to his side.",
#:   "VRU loops: enters our lane, turns about inside it and exits where it came from; never reaches the far kerb.",
#:   "She rode out before him, described a neat half circle, and went back to the pavement she'd left.",
#:   "He's only circling round, that kid on the bike; into your lane, about-turn, and back to his own pavement.",
#:   "kid rode into our lane, did a donut basically, and went back where he came from",
#:   "A young cyclist wheeled about in the traffic lane and made for the kerb he had left.",
#:   "You entered the lane, described a half circle in it, and regained the side from which you set out?",
#:   "Scooter came into my lane, took one round there, and went back to same side again.",
#:   "Comes out in front of me, does a twirl like he's on the ice, back to the same kerb.",
#:   "Turnaround of two-wheeler inside ego lane with return to side of entry.",
#:   "BIKER DOES A U-TURN IN MY LANE AND GOES BACK",
#:   "The rider curled about in our lane and homed to his kerb.",
#:   "Kid cycles out, pirouettes in my lane, cycles back.",
#:   "Two-wheeler enters VUT lane laterally, reverses heading therein, exits same side.",
#:   "Moped pops in from the side, wheels round, off home again.",
#:   "Is that scooter only using my lane to turn round in?",
#:   "Out of the driveway, round in our lane, into the driveway.",
#:   "I want a boy on a bike to ride from the edge into the ego's lane, come about inside it and return to the edge he started from.",
#:   "She never went right across; she came as far as our lane on her bicycle, bent it round, and made for the same pavement again.",
#:   "The rider of V2 left the shoulder, turned about within the lane V1 was using, and was heading for that same shoulder when struck.",
#:   "From the right side a motorino comes into my lane, makes half turn inside of it and goes to the right side another time.",
#:   "They're practising turning circles, those two: see, the moped swings in before us, round he goes, and he's back by his gate.",
#:   "Half a circle was drawn on the tarmac of our lane by a biker who'd emerged from the petrol station and who went back into it.",
#:   "Our street's where the kids try their new bikes out. This little lass came off the pavement into the lane in front of the robotaxi, did a wide turn in it with her tongue sticking out, and pedalled straight back to her dad, who was on that same pavement.",
#:   "The manoeuvre of the bicycle target has three phases: it enters the lane of the vehicle under test at right angles; it then describes an arc of about 180 degrees without leaving that lane; finally it moves away to the side from which it entered.",
#:   "Wrong address, I thought, because the courier had barely ridden his scooter off the forecourt and into my lane when he looked up at the house numbers, slapped his helmet, swung the bars full lock and rode back round onto that forecourt.",
#:   "When it gets to our lane the cyclist doesn't keep going to the far kerb like every other crosser in the dataset. He curves round inside the lane, spends about two seconds going more or less along with us, then heads for the kerb he set off from.",
#:   "I was eating my sandwich in the cab. There's a track on the right, and out of it comes this motocross lad, into my lane, throws the bike round in a U right there under the windscreen and disappears up the track again. Didn't even look at the lorry.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "u-turn", "turn-back"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.8
#: high = 3.0
#: unit = "m"
#: meaning = "how far from the ego's line it begins to turn"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 1.6
#: high = 2.4
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_SPEED = Range(2.2, 3.2)
param OPT_ADV_DISTANCE = Range(2, 20)
param OPT_ADV_REACH = Range(1.8, 3)
param OPT_TURN_RADIUS = Range(1.6, 2.4)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH + 2
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # Round to the left or right, so that it first goes with the ego's direction.
    do TurnOff(3.1 if offsetFrom(egoRoute, self) > 0 else -3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
