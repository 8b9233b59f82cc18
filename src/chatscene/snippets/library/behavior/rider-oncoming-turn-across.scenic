#: description = "The oncoming rider turns left across the ego's lane."
#: rephrasings = [
#:   "A cyclist coming the other way hangs a left right in front of us.",
#:   "The bicyclist approaching from the opposite direction turned left across the path of Vehicle 1.",
#:   "oncoming bike turns left across us",
#:   "The oncoming two-wheeler turns left across the VUT's path.",
#:   "The cyclist from front goes left over our lane.",
#:   "A moped meeting us nips over to the petrol station on our side.",
#:   "The biker we face darts left into a driveway under our nose.",
#:   "A paper girl heading our way swings over to the houses on our right.",
#:   "A cyclist coming towards me just swung left over my side of the road.",
#:   "The opposing motorcyclist turned left across Unit 1's lane of travel.",
#:   "Bike oncoming, L turn over our lane.",
#:   "The opposing two-wheeler turns left across the lane of the test vehicle.",
#:   "The bicycle from the front turns left and passes over my lane.",
#:   "Opp. rider crosses our lane in a left turn and leaves the road, normal speed.",
#:   "The boy on the moped was coming to meet them when he leaned over and crossed to their side to take the turning.",
#:   "Biker facing you wants to go left, he's not waiting, he's going over in front of you.",
#:   "cyclist coming towards me went left right thru my lane",
#:   "A motorcyclist approaching from ahead turned left and so came athwart the car.",
#:   "From the opposite direction he bore left, and in so doing passed before my client's bonnet.",
#:   "Opposite bike took left turn over my lane without waiting for me.",
#:   "Pedal-pusher coming the other way decides he's off left, and I'm the one who has to stop.",
#:   "Left turn of opposing two-wheeler through own lane",
#:   "ONCOMING BIKE TURNS LEFT, DOESN'T WAIT",
#:   "The oncoming moped peels left over our lane.",
#:   "Scooter coming our way hooks left, straight over our lane.",
#:   "Facing pushbike: left turn, traverses ego's lane, gone off the side.",
#:   "He comes opposite with his cycle and cuts my lane for going left.",
#:   "An approaching girl on a bike bears left through our path.",
#:   "Have an oncoming motorcyclist turn left before the ego, crossing its lane.",
#:   "The postman on his bicycle was coming down the road towards me; he stuck out his left arm and without waiting rode over my lane to the cottages.",
#:   "Two-wheeled traffic from ahead made a left turn that took it clean through the strip of road in which the robotaxi was travelling.",
#:   "Motorbikes facing you that want the side road on your right have to go over your lane, and that one's leaning in to do so now.",
#:   "A moped courier heading towards V1 executed a left turn at the driveway of the restaurant and so passed at right angles over V1's lane.",
#:   "Why he couldn't wait I don't know, but the rider who was meeting us went left, right over our bit of tarmac, to the allotments.",
#:   "The cyclist target, initially moving against the VUT's direction, turns left by ninety degrees and continues straight on across the VUT's lane until it has left it.",
#:   "There's a coffee place on my side of the road and that's where she was bound. She had been pedalling along opposite, towards my car, with a basket on the front. She turned left, in a nice round bend, over my lane and up onto the forecourt.",
#:   "Unit 2 was an electric bicycle travelling in the opposite direction to Unit 1. Its rider turned left towards a private entrance, crossing the lane of Unit 1 at a distance of less than two seconds' travel, and continued into the entrance without having given way.",
#:   "As I passed the mill a motorcyclist was coming up from the village. I thought that he and I would simply pass each other. But he banked over to his left, crossed the whole breadth of the lane I had before me, and the yard gate swallowed him.",
#:   "For the urban turn-across series use the oncoming rider. At trigger distance it describes an arc to its left of small radius and then carries on straight, so that its path crosses the lane of the vehicle under test; it does not stop and it doesn't return.",
#:   "Mate, you'd think a bin wagon was hard to overlook. Bloke on a Vespa coming at me, sees me all right, gives me a nod even, and then he peels off to his left, across my lane, two yards off my bumper, and in at the chip shop.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "cross"]
#: position = "oncoming"
#: leader = false
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 11.0
#: high = 22.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 2.5
#: high = 4.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_SPEED = Range(3.5, 6)
param OPT_ADV_DISTANCE = Range(11, 22)
param OPT_TURN_RADIUS = Range(2.5, 4)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(1.5, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
