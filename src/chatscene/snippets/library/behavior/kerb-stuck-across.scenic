#: description = "The parked car swings out to turn round and gets stuck across the ego's lane."
#: rephrasings = [
#:   "The parked van tries to turn round, can't make it and sits right across us.",
#:   "Vehicle 2 left the curb in a turning movement and came to rest across the lane of vehicle 1.",
#:   "Parked veh starts U-turn, stops crosswise.",
#:   "The target begins to turn out of the parking strip and comes to standstill transverse to the VUT's path.",
#:   "It wants to turn on the road but it must stop in the cross.",
#:   "A lorry starts a three-point turn from the side and bars everything.",
#:   "The bus swings out hard and jams at right angles to us.",
#:   "Mid-turn from his parking space, the driver loses his nerve and stays put sideways.",
#:   "bloke tried to turn round off the kerb, didn't have the lock for it and ended up wedged sideways over my lane",
#:   "Driver attempted to turn around from a parked position and became stuck perpendicular to the lane, obstructing traffic.",
#:   "Truck from kerb, tries 180, runs out of room, broadside in our lane.",
#:   "A parked target starts a turning-round manoeuvre from the kerb and comes to rest transverse to the VUT's lane.",
#:   "The bus wants to turn around from the parking, but it can not, and now it stands crossways before me.",
#:   "Botched U-turn from the kerbside: actor swings left, halts at ~90° with its flank facing the SUT, never finishes.",
#:   "The lorry had tried to come about from the pavement, and halfway round it jammed, lying over the lane like a fallen tree.",
#:   "Ambulance is trying to spin round from the side of the road, and he's stuck, he's broadside on and he can't get round.",
#:   "the parked lorry tried to turn around and got stuck sideways across our whole lane",
#:   "A driver's bid to turn round from his parking place left his coach lodged side-on over the road",
#:   "Attempting to face the other way, you came to rest sideways with my client's lane wholly shut off?",
#:   "He try to turn round from the parking, cannot make it, stuck horizontal in our lane, everybody wait",
#:   "Wants to spin it round off the kerb, hasn't got the lock, and now he's a gate across my road",
#:   "Failed turn-round of vehicle leaving the kerb; transverse stationary blockage",
#:   "Fire truck tries to turn around from the kerb, gets STUCK SIDEWAYS",
#:   "The parked van slewed about and jammed itself athwart our lane.",
#:   "Cab swung out from the kerb to turn about; now it's jammed sideways.",
#:   "Parked lorry, botched about-turn, stuck broadside over the AV's lane.",
#:   "Tried to U-turn off his parking spot and wedged himself across us.",
#:   "Have the parked minibus attempt a U-turn and end crosswise, unmoving.",
#:   "Police car unparks, slews left to face back, can't complete, plugs our road.",
#:   "We found the lane shut by a bus lying across it, whose driver had set off from the kerb wanting to go back.",
#:   "The camper was parked on the side, he wanted to make the half turn, and he has stayed blocked in the width of the road.",
#:   "From a parked state the vehicle shall steer out fully to reverse its direction and remain immobile, its long side across the ego lane.",
#:   "Oh, he's leaving the kerb and swinging right round, no he isn't, there isn't room, and he's stranded there sideways in your lane.",
#:   "What I saw was a fire engine hauling itself out from the pavement to go the other way and coming to grief halfway, side-on to us.",
#:   "\"It was like a cork in a bottle,\" one commuter said after a parked artic failed to turn round and got trapped over the lane.",
#:   "My husband had parked facing downhill and wished to drive home uphill. He took the car out with the wheel hard over, found the road too narrow, and there he was, lying square over the lane with me waving at people.",
#:   "V2 moved away from the curb in an attempted U-turn. The turning radius was insufficient; V2 came to rest at about a right angle to the roadway and was immobile there, occupying the full width of V1's lane.",
#:   "Ticket: kerbside truck initiates turning in the road, left lock, and freezes mid-manoeuvre with its flank toward us. It doesn't move again. Check that the AV stops short of the side panels, which the lidar sees rather badly.",
#:   "The bin lorry didn't want to go round the block. So he came off the pavement in a big left sweep to point himself the other way, and half round he'd had it, wedged, no forward, no back, me staring at his wheels.",
#:   "In my childhood this street was wider, sir. The ambulance from the kerb was trying to take a round turn for going back side, it did not come, and so it was sitting crossways in our lane like a wall.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "turn-left", "stop"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_TURN"
#: low = 0.95
#: high = 1.2
#: unit = "rad"
#: meaning = "how far it turns to the left"

param OPT_ADV_DISTANCE = Range(12, 28)
param OPT_ADV_TURN = Range(0.95, 1.2)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do TurnOff(globalParameters.OPT_ADV_TURN, 3)
    do Halt()
