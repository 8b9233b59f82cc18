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
