#: description = "The truck ahead breaks down, limps toward the edge of the road and stands half in the lane."
#: rephrasings = [
#:   "The lorry in front of us packs up, limps over to the side and still sticks out into our lane.",
#:   "Vehicle 2 suffered a defect, moved to the edge and came to rest partly within the travel lane.",
#:   "Lead disabled: drifts right, stops, partially obstructing.",
#:   "The target reduces speed, shifts laterally toward the road edge and stands overlapping the path of the VUT.",
#:   "The truck has a panne, goes to the right side but not enough space, it stays half on our lane.",
#:   "The coach ahead dies and only just reaches the verge with its tail still in the road.",
#:   "A car before us pulls over with the hazards on, not quite clear of the lane.",
#:   "The van we follow gives out and wallows to the margin, leaving us half a lane.",
#:   "the lorry in front packed up, hobbled towards the verge and was left with its backside sticking out into my lane",
#:   "The truck preceding V1 became disabled, moved toward the shoulder and came to rest partially in the travel lane.",
#:   "Bus ahead: mech. failure, limps R, stops half on rd.",
#:   "The lead vehicle loses speed, steers toward the carriageway edge and stands with partial overlap of the VUT's lane.",
#:   "The car in front is broken, he goes slowly to the side and stays, but half is still in my lane.",
#:   "Lead has a simulated failure: decel, drift to roadside, v=0 at ~50 % lane overlap.",
#:   "The ambulance before them faltered, dragged itself to the roadside like a wounded beast, and stopped there, half on the road.",
#:   "He's got a breakdown, he's nursing it to the side, hasn't got it all the way off; you'll have half a lane to play with.",
#:   "truck in front died and sort of dragged itself to the side but its butt is still in our lane",
#:   "A stricken bus hobbled to the roadside yet left half its bulk in the carriageway",
#:   "Your vehicle having failed, you steered it for the edge but it did not clear the lane, did it?",
#:   "Lorry in front spoil already, slowly go to side but half body still blocking",
#:   "His engine's gone, he's nursing it to the gutter, and there he's stuck with his backside out in my road",
#:   "Disabled lead vehicle partly clear of the lane; residual lane obstruction at the road edge",
#:   "Van in front BREAKS DOWN, only makes it halfway off the road",
#:   "The ambulance ahead faltered, hobbled kerbward and stranded itself half in.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "swerve", "stop"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.17
#: high = 0.24
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.1
#: high = 1.8
#: unit = "m"
#: meaning = "how far to the right of its line it comes to stand"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_BRAKE = Range(0.17, 0.24)
param OPT_SWERVE = Range(1.1, 1.8)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE, -globalParameters.OPT_SWERVE)
