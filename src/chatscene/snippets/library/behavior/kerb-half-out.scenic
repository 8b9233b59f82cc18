#: description = "The parked car noses halfway out of its space and stops with its front in the ego's lane."
#: rephrasings = [
#:   "The parked car sticks its snout out and stops, half in our lane.",
#:   "Vehicle 2 protruded partially into the travel lane from a parking space and stopped.",
#:   "Parked veh half out, stationary.",
#:   "The target leaves the parking strip partially and comes to standstill overlapping the VUT's lane.",
#:   "It comes out only the half and stands, we have not enough place.",
#:   "A van pokes out to see past the others and stays there.",
#:   "The bus swings its front out, gets no gap and waits jutting into the road.",
#:   "A lorry angles off the roadside, thinks better of it and leaves its corner out.",
#:   "This parked van stuck its nose out into my lane and just sat there, half in and half out.",
#:   "The legally parked vehicle advanced partially from its space and came to rest with its front end obstructing the travel lane.",
#:   "Parked car noses out ~half, stops; front in ego lane, tail still in bay.",
#:   "The parked target moves partly out of its bay and halts, its front section protruding into the VUT's lane.",
#:   "A parked car comes out only with the front and stays so, half in my lane.",
#:   "Parked actor pokes out to ~50% and freezes; partial-width obstacle that never completes the pull-out.",
#:   "He edged its snout out from the row and then, having spoiled half her lane, he stayed put.",
#:   "He's stuck his bonnet out of that space and stopped, so you'll have to get round his front end.",
#:   "parked car poked its face out into my lane and then just.. stayed like that",
#:   "A delivery lorry stood with its bonnet jutting into traffic after leaving its bay only in part.",
#:   "Your vehicle was neither parked nor driving; its forward half stood in my client's lane, motionless?",
#:   "Parked van came out half only, half body inside, half body on the road, and stopped there.",
#:   "He pokes his snout out of the parking spot and leaves it hanging in my lane, neither use nor ornament.",
#:   "Partial protrusion of formerly parked vehicle into ego lane, stationary.",
#:   "PARKED CAR STICKS NOSE OUT AND JUST STOPS THERE",
#:   "A parked bus jutted its snout into our lane and froze.",
#:   "Ambulance at the kerb comes out to its front doors and stays there.",
#:   "Bonnet in our lane, boot in the bay, and not moving.",
#:   "The parked cab edges halfway into the road and halts.",
#:   "Make the parked lorry emerge by half its width, then freeze.",
#:   "Just the front end leaves the bay, and there it rests, obstructing us.",
#:   "From the row of parked vehicles a removal van angles out until its cab is in front of us, and it goes no farther than that.",
#:   "The obstacle is created by a parked car which steers partly out of its space and remains stationary with its front overhanging the lane of the VUT.",
#:   "I couldn't get by because a minibus that had been parked on the left had stuck its front wheels out in my lane and was now just standing.",
#:   "Stop, stop: the blue one by the kerb wants out, he's come half the way, and now he's planted there with his wing across your lane.",
#:   "Please set up a parked police car that drives out of its space at an angle and brakes to rest while its rear is still at the kerb.",
#:   "El coche was parked, he goes out the half of him, the nose is in my lane and the tail not, and there he remains quiet.",
#:   "When I first saw the Transit it was parked tight to the kerb like all the others. Then its wheels turned and it slid out maybe a metre and a half, and that was that. It neither finished coming out nor went back, so its nose was sitting in my lane.",
#:   "The bus was standing in the lay-by. Its operator pulled the front axle over the edge line and came to a stop, leaving the rear section in the lay-by and the front left corner about four feet inside the travel lane of Vehicle 1.",
#:   "At forty-four tonnes you don't thread needles. This parked hatchback came creeping out with its front half, blocked the best part of my lane and then sat tight, the driver looking the other way over her shoulder, and her rear wheels never left the space.",
#:   "It was as if the old saloon had wanted to sniff the street. It put out its head from between two neighbours, as far as the windscreen, and with that in the way of everyone who came along the lane, it stopped and came out no more.",
#:   "How does the AV handle a car that's only part-way out? That's the question here: the actor begins parked, pokes into our lane with about half its body, brakes to zero at that angle and does not complete the departure.",
#:   "Kerbside van shows its face in our lane and stays put.",
#:   "Make a parked ambulance angle out halfway and then just stand.",
#:   "Half a bus in the bay, half in my way, wheels still.",
#:   "A Transit that'd been in a parking bay shoved its front end out in front of us and then sat with the handbrake on, neither in nor out.",
#:   "The parked target is moved obliquely until approximately one half of its width overlaps the VUT's lane, where it is braked and remains.",
#:   "He wants to see round the skip, so out comes the bonnet from the row, and now he has stopped with it in our road.",
#:   "V2 left its parallel space only in part, came to rest at an angle, and presented its left front corner to traffic in V1's lane.",
#:   "The car was parking at the side, then it comes out until the front door is in my lane, and there it has frozen, I cannot pass.",
#:   "LADY LEAVES CAR PARKED HALF IN HALF OUT after poking its nose into the lane, then does her lipstick",
#:   "I shall not forget that radiator grille. It had been one among a dozen in the row by the kerb, and then it was not in the row any more but jutting over a third of my lane. Its owner didn't come any further out, and he did not draw back; he was simply content to stand there.",
#:   "Bus 212 reporting a delay of four minutes. A removal lorry was in the loading bay with its engine on. As I drew near he swung his cab out into my lane, then stopped for oncoming traffic I suppose, his trailer end still at the kerb, and I couldn't squeeze by with the width I've got.",
#:   "When you go by a line of parked cars, what do you look for? Front wheels. These ones have turned, and out she pokes, a yard, a yard and a half, and that's it, she's stopped and she's waiting with her wing in our lane. Her back end hasn't shifted at all.",
#:   "Not a scratch on the rear half of the vehicle, and a good reason for it: that half was still inside the painted bay. The front half, which the tram had to be backed away from, had emerged a moment earlier and was at rest in the travel lane when the claimant's car came upon it.",
#:   "We were singing, my sister and I, and Mummy stopped so we stopped. A police car had been asleep at the side of the road. It had put its nose out, just its nose, and then it had gone to sleep again like that, so there wasn't enough road left for us to drive on.",
#:   "It's the not finishing that gets me. I have nothing against a fellow pulling out, I'd have let him. But he gets his headlamps as far as the middle of my lane and there he plants himself, with his boot still snug between two parked cars, and looks at me through the side window as if it were my move.",
#:   "AV field report. Object was classed as parked, correct. It started to leave at 18 m, yaw rate positive, and our planner assumed the usual full pull-out with subsequent acceleration. Instead velocity returned to zero with the rear axle in the bay and the front overhang 1.2 m inside our lane. Hard stop, no contact.",
#:   "From my balcony I had the bird's eye view. A row of roofs, all straight along the pavement, and one of them crooked, sticking out with its windscreen into the carriageway. It had been straight as well a few seconds before. It didn't move again until the horns had been going for some minutes.",
#:   "Could the parked coach give us a partial obstruction? I imagine it leaving the kerb at a slant when the ego is near, and being brought to a halt as soon as its nose has taken about half of our lane. From there it mustn't come out fully, nor drive on, nor go back.",
#:   "The street was narrow and the morning fine, and from the shade of the plane trees the doctor's old Citroën thrust out its snout like a tortoise. Tortoise-like it considered the sunlight. It came no further, and our wagon, with eight hundred litres of wine, had to stop before that snout and wait.",
#:   "Vehicle was standing at border of street. He has taken the steering full to left side, came out with front portion, then pressed brake, and remained in that slanting condition, front portion in my lane and back portion at border. For two-wheelers there was place, for my bus no place at all.",
#:   "Bonnet over our lane, boot at the kerb, engine idling, nobody moving.",
#:   "From the parked row one nose came out and stayed out.",
#:   "Bring the parked van out by half, then nail it there.",
#:   "There's just enough of that bus in the bay to call it parked and just enough in my lane to stop me, and that's where it's remained since it poked out.",
#:   "The ambulance which had been standing by the pavement put its cab in our way and, with its rear still in the slot, moved no more.",
#:   "To get by we would have needed the metre and a half which the front wing of the formerly parked pickup was now, quite motionless, occupying.",
#:   "The target, parked alongside, is steered out until half its width lies in the VUT's lane; it's then braked, and neither completes nor reverses the departure.",
#:   "He has turned the wheels, he's shown us his headlamps, and now nothing: he's sitting there slantwise, his front in our road and his tail in the gap.",
#:   "Came out as far as her own wing mirrors and froze, that lady in the Clio, so the whole number 5 bus had to wait for her.",
#:   "A shopping bag stood where its front wheel had been, so I know precisely how it was parked. By the time I reached it the wheel was well over the gutter and beyond my edge of the lane, turned hard out. The back wheel hadn't left its leaf pile. And the driver was looking for something on the floor, going nowhere.",
#:   "Length of vehicle inside the bay, 2.3 metres; length outside, 2.1. That is how we found it, and the engine was running. The delivery driver told us he'd \"wanted to have a look,\" and having wanted it and put his bonnet into the claimant's lane he had stood looking, until the claimant, arriving, left her paint on it.",
#:   "The cat jumped off the bonnet, and I always think that is the sign. The old Volvo had been asleep by the kerb for a week. It stirred; it put its chin out over our lane; it put out its front door as well. I waited for the rest, with my basket swinging on the handlebars, and the rest stayed at home.",
#:   "For once it was I who was the obstacle. I'd the fire engine on the apron at the kerb, a hose still to be rolled in. I thought I could swing her front out and be ready. Then somebody shouted, so I stopped with the cab over the lane and the tail in, and this self-driving car looked at me and I at it.",
#:   "The prediction for parked vehicles knows \"stays\" and \"leaves.\" This lorry did a third thing. Its nose swept out at an angle, as with \"leaves,\" up to an overlap of 0.9 m with our lane. It went to zero there. Fifty seconds later, when we asked the remote operator, the overlap was 0.9 m, and the rear axle still in the parking strip.",
#:   "Don't you love it when they do half a job? My bike and I had a clean run past the parked ones. And then one of them grew a snout. It grew until I could have ridden into the windscreen. It didn't draw the rest of itself after it, nor go back in, it just barred my lane like a drunk's leg.",
#:   "On the picture from the bus's front camera you can lay a ruler along the kerb. Seven roofs touch the ruler. The eighth is the taxi; its back corner touches as well, but the roof runs off into the lane at thirty degrees and the bonnet's under our windscreen. It is sharp in all forty pictures, so it wasn't moving.",
#:   "My mirror missed her bumper by the thickness of a stamp. All the others in the row had their wheels straight. Hers had been pointing out, so I was warned, and out she nosed, but only as a child goes into cold water, to the waist. That was all the further she went. I had to breathe in and go round.",
#:   "On the left side were many cars sleeping. One, a police car, has waked up. He came with the face on the street, in a diagonal, and I braked, please, come out. He came not out. He stayed with the face in my lane and the behind between the others, two, three minutes, I don't know what he was thinking.",
#:   "The doctor could not get to the birth, and the village still talks of why. The baker's van had been drawn up at the side, as always. Its owner meant to leave, changed his mind about his hat, and abandoned the manoeuvre, if not the vehicle, midway; and so its front half lay over the only lane, immovable, its hinder half at his door.",
#:   "What I need isn't a pull-out, it's a pull-half-out. Our car approaches a parked coach. Its front corner swings into our lane, enough that we don't fit by. Hold it there, brakes on, back end against the pavement, until the end of the run, so that the AV has to stop or find a way about the front of it.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["stop"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 16.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 0.8
#: high = 1.35
#: unit = "m"
#: meaning = "how far it noses out"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.3
#: high = 0.8
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(16, 34)
param OPT_SWERVE = Range(0.8, 1.35)
param OPT_BRAKE = Range(0.3, 0.8)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3, (-globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE)) until abs(offsetFrom(advKerb, self)) > 0.7 * globalParameters.OPT_SWERVE
    do BrakeOnPath(advKerb, globalParameters.OPT_BRAKE, (-globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE))
