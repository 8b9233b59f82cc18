#: description = "The rider pulls out from the roadside into the ego's lane and rides along it against the traffic, toward the ego."
#: rephrasings = [
#:   "A kid on a scooter comes out of the side and turns the wrong way, right at us.",
#:   "The bicyclist entered the roadway from the shoulder and traveled in the lane of Vehicle 1 against traffic.",
#:   "bike joins our lane wrong way, head-on",
#:   "The two-wheeler joins the VUT's lane in the opposing direction.",
#:   "The cyclist comes from the side and drives in false direction against us.",
#:   "A pizza rider saves a detour by heading up the street the wrong way.",
#:   "The moped sets off from the pavement into oncoming traffic, us.",
#:   "Out of nowhere a biker mounts the lane and meets us nose first.",
#:   "A moped came off the pavement into my lane and rode straight at me the wrong way.",
#:   "The cyclist left the curb, entered Unit 1's lane and rode against the flow of traffic toward it.",
#:   "Bike off kerb into ego lane, salmoning at ego.",
#:   "The cyclist target leaves the roadside, enters the VUT's lane and travels in it contrary to the traffic direction.",
#:   "The bicycle goes from the side in my lane and comes against me, wrong direction.",
#:   "Rider starts at the kerb, pulls into our lane, then goes contraflow head-on with us.",
#:   "He wheeled it off the verge, and instead of going with the stream he pedalled up it, straight toward her.",
#:   "Kid on a bike just set off from the kerb and he's coming up your lane the wrong way, right at you.",
#:   "some dude on a bike came off the curb n rode straight AT us in our lane",
#:   "A delivery rider left the roadside to travel up the lane into the teeth of the traffic.",
#:   "From the kerb you entered my client's lane, and you then rode toward her, contrary to every other vehicle?",
#:   "The delivery bike came out from the side and riding opposite direction in my lane, straight to my face.",
#:   "Hops off the verge into my lane and comes at me the wrong road, no lights, no shame.",
#:   "Contraflow riding in ego lane after roadside entry by two-wheeler.",
#:   "CYCLIST PULLS OUT AND RIDES HEAD ON INTO TRAFFIC",
#:   "The moped peeled off the kerb and breasted the traffic in our lane.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "wrong-way"]
#: place = "road"
#: maneuver = "straight"
#: side = "right"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.5
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 32.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.7
#: high = 1.5
#: unit = "m"
#: meaning = "how far from the ego's line it rides"

param OPT_ADV_SPEED = Range(2.5, 5.5)
param OPT_ADV_DISTANCE = Range(32, 52)
param OPT_ADV_REACH = Range(0.7, 1.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < 2.2
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_REACH if offsetFrom(egoRoute, self) < 0 else -globalParameters.OPT_ADV_REACH)
