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
#:   "Fire engine ahead brakes to nothing in an instant and stays parked there.",
#:   "Full anchors from the hatchback leading us, then permanent roadblock.",
#:   "Motorbike in front of AV: sudden zero, no restart.",
#:   "Let the leading coach stop violently and remain where it is.",
#:   "Skid, silence, and the lorry ahead stood there for good.",
#:   "The driver of the car I was behind must have jumped on the brake with both feet, for it went from fifty to nothing and then stood there.",
#:   "At t0 the preceding target is brought to rest with 8 m/s² and shall not be released until the end of the measurement.",
#:   "Generate a minibus travelling ahead of the ego that makes a crash stop and from that moment on is a stationary obstacle in the lane.",
#:   "Our insured collided with the rear of a Skoda, which, having until then led him at normal speed, stopped with locked wheels and did not resume its journey.",
#:   "vor mir the truck makes a Vollbremsung, he comes to standing and there he rests, the street is closed with him",
#:   "Two seconds, I said, and now you see what for: the taxi ahead has gone down on its nose, it's stopped, and it's staying stopped.",
#:   "We were trundling along behind a patrol car, everything calm. Its tail went up in the air, the tyres howled and it was standing still before I had lifted my foot. We waited for it to go on again but it just stayed in the lane.",
#:   "Unit 2 was the lead vehicle. For reasons not determined, its operator braked to the limit of adhesion, leaving sixty feet of skid marks that end under the tires of Unit 2 where it remained at rest, occupying the lane, until police arrived.",
#:   "You're behind a big artic, all you can see is its doors. The doors come at you, fast, and there's smoke off the wheels, and by the time you've understood it's standing across the end of your bonnet with no intention of ever leaving.",
#:   "I was on the pushbike behind a motorcycle when its rider hauled on everything he'd got. He was stopped in less than a length. He put his feet down and there he remained, in the middle of our lane, helmet turning left and right.",
#:   "For the regression suite: lead actor drives ahead at the ego's speed, then full emergency deceleration to rest. No timeout after that, the actor simply keeps blocking the lane, since we want to see whether the AV goes into a safe hold.",
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
