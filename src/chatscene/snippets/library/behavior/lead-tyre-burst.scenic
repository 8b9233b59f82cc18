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
#:   "Blow-out on the coach in front; it skews, brakes, stands crossways.",
#:   "Leader's rear tyre goes, it's flung sideways, brakes hold it athwart us.",
#:   "Lead motorcycle: deflation, veer, heavy brake, rests across own lane.",
#:   "Simulate a burst tyre ahead: sideways lunge, brakes, oblique standstill.",
#:   "Reifen kaputt before me, car goes slanting, he brakes until standing.",
#:   "The ambulance we were behind lost a tyre with a crack, slid off its line, and its driver brought it to rest at a slant across the lane.",
#:   "When the nearside front let go, the artic ahead of my van pulled hard to one side and was braked to a halt lying over the lane.",
#:   "With a bang like a gunshot the SUV before us lost its rear wheel's air, went askew and stood on its nose until it blocked our way.",
#:   "Your lead vehicle suffers a sudden loss of tyre pressure, departs from its line and, under braking, ends stationary and angled across the traffic lane.",
#:   "I heard the pop from inside my cab; then the saloon ahead was going crabwise, its brake lights full on, and it finished sideways in the lane.",
#:   "Rubber everywhere, said the officer. The pickup in front had kicked out to one side when the tyre went and been stopped by its brakes, broadside on.",
#:   "We were strung out behind a minibus, all at the same pace, when its tyre gave up. You saw it sag on one corner and dart to that side; the driver got hard on the brakes, and when it was still it was lying over the lane like a closed gate.",
#:   "V1 was following V2. A tire of V2 ruptured, which caused V2 to yaw and depart laterally from its path of travel. The driver of V2 applied full braking, and V2 came to final rest at an angle, obstructing the lane in which both vehicles had been traveling.",
#:   "My dad was driving and the lorry in front of us went BOOM and black bits flew off. It went all wonky to the side, then all its red lights came on, and then it was stood in the road the wrong way, and we couldn't get past.",
#:   "Control, I'm behind a fire appliance with a problem. He's just had a tyre let go, he was thrown over to one side, he's braked it down and he's now standing diagonally over the lane. Nobody's going by until that's been shifted, over.",
#:   "I've ridden forty years and I've never seen a mate saved by so little. Riding ahead of the car, his rear tyre burst, the bike snaked off at an angle, and he braked it down to a stop lying slantwise over the lane, still upright, God knows how.",
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
