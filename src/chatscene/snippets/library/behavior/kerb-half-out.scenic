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
