#: description = "The cyclist crosses and brakes suddenly in the middle of the intersection, obstructing the ego."
#: rephrasings = [
#:   "A rider comes out, pulls the brakes hard, and stays in the ego's path.",
#:   "The cyclist stops abruptly halfway over and gets off the bike.",
#:   "The motorcyclist cuts across and slams to a halt in the lane.",
#:   "A bike shoots into the junction and brakes to a standstill in its centre.",
#:   "The rider skids to a stop right before the ego and blocks the way.",
#:   "He rides out and then yanks both brakes right in the middle.",
#:   "The bicyclist braked abruptly while crossing and came to rest in the intersection.",
#:   "bike crossing, hard brake, stuck mid-way",
#:   "A cyclist was going over the crossroads and slammed his brakes on halfway, plonked right in my path.",
#:   "The bicyclist was crossing the intersection when he braked abruptly mid-way and blocked Unit 1.",
#:   "Bike X-ing jct, hard brake in centre, stands in ego path.",
#:   "The bicycle target crosses the junction and decelerates abruptly to rest at its centre, in the VUT's path.",
#:   "The bicycle drives over the crossing, in the middle he brakes suddenly and stands in my way.",
#:   "Two-wheeler stops dead mid-junction during its crossing; ego path blocked, doesn't clear.",
#:   "He pedalled out boldly, then clutched at both levers and stuck there in the very middle before her.",
#:   "That moped's halfway over the junction and he's grabbed his brakes, he's stopped slap in your way.",
#:   "kid on a bike stopped dead halfway over the intersection right in our way",
#:   "A cyclist braked to a standstill at the heart of the crossroads, blocking a car.",
#:   "Halfway over the junction he applied his brakes with force and stood in my client's road?",
#:   "The cycle uncle was crossing the junction, then middle there suddenly brake and stop.",
#:   "Pedals out, gets to the middle, pulls both levers and there he is, bang in front of me.",
#:   "Sudden mid-intersection stop of crossing two-wheeler in ego path.",
#:   "BIKE SLAMS BRAKES IN MIDDLE OF INTERSECTION",
#:   "The crossing moped rider seized up in mid-junction.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: actions = ["cross", "brake", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(3, 6)
param OPT_ADV_DISTANCE = Range(4, 24)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED + 2 * globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
