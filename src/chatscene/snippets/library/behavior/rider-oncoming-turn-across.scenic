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
