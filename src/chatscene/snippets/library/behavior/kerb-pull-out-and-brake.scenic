#: description = "The parked car pulls out, drives a little and then brakes hard to a crawl."
#: rephrasings = [
#:   "He pulls out on us, gets going and then hits the brakes.",
#:   "Vehicle 2 left the curb, gained speed and then decelerated abruptly.",
#:   "Parked veh joins, then brakes.",
#:   "The target starts from the roadside, travels ahead of the VUT and brakes strongly.",
#:   "It goes out of parking, drives some metres and brakes much.",
#:   "A lorry sets off from the side only to check itself sharply.",
#:   "The rider starts up, gets before us and grabs the brake.",
#:   "Forgot something: the driver pulls away from his space, then jams on and creeps.",
#:   "A car that'd been parked up came out in front of me, went a few yards and then stood on its brakes down to a crawl.",
#:   "Vehicle 2 left its parking space, traveled a short distance and then decelerated sharply to near walking speed.",
#:   "Parked van out, rolls few m, brakes hard, creeps.",
#:   "The parked target enters the carriageway, travels briefly and decelerates strongly to a residual low speed.",
#:   "The parked truck goes out on the road, drives short and then brakes strong and is very slow.",
#:   "Pull-out followed by a late hard decel to ~5 km/h; tests re-braking after the first reaction.",
#:   "He left the kerb well enough, had hardly got going, and then he hit the brakes so hard that he was barely rolling.",
#:   "Bus is leaving the stop, fine, but now he's anchored up and gone right down to nothing, mind him.",
#:   "this parked car comes out, goes like 5 metres, then brakes super hard n creeps",
#:   "A van left its parking spot and had barely got going when it braked fiercely to a dawdle.",
#:   "Having left the kerb you drove but a few yards before you braked severely, and thereafter barely moved?",
#:   "He came out from parking, went little bit, then sudden brake and moving like ant.",
#:   "Leaves his spot in front of me, gets up to nothing much, then bangs the brakes on and we're all down to a shuffle.",
#:   "Kerbside departure followed by severe braking to residual speed ahead of ego.",
#:   "PULLS OUT OF PARKING SPOT THEN BRAKES HARD FOR NO REASON",
#:   "A parked taxi emerged, rolled on, then choked its pace to a shuffle.",
#:   "Off the kerb, short hop down our lane, brakes, crawl.",
#:   "Cab leaves its bay, trundles off, suddenly stamps hard and inches along.",
#:   "Parked van emerges, covers ten metres, dives onto its brakes, then creeps.",
#:   "Simulate: scooter departs kerbside, rides briefly, decelerates violently, dawdles.",
#:   "He'd just unparked in front of me when he braked savagely to walking pace.",
#:   "It was crawling when I hit it, because it had braked like mad only a moment after coming away from the kerb.",
#:   "The ambulance which stood at the side goes into my lane, makes few metres, brakes with all force and then rolls like a baby stroller.",
#:   "A police car parked at the roadside moved off ahead of us, got going nicely, then shed nearly all of it and plodded on.",
#:   "Following departure from its parking position the target proceeds for two seconds, decelerates at 6 m/s² and holds 1.5 m/s.",
#:   "Do you see the parked SUV there? It comes out, has a little run, then the driver jams on the anchors and just toddles.",
#:   "Coach driver pulls away from the stop, changes his mind about speed, and stamps it down to a dribble right in front of me.",
#:   "A delivery fellow jumped into his van by the kerb and set off before me. I'd hardly settled in behind when up came the rear end, all brake lights, and from there on he poked along hunting for a house number.",
#:   "V2 was legally parked facing the direction of travel. It entered the lane in front of V1, continued some thirty feet, then braked heavily without stopping, and was moving at approximately 3 mph when it was struck.",
#:   "The old Volvo by the chemist's came to life and slipped out into the street. For a few yards it behaved; then its nose went down, its tail went up, and it proceeded no quicker than the shoppers.",
#:   "I want two surprises in a row for our robotaxi. A parked lorry gets into the lane first and gets rolling; when we've just adapted, it bites hard on the brakes and then keeps moving at a mere creep.",
#:   "So I'm pedalling along with the camera on, and this parked Corsa decides to join the road. He goes about four car lengths, brakes so hard the tyres chirp, then potters on at less than my granny's pace.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "brake", "slow"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 2.5
#: high = 4.0
#: unit = "s"
#: meaning = "how long it drives before it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(15, 34)
param OPT_THROTTLE_TIME = Range(2.5, 4)
param OPT_BRAKE = Range(0.6, 1)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), 7) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE) until self.pose[3] < 1.5
    do DrivePath(ownLane(egoRoute), 1.5)
