#: description = "The pedestrian suddenly sprints out onto the road in front of the ego and stops."
#: rephrasings = [
#:   "Somebody dashes into the lane and freezes directly in the path of the ego.",
#:   "The pedestrian bolts into the roadway, then stands still before the ego.",
#:   "A child runs out in front of the vehicle and halts there.",
#:   "The person rushes onto the street at full speed and comes to a dead stop.",
#:   "The runner darts out abruptly and blocks the lane by standing in it.",
#:   "A lad comes haring out and then stands stock-still in front of us.",
#:   "The pedestrian ran into the roadway and stopped in the path of Vehicle 1.",
#:   "ped runs out, freezes in lane",
#:   "Some kid legged it out in front of me and then froze like a deer in the headlights.",
#:   "The juvenile ran into the roadway ahead of Unit 1 and came to a sudden standstill.",
#:   "Ped bolts out, freezes in front of ego.",
#:   "The pedestrian target accelerates to running speed into the VUT's path and comes to rest there.",
#:   "A child runs suddenly on the street before me and stays standing.",
#:   "Dart-out then freeze: ped reaches our path running, halts in it, doesn't finish crossing.",
#:   "He burst out at a run, saw her coming, and stood rooted to the spot.",
#:   "Kid's run out, and he's stopped right there staring at you, brake!",
#:   "this girl sprinted out in front of us and then just FROZE",
#:   "A youth tore into the road and pulled up short before a car, as though turned to stone.",
#:   "He ran into the carriageway, and directly before the vehicle he ceased to move?",
#:   "Small boy suddenly ran in front of my car and then stood there like statue.",
#:   "Shoots out in front of me, sees the grille, and that's him stuck, won't go on, won't go back.",
#:   "Sudden running entry of pedestrian with standstill in ego path.",
#:   "GIRL SPRINTS OUT THEN FREEZES IN FRONT OF CAR",
#:   "A boy streaked out and petrified before us.",
#:   "Runner in the road, now stock-still, right before your bonnet!",
#:   "Jogger flings himself out ahead of us and turns into a lamp post.",
#:   "I need a person who rushes into our lane and stays rooted there.",
#:   "Le petit, he runs out very fast and pouf, he is like frozen.",
#:   "Ped at full tilt off pavement; halts dead in VUT lane; remains.",
#:   "She was standing like a bollard in the middle of my lane, the girl who one second earlier had come galloping off the pavement.",
#:   "It's the ones who run out and then lose their nerve you have to fear: this chap's belted into your lane and now he can't move a muscle.",
#:   "A pedestrian hurtled unexpectedly from the pavement into the path of the robotaxi and, rather than go on, remained motionless in front of it with arms outstretched.",
#:   "Upon trigger the adult dummy is accelerated to 3.5 m/s, driven into the VUT's lane and stopped abruptly at the lane centre, where it stays.",
#:   "What made you run into the street with such suddenness, and what, having got before the car, made you stand there and go no further?",
#:   "My little brother bombed out onto the road to get to Grandma, and when he saw the van he just went all stiff in front of it.",
#:   "From the saddle I saw it all. A man with a rucksack took off from the bus stop like a sprinter and was in the lane in two bounds. He'd have made it to the other side, but he caught sight of the car, and there he stuck, right in its way, knees bent, mouth open.",
#:   "I had hardly passed the school when a tall boy burst from the gate at full speed into the road. I braked, of course. He didn't run on and he didn't run back; he pulled himself up in the very middle of my half and stood gazing at me while I came to rest.",
#:   "The pedestrian was observed beside a mailbox. As Vehicle 1 came near she set off at a run, without warning, and reached its lane within about a second. There her run ended. She stood facing the grille and was still standing on the same spot when the driver got out.",
#:   "In this scenario the AV has to cope with a dash that isn't completed. Someone tears out from the edge, reaches the strip of road we're about to use, and there they plant both feet and won't budge. A planner that counts on them carrying on to the other side will hit them.",
#:   "Eighteen years on the buses and you still get a shock. Some lass came charging out after her boyfriend, handbag flying, straight into where I was going. And then what does she do? Sees the front of a double-decker and locks up solid. I had to stand there hooting till her fella fetched her.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to run"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(4, 7)
param OPT_ADV_DISTANCE = Range(6, 18)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
