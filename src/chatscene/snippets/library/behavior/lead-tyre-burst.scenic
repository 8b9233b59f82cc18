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
#:   "Pop, sideways, brakes, and the taxi ahead lies across the lane.",
#:   "Lead bus blows a tyre, veers, is braked to rest athwart.",
#:   "Tyre gone, car ahead slews, stops slantwise in front of us.",
#:   "the camper in front of us had its back tyre explode, skated out to one side with the brakes smoking and parked itself diagonally over the lane",
#:   "Following a simulated pneumatic failure the lead vehicle yaws out of line, decelerates strongly and obstructs its lane at an oblique angle, at rest.",
#:   "We were behind the ambulance when one wheel went flat with a crack; it ran crooked, stood on its brakes and ended up blocking the lane crosswise.",
#:   "Front tyre of that tempo ahead has burst like Diwali cracker, he went slanting, put full brake and stood in the lane like a gate.",
#:   "Make the motorcycle we're following lose its rear tyre: a sudden kick off line, hard on the brakes, and a final position lengthways over the lane.",
#:   "Hear that bang? It's the van you're following, his tyre, see him dart off line, brakes on, brakes on, and he's finished up skew-whiff over our lane.",
#:   "What hit my windscreen was a strip of tread a yard long. It came from the horsebox in front, which had lurched out of its line at the same time as I heard the report. Its driver got it slowed and slowed and then still, but by then it was stood at forty-five degrees and nothing could have got past it.",
#:   "The recovery man found the rim cut through to the metal on the nearside. That is consistent with what my client, driving behind, describes: a thud, a swing of the lorry to the nearside, brake lamps, and then the lorry motionless and askew, so that its tail closed the lane to her.",
#:   "There was nothing on the road, we looked afterwards. The police car in front of us was running along quite straight, and then one corner of it dropped and it was snatched sideways, with a flapping noise. The officer brought it to a halt under braking; it sat there across our lane, smelling of hot rubber.",
#:   "We were the second vehicle of three. The lead saloon suffered a loss of pressure in a front tyre, was displaced laterally by about a metre and came under heavy braking from its driver. In its rest position it presented its left flank to us, and the lane wasn't passable.",
#:   "I've got it on my phone, as I was filming our road trip. You see the SUV we're following and, pffff, bits of black flying out of the wheel arch. The picture goes all shaky, that's me screaming, and when it's steady again you see both of its right-hand doors, since it had skidded off its line and been pulled up crossways.",
#:   "Control, stop sending traffic down the slip. School bus, lead vehicle in my lane, it's had a blow-out, gone off to one side and been braked to a standstill. It's lying aslant of the lane, I'm tucked in behind with my hazards on, children all right so far as I can see.",
#:   "On the highway to Lyon a big truck rolls before us, and his tyre makes like a cannon. He goes of travers, one sees that the chauffeur fights and brakes with all his force. And at the end he is immobile, the nose in one side, the tail in the other, and our lane does not exist anymore.",
#:   "The brain is slow, the podcast doctor told us, and he gave an example. His wife remembers the sound; he remembers the rear lights of the car ahead wandering off where they shouldn't and then blazing. Neither remembers it stopping, but it must have, because there it was, angled over the lane, with one wheel down to the rim.",
#:   "He had ridden behind his brother for three hundred miles, a steady thirty yards between them. Then the tyre in front of him went, softly, like a cough. The back of his brother's machine swung wide, its brake light burned, and when it had quite stopped it was lying over the lane as a bolt lies over a door, with the rider standing beside it.",
#:   "As an HGV driver you dread it, a front going at speed. The tipper I was following had it happen, I saw him yanked off to one side as if by a rope. Fair play, he got on the brakes and held it, but where he'd come to rest he was across the lane from line to line, and there I sat.",
#:   "My little one thought somebody had let off a firework. It was the coach in front of ours. I saw it tip and slide off crabwise, the passengers all grabbing the seat tops, saw the red lights go on and stay on, and we ended up looking at its whole long side, standing where our lane ought to have been.",
#:   "Bang ahead, a lurch, red lamps, and a coach lying athwart.",
#:   "Leading bike's tyre pops; it kicks sideways, brakes, bars the lane.",
#:   "One wheel down, one swerve, one skewed lorry stopped ahead.",
#:   "There was a rim scraping sparks where a tyre had been, the pickup ahead went with it, and once its brakes had won it was lying over our lane.",
#:   "For the lead: trigger pressure loss, steering offset of 0.8 s, then braking to rest with the offset kept, so that the final pose blocks the lane obliquely.",
#:   "heard a shotgun. wasn't a shotgun. van im following goes all crooked, smoke off the brakes, ends up side-on like a garage door in front of me",
#:   "By the ambulance's back wheel burst our lane became a cul-de-sac, since it was flung out of line and its driver could only bring it to rest crossways.",
#:   "Tyre of front school van went phat, whole van jumped to one side, driver was brave and put brake, and in slanting position it has closed our lane.",
#:   "Never mind which tyre, something burst: he lurched off his line ahead of us, locked up, and stood there blocking it at a slant.",
#:   "Rubber has a smell when it's had enough, and we smelt it before we understood the rest. There was also a flapping. Then the caravan that we'd followed from Tours, weren't in line with the road or one another any more, their brakes were crying, and at the end both of them lay over our lane and were still.",
#:   "Find the wheel first, I tell the trainees. It was in the ditch on the left, what was left of it, so that side had burst. Then the scrub marks, which leave the lane's middle for the ditch as well; then the black stripes, all four wheels braking. They end under a bus, its nose to the ditch and its tail over the lane, a blue car close behind.",
#:   "At 61 m of track the lead's left rear wheel speed goes to garbage. Its heading, until then equal to ours, is out by thirty degrees within a second, and its lateral offset by a metre. Longitudinally it is at minus seven until there's nothing left to lose. What's then in our lane, all across it, is a stationary fire engine, and the ego must not try to squeeze round.",
#:   "I had my eye on the hay ahead. So I saw the whole stack lean over to one side, as hay does if the trailer goes to the other. He must have hit something sharp, there'd been a crack. The brake lights ahead were on and stayed on, and when the stack had straightened up I could've walked along it from one white line to the other.",
#:   "Every one of us on the coach outing had a different story. Mabel heard the pop. Joan saw the little silver car in front of us give a sort of skip to the side, on three wheels. I noticed only its brake lights, because they shone in my compact. But we all agreed on the end, a little silver car standing there crossways.",
#:   "A hole you could put your fist through, your honours, in the tread of the police motorcycle that was leading my client. One may imagine the wriggle; one needn't, for there's a wavy line of rubber on the concrete going off to the right. There's then a straight, dark one, the brake. Where this finishes the machine was found, lengthwise over the lane, with its rider still aboard.",
#:   "Radio 3 to base. I'm going nowhere, I've an artic for a garden fence. His front blew, I was right behind him, bits all over my windscreen. He was dragged off towards the verge, he fought it, he'd the anchors on all the way down. He's stopped with his cab one side and his back doors the other and me looking at the word FROZEN.",
#:   "In driving school in Chengdu the master says, do not drive near to old tyres. This minibus in front had such tyres, I saw it too late. One of them is broken with very big sound, the body goes askew to one side, all red lamps are there. When it is quiet, the minibus is still, and it lies across my lane from left to right like a sleeping cow.",
#:   "My pupil wanted to know why I'd told her to drop back from that van. No reason, a nasty noise, a flapping. Ten seconds after that it let go, his rear, and he'd gone off line as if he'd been shoved; on came his lamps. He has ended up diagonal in our lane, with the hazards going, and if you had been where you were, so should we.",
#:   "It's the slowness I remember. We'd a bang, and a black scarf flew up from under the car ahead, and then it had all the time in the world. It slid out of its line like a plate off a tray. It glowed red behind, it slowed, it had finished; there it sat, from verge to middle, a baby in the back looking out at us sideways on.",
#:   "They'd kept the same distance from the mail lorry since dawn, so that it had come to be a part of the landscape. Then the landscape gave a report like a rifle and stepped to one side. Their own feet were on the brake as its lamps were lit; and when the dust had thinned, the lorry was there before them, aslant, filling the way, silent.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "brake", "stop"]
#: position = "ahead"
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
