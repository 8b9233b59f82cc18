#: description = "The car ahead slams on the brakes, comes to a dead stop and stays there."
#: rephrasings = [
#:   "The guy in front of us slams the anchors on and just sits there.",
#:   "Vehicle 2 decelerated rapidly, came to rest in the travel lane and remained stationary.",
#:   "Lead veh emergency stop, then stationary in lane.",
#:   "The target performs full braking down to standstill in front of the VUT and holds its position.",
#:   "The lorry before us makes sudden full stop and does not move any more.",
#:   "An ambulance we follow brakes to zero in an instant and plugs the lane.",
#:   "The bus ahead of the ego screeches to a halt and refuses to budge.",
#:   "Whoever leads us stands on the pedal until nothing moves, leaving an obstacle in our lane.",
#:   "The car in front slammed everything on, stopped dead and wouldn't budge.",
#:   "The lead vehicle made a panic stop and remained stationary in the travel lane.",
#:   "Lead: emergency brake to 0, stays put, lane blocked.",
#:   "The lead target brakes with maximum deceleration to standstill and remains stationary.",
#:   "The car in front makes full brake, stands and does not go more.",
#:   "CCRb variant: lead does a full-force stop and holds zero for the rest of the run.",
#:   "His tail lights blazed, the nose dipped, and there he stood in front of her and did not move again.",
#:   "Emergency stop from the lorry ahead, he's dead in the road and he's not going anywhere!",
#:   "car in front just STOPPED. like full stop. didnt move again",
#:   "The van ahead pulled up with a screech and did not stir from the spot.",
#:   "He brought his vehicle to an immediate standstill ahead of her and there it remained, blocking the lane?",
#:   "The front taxi jam brake until full stop, and then never move already.",
#:   "Bang, he's stopped, full stop, and there he sits like a garden gnome.",
#:   "Maximum-effort stop of lead vehicle with persisting lane blockage.",
#:   "CAR IN FRONT PANIC STOPS AND NEVER MOVES AGAIN",
#:   "The car ahead nailed itself to the spot.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "Euro NCAP CCRb, UN R152; own code"
#: [slots]
#: actions = ["brake", "stop", "block"]
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
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(5, 30)
param OPT_BRAKE = Range(0.7, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
