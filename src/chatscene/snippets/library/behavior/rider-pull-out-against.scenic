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
#:   "Bike leaves the pavement, enters our lane, heads straight toward us.",
#:   "Moped off the verge, into the ego's lane, riding at it contraflow.",
#:   "Kid rolls off the kerb and pedals up my lane into my face.",
#:   "From the roadside a motorbike joins our lane facing us and keeps coming.",
#:   "Have a cyclist start roadside, then ride against the AV in its lane.",
#:   "A courier who'd been standing by the shops bumped down into my lane and set a course for my radiator, the wrong way.",
#:   "The scooter is waiting on the border, then enters my lane, but in the contrary sense, so we are driving one to the other.",
#:   "After leaving its place beside the carriageway, the two-wheeler occupies the VUT's lane and approaches in it, opposed to the direction of traffic.",
#:   "He's coming off the grass there on his bike, and he's turned to face you, he's riding up your lane, cover that brake.",
#:   "Does nobody teach them, this student who hops off the kerb with her bicycle and meets us head-on in our own lane?",
#:   "Caller says a motorcycle came out from the side of the road and is now going up the lane the wrong way, at him.",
#:   "I'd barely noticed the old man with the bicycle beside the hedge. He swung a leg over, wobbled into my lane, and came up it toward me as though all the rest of us were driving on the wrong side.",
#:   "The moped had been stationary on the sidewalk. Its operator entered the lane in which V1 was traveling, turned to face V1, and traveled against the designated direction of that lane with the distance to V1 steadily diminishing.",
#:   "Salmon test. The e-bike idles next to the road; when we get near, it comes into our lane and travels down it in the wrong sense, keeping a little to one side, so that it and the shuttle close on each other.",
#:   "He couldn't be troubled to wheel the thing over to the proper side. So from the edge of the field he simply rode into our lane and up it, against us, one hand in his pocket, the front lamp nodding nearer.",
#:   "In my city it's normal but here I was surprised. A boy with food box was at the roadside with his scooter, he entered in my lane, and then he drove to my direction, so our two fronts were looking at each other.",
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
