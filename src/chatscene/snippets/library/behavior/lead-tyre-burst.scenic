#: description = "The car ahead bursts a tyre, swerves and brakes to a stop across its lane."
#: rephrasings = [
#:   "A tyre blows on the car in front of us, it yaws about and skids to a stop.",
#:   "Vehicle 2 experienced a tyre failure, veered laterally, braked and came to rest in the lane.",
#:   "Lead: blowout, sudden lateral kick, hard brake, stationary.",
#:   "The target makes an abrupt lateral excursion and brakes to standstill in the path of the VUT.",
#:   "The wheel of the van ahead explodes, it goes to the left and the driver stops with force.",
#:   "The lorry before us has a flat all at once, lurches sideways and grinds to a halt.",
#:   "Bang goes the bus's front tyre; it jinks and pulls up right there.",
#:   "Our leader loses grip, jumps off its line and stamps on the brake till it stands.",
#:   "The van in front had a blowout, lurched sideways and ended up stopped slewed across the lane.",
#:   "The lead vehicle sustained a tire failure, lost directional control and came to rest at an angle across its lane.",
#:   "Lead: tyre bang, veers, brakes, stops athwart lane.",
#:   "The lead target simulates sudden tyre deflation with lateral deviation, and brakes to standstill oblique to its lane.",
#:   "The truck before me, his wheel explodes, he goes to side and stops cross in the lane.",
#:   "Blowout model on lead: yaw kick, then brake to zero, ends up diagonal and blocking.",
#:   "There was a bang, a rag of rubber flew up, and he fought it this way and that until it stood crosswise before her.",
#:   "He's blown a tyre, look, it's dragging him sideways, he's stopping skew across the road!",
#:   "the truck's tire literally exploded and it went sideways n stopped across the lane",
#:   "A coach shed a tyre with a loud report, slewed round and came to rest broadside.",
#:   "A tyre on the leading vehicle gave way, it yawed, and it finished crosswise in the lane, is that right?",
#:   "Front lorry tyre got puncture with big sound, it went side and stopped cross on the lane.",
#:   "Pop goes his tyre, round he slides, and there he is sideways on in front of me.",
#:   "Tyre failure of lead vehicle with yaw deviation and transverse lane obstruction.",
#:   "TIRE EXPLODES RIGHT IN FRONT OF ME",
#:   "The van ahead blew a wheel, skewed and jammed the lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "brake", "stop"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -10.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.6
#: high = 2.6
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-10, 20)
param OPT_SWERVE = Range(1.6, 2.6)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, 6, globalParameters.OPT_SWERVE) for 0.8 seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE, 0.5 * globalParameters.OPT_SWERVE)
