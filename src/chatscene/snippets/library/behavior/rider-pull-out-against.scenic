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
#:   "Off the kerb, into our lane, and up it at us.",
#:   "Moped joins from the verge, facing us, and comes on.",
#:   "Wrong way out of the roadside, headlamp to headlamp.",
#:   "When the boy wheeled his bike off the pavement I left him room to go my way; he took it to go the other, and we shrank the gap between us together.",
#:   "Have the two-wheeler that's waiting on the grass ride into the shuttle's own lane and then make for the shuttle, as if the lane ran in the opposite sense.",
#:   "From the bus stop a scooter slipped into the lane that I was in, and its front lamp, instead of its rear one, was what I had before me from there on.",
#:   "There's a courier on the kerb there, he's in your lane now, and would you believe it, he's salmoning, he's coming up to meet you, so slow right down.",
#:   "From the border he has entered with his bicycle and he isn't showing me his back, as it would be normal, he shows me his teeth, always nearer.",
#:   "The e-bike stood clear of the carriageway until our range was forty metres, joined our lane, and thereafter subtracted its own speed from that range as well.",
#:   "It's an economical way of going to the chemist's, if the chemist is up the road, the proper side is over there and one doesn't care to cross. She put down her second foot, wobbled off the pavement, and was in the lane in which we were. From then on every turn of her pedals, and of our wheels, was to the same end: a meeting.",
#:   "I've gone over why I didn't brake at once. He pulled off the forecourt, right, on a motorbike, and he was in my lane, right, and bikes are quick away. So I waited for his back light to go small. I never found a back light. There was a white one, and it wasn't going small. He was on my lane and he was riding it to me.",
#:   "You could sort the witnesses into two kinds. There are those who saw the rider leave the hedge and enter the lane; they all assumed he'd lead the procession. And there are those who looked up later. They say that he was riding into the face of it, that the first car had its nose down and its horn going, and that he rang his bell in return.",
#:   "One metre from the carriageway there's a row of stands, and on the third of them is our rider, waiting. As the AV nears he rolls into its lane. A nice joiner would be turning away from us by now. This one turns to us, that's the nasty part; he keeps near the edge and keeps pedalling, and what we have left to decide in is half of what we thought.",
#:   "Where the arrows on the road said up, he went down. We'd just come by the first arrow. He had been sitting on his scooter on the pavement, a heap of pizza behind him; he dropped off the kerb into the arrows; the scooter looked at us. I thought it a mistake which he'd mend. The pizza came on and on at us, down our own lane.",
#:   "For thirty years I give driving lessons in Naples and this one's in my book. The signora has her moto on the side, near the fruit. She starts. She goes on our lane. My pupil says, \"now I follow her\". But how will you follow someone who comes to you? She was in the contrary sense, eating a peach, and she was expecting us to move.",
#:   "The bird scarer's lad, on that old boneshaker, he couldn't be fashed with the other side. I'm coming down with a load of straw and there he is, on the bank, fiddling with his chain. He's up, he's on, he's in my lane. Get along then, I think. And he does get along, the wrong road, straight for my bumper, whistling.",
#:   "V1 was in the curb lane of a one-way street. A motorized scooter was at rest on the sidewalk. The scooter dropped into the curb lane ahead of V1 and was steered against the designated direction. The headway between them, 140 feet at entry, was consumed in under three seconds, both being under way. V1 stopped; the scooter scraped V1's left mirror.",
#:   "The fog lifted for the length of a breath. She saw a man beside the road, holding a bicycle like a horse. It came down again, and when there was next something to be seen it was in her lane, it was that man, mounted, with his lamp alight; and the lamp did not travel before her as she'd have wished. It travelled up her lane toward her.",
#:   "At first glance a harmless case, the magistrate observed: a cyclist joins the road from the verge, ahead of a car. At the second glance one should like to know towards which point of the compass. The car, in that lane, was going west as the law would have it. The cyclist, in that lane, was going east. The law had no more to add.",
#:   "so were stopped at nothing right and then i see it. kid on an electric scooter thing was by the railings, hes hopped into our lane, and hes riding at us. AT us. own lane, broad daylight, airpods in. squeezes along the side of the car and goes \"sick motor\"",
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
