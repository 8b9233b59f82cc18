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
#:   "From the kerb into our lane, then up it at us.",
#:   "Moped leaves pavement, takes our lane backwards, nose to nose with traffic.",
#:   "He set off from the verge and came salmoning up our side.",
#:   "The postie wheeled her bike off the pavement into my lane and rode up it in the direction from which everybody else was coming.",
#:   "Can you have a motorbike start at the roadside, enter the ego's lane and travel along it the wrong way, so that it closes on the ego?",
#:   "He waits by the trees with his bicycle, then he enters on my lane and he's mounting it in the contrary sense, toward me.",
#:   "Our lane had one-way arrows, all pointing away from us, when a scooter came down off the kerb, ignored the lot and bore down on our bumper.",
#:   "What's he thinking, that old boy who mounts up beside the road, pops out into your lane and pedals it the wrong way, at you?",
#:   "Two-wheeler, initially stationary off the carriageway, joined the lane of Vehicle 1 and continued therein counter to the flow, approaching Vehicle 1 head-on.",
#:   "To save going round by the roundabout, that's what she told the constable. Her moped had been on its stand by the launderette. She bumped it into the road, into the bit of the road that I was on, and made for the chemist, which was behind me; so the first I knew of it was her headlight getting larger.",
#:   "There was this blind spot behind the hoarding. Out of it came a fat tyre, then handlebars, then a lad in a hood on one of those electric bikes, and he was in our lane. Okay, I thought, he'll go along with us. Not a bit of it. He'd his face to me and stayed that way, and he was pedalling.",
#:   "The camera first sees her standing with one foot on the kerb. She's in our lane by frame 90, and what disturbs the tracker is that from there on her distance shrinks by both speeds added together, ours and hers. She's going up the lane that we're going down. She hugs one edge of it but not by much.",
#:   "You've dealt with wrong-way drivers in theory, so here's a practical. Man on motorbike, waiting at the edge by the chip van. He's pulled out, no harm in that. But look at his front light, it's facing us. He's riding up our lane against everybody, and at us first. Down to ten and keep well over, please.",
#:   "Statement by the driver of the coach: bicyclist was at rest at right-hand roadside near the stables. He went into my lane when I was some sixty metres off, which I'd have coped with. However, he didn't go my way. He rode toward me in the lane that I was in, whistling I may add, until I'd stopped.",
#:   "Brave or stupid, I leave it to the lawyers. My client had the lane, and the lane ran north. The defendant pushed off from the grass verge on his motorcycle, gained that lane, and went south. They were thus approaching each other between the same two white lines, and it was for my client to run out of road.",
#:   "It's normal at harvest, the neighbours say, the pickers do it daily. I am new here, I nearly died. From the ditch side a girl with her scooter rolled in my lane, looked at me very friendly, and came driving toward me, contrary to the whole row of cars, with a crate of grapes between her knees.",
#:   "Nothing had moved on the towpath road but flies. The cyclist by the lock-gate got up, brushed off his trousers, and steered out into the lane of the only car that had come all afternoon. He did not go the way the car was going. They closed on each other, he and it, slowly, like the last two men in a duel.",
#:   "From my cab I thought he was having me on. Paper lad, stood with his bike by the gateposts. Wobbles off into the road, my lane, and instead of getting going the way I'm going he comes up at my grille, big as life, riding into the flow. I've twelve ton of spuds. He's got the Evening Star.",
#:   "Variant \"contraflow joiner\". Start: two-wheeler parked outside the lane, 1 m off the edge. Then: it enters the ego's lane. And then, unlike the joiner in variant A, it heads for the ego; the two speed vectors are opposed. Please keep it off-centre in the lane so there's a narrow way past if we find it.",
#:   "yesterday in the robotaxi: dude on a vespa by the pavement, he pulls into our lane, and i go nice, hes gonna lead us. NOPE he turns up the lane at us, wrong direction, coming straight for the windscreen. car stopped, he squeezed by my window and grinned at me",
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
