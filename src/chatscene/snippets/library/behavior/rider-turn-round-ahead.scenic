#: description = "The rider ahead brakes, whips round in a U-turn and comes back past the ego."
#: rephrasings = [
#:   "The cyclist in front pulls a U-ey and comes back the other way past us.",
#:   "The bicyclist executed a U-turn ahead of Vehicle 1 and returned in the opposing direction.",
#:   "bike ahead U-turns, comes back",
#:   "The target ahead turns through 180 degrees and approaches the VUT alongside.",
#:   "The cyclist before us turns round completely and rides to us.",
#:   "A food courier who missed the address spins about in the road.",
#:   "The scooter ahead loops round tightly and buzzes back toward us.",
#:   "Without warning the biker reverses course in one sweep and faces us.",
#:   "the cyclist in front braked, spun round on a sixpence and came back past me the other way",
#:   "The motorcyclist ahead braked, made a rapid U-turn and rode back past V1 in the opposite direction.",
#:   "Bicycle ahead: brk, 180, passes us going back.",
#:   "The PTW ahead decelerates, performs a tight U-turn and passes the VUT in the opposite direction.",
#:   "The bike in front brakes, turns around quick and comes back against me and goes by.",
#:   "Lead rider flips heading by 180° after a short brake and becomes opposite-direction traffic next to the SUT.",
#:   "He had been riding on ahead; then he checked, doubled back on himself, and went by their window with a nod.",
#:   "Forgotten something, has she? On the brakes, whips the moped round and here she comes back towards us.",
#:   "bike in front did a full uey and rode back past us waving",
#:   "A cyclist who braked and spun about was soon travelling back along the column of cars behind",
#:   "Having been ahead of my client and going her way, you braked, turned about and met her face to face?",
#:   "Scooter in front brake, then take U-turn and come back opposite beside us",
#:   "Forgot his chips, must've, brakes, whips it about and comes back by my window",
#:   "Braking and about-turn of leading two-wheeler; subsequent opposing pass",
#:   "Motorbike ahead spins around and rides BACK at me",
#:   "The cyclist ahead boomeranged past us.",
#:   "Cyclist ahead slows, about-turns, now meeting and passing us.",
#:   "Scooter in front: brake, half-circle, opposite-direction pass.",
#:   "The bike lady in front stopped pedalling, turned round and rode past us.",
#:   "Where's he off to? Brakes on, round, and back past my window!",
#:   "Motorbike ahead checks, pivots, returns along our flank.",
#:   "Make the moped that leads the ego lose speed, swing about tightly and ride back in the opposite direction so that it goes by the ego.",
#:   "His brake lamp glowed, the Vespa he was on curled round in its own length, and a moment later we were looking at his face going by.",
#:   "V2 was a motorcycle travelling ahead of V1; its rider reduced speed, reversed his direction of travel by a turn, and passed V1 on the opposite heading.",
#:   "First he is before me with his bicycle, then he brakes, he makes demi-tour, and at the end we cross each other.",
#:   "Watch your paintwork, the lad on the bike in front has pulled his brakes and come about, and he's going to squeeze back by us.",
#:   "He had dropped his wallet, and so the motorcyclist we were following braked, hauled the machine round and rode back beside our queue.",
#:   "Now we were behind a cyclist, a chap in orange, keeping nicely over to the side as if inviting us past. Then his brakes squealed, he swung himself completely round in the road before us, and there he was coming back the other way, grinning as he went by.",
#:   "The leading rider keeps to the right of the lane. When the subject vehicle has closed to the given headway, the rider sheds speed, executes a turn of 180 degrees, and thereupon becomes an opposing road user who passes the subject vehicle with little lateral clearance.",
#:   "My pupil wanted to overtake the moped and I told her to hang on, as he'd been looking over his shoulder. And what does he do? Slams the anchors on, spins it round to face us, and rides off the way we'd all come, brushing past our mirror.",
#:   "There's no lane change and no junction, so our tracker assumes he'll carry on. Instead the biker in front of the robotaxi brakes from twenty to ten, flips round, and drives back past the left-hand sensors with a relative speed that nobody had planned for.",
#:   "\"He's forgotten the bread again,\" said my husband, for it was our neighbour on his bicycle there in front of us. He squeezed the brakes, teetered, went round in one sweep, and trundled past the car door homewards, not seeing us at all.",
#:   "Biker we're following checks, wheels about, returns past our window.",
#:   "Lead cyclist: decelerates, half-circles, goes by on opposite heading.",
#:   "Scooter in front pulls up short, swivels, and meets us.",
#:   "We'd been staring at the same mudguard for a mile when the man squeezed his levers, came about in the road and rode off by our elbow.",
#:   "Let the motorcycle before the ego brake, go round in one tight turn, and return in the opposite direction at the side of the ego.",
#:   "Before me the velo, he brakes, he makes a turn on himself, and we cross, he goes there from where I come.",
#:   "Rider up front's on the anchors, he's got the bike swung round, he's heading back at us, keep to your side and let him by.",
#:   "From behind the wheel of the van I noticed her brake light, her shoulder, her front light and then, as she came by, a very apologetic smile.",
#:   "V2, the lead bicycle, slowed, turned through 180 degrees ahead of V1 and traveled back toward and past V1 on the left.",
#:   "When the postman's in front of you on his bike, be ready for it. He'd ridden by the Hendersons' and hadn't noticed the parcel was theirs. On went his brakes, and round he came, bag swinging, in the width of a bath towel; and a moment later there he was on his way back, passing so near he could've knocked on my window.",
#:   "The AV had been following an e-scooter, keeping the legal gap. Radar first reports that the scooter is losing speed. The next thing it says makes no sense at all till you look at the picture: closing at eleven metres a second. The rider has turned about on the spot and is now coming the other way, and goes by on our left.",
#:   "In the rally all of us stay behind the lead motorcycle, he knows the way. He did not know the way. At the windmill he took his brakes, so I too, and then he has turned the machine around in front of my wheels and drives against the whole column, with his hand up, past me, past everybody.",
#:   "It began, for my passenger at any rate, with a face. There was a man on a moped riding at her, by the side of our car, and she couldn't think where he had sprung from. He'd been in front the whole time with his back to us. He had dropped his speed, spun about and was going home.",
#:   "Purpose of this case: the target changes its role. As a preceding two-wheeler near the right-hand edge it first reduces its speed to that required for the turn. It then carries out an about-turn at minimum radius. Finally, now as opposing traffic, it passes the vehicle under test, at a lateral distance which shall be recorded.",
#:   "He'd have been well advised to stop and get off, as my driving instructor pointed out. He didn't. The young lad on the racer in front of us had heard his mate shout, so he hauled on both brakes till he'd hardly any speed, threw the bike about in the road, and hared back along the side of us towards him.",
#:   "Witness: The motorcyclist was ahead of me, sir, going the same way. Counsel: Yet you were photographed passing each other. Witness: He had braked. And he turned it round, all the way, in front of me. Counsel: And then? Witness: Then he drove past my door, the way I'd come. That's when the camera went off.",
#:   "There's a sudden shower at the start of the clip, and every cyclist in the city has the same idea. The one the cammer's following brakes, you see the spray off her rims. She hooks it around ahead of the car, one go. She comes pedalling back along its flank with her hood up, making for the bridge.",
#:   "What I heard from my bunk in the back was: \"He's stopping. He isn't, he's turning round. Oh, you idiot.\" Then a moped, quite loud, first in front of us, then right beside my ear, then behind. Les told me the rider had been up ahead of the lorry since Dover and had only now noticed that he was on the wrong side.",
#:   "One flap of a coat, one tinkle of a bell: old Sister Agnes had forgotten the communion wafers. She braked, there on the road before us, and it was not a gentle sort of braking. With great resolve she brought her bicycle about, and we, who'd been following her to church, had her coming by us in the direction of the convent.",
#:   "tailing this guy on a dirt bike who clearly has no idea where hes going. brakes, looks left, looks right. then he rips it round in a full 180 with his foot down and he's coming at us!! goes past like an inch off the paint, same way we came from. no signal obvs",
#:   "Back of a bike, side of a bike, bell in our ear.",
#:   "Moped ahead anchors, hairpins, waves at us going by.",
#:   "We led behind her; two seconds on, she met us.",
#:   "Its brake lamp winked, and the next lamp we saw on that motorbike was its headlamp, coming by our window.",
#:   "Get the cyclist before the ego to lose speed, hook right round and ride off past the ego towards whatever's behind it.",
#:   "The scooter that I'd been following for a mile is now behind me, and I never overtook it; it braked, spun and came past.",
#:   "V2, a motorcycle preceding V1, slowed, and with its heading reversed was next recorded abeam of V1, travelling the other way.",
#:   "How come the boy whose rucksack you've been staring at since the bridge is now pedalling at you and giving you a grin through the side window?",
#:   "The velo was before me, it slows, he goes around in one stroke, and we cross ourselves, he going there from where I come.",
#:   "I've got a rear camera as well, and it's the rear one you want to look at. For ten minutes there's nothing on it. Then, from the left, there's the same racing cyclist that the front one's been showing us from behind for those ten minutes. The front one's last picture of him: hand on the lever, front wheel hard over.",
#:   "Ting went something on the tarmac, and I knew that he'd lost a bit of his motorbike. He knew too. His lamp lit, he was down to a jog in no time. I kept to my half, thank God. He slewed that thing about under my bumper and came burbling back beside the lorry, eyes on the ground, hunting for it.",
#:   "Constable, if he'd been coming towards me from the outset I'd have had nothing to say. He was in front, going along as I was. He touched his brakes and I touched mine. And then this bicycle went round, whip, like a cat that's been trodden on, and scraped along the side of the Rover in the direction of the sea.",
#:   "Relative speed, minus two: she's lost pace ahead of us. Heading, 40, 90, 150, 180: she has twisted the e-bike all the way round. Relative speed, minus eleven: she's coming back at us. Lateral offset 1.6, range negative: she has passed. The whole thing took four seconds and the follower module had a nervous breakdown in each.",
#:   "His girlfreind had dropped off the back of the pillion, as we could see and he couldn't. When he'd noticed, the wheel locked. He dabbed a foot down, flicked the Vespa round on it, and rode back the way we'd all come, past us in our minibus, so white in the face I forgave him.",
#:   "Rule for following two wheels: leave room for a turn. See the postie there, satchel on the handlebars? There's a letter he's forgotten. He's squeezing his brakes. He's not going into a drive, he's not getting off, he's bringing her round, right round, and now you're looking at the front of him, and now he's by your elbow, and gone.",
#:   "At the trigger the motorcycle, which rides ahead near the right-hand edge of the lane, is retarded to turning speed. A half-circle to the left follows, by which it comes onto a course opposed to that of the vehicle under test, and it holds this course until it has gone by. No standstill, whether before the turn or after.",
#:   "The convoy had a scout on a motor bicycle. It was his business to lead and ours, in the staff car, to be led. I was therefore put out when his stop light glowed, when he flung the machine about at the crest as though he'd seen the devil, and when he shot back along our flank shouting \"Tanks!\"",
#:   "Someone whistled, and that's not me guessing, the microphone's got it. A whistle, then the squeal of the delivery bike's discs ahead of us, then rubber scrubbing in a circle, then his engine, quieter, louder, loudest at our right-hand mirror, quieter. We're a robotaxi. We don't turn our head after people, but our passenger did.",
#:   "In the hills near my home the boys on motorbikes go before your car for guiding to the hotel, they want commission. Mine looked in the mirror and saw a bigger car behind me. Immediately he has put brake, one turn like a circus, and he's coming towards me, passing me, and guiding that car. I was left alone with my hairpins.",
#:   "There ought to have been a bicycle between us and the tractor, which is where there'd been one all along. What there was instead, at the level of our back seat, and travelling fast in the wrong direction for Sunday lunch, was Aunt Maud upon it. She had pulled up a trifle, we pieced together, and had slung it round. \"The oven!\" she cried.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "u-turn", "oncoming"]
#: position = "ahead"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.6
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -20.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts at the latest"
#: [[parameters]]
#: name = "OPT_REACT_DISTANCE"
#: low = 4.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far behind it the ego is when it acts"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 1.8
#: high = 3.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_SPEED = Range(1.6, 2.4)
param OPT_ADV_DISTANCE = Range(-20, 5)
param OPT_REACT_DISTANCE = Range(4, 18)
param OPT_TURN_RADIUS = Range(1.8, 3)

behavior AdvBehavior():
    # It keeps right, as if to let the ego pass.
    do DrivePath(advTrajectory, 5, -1.9) until self.pose[3] > 4.2 and (headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE or distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE)
    do BrakeOnPath(advTrajectory, 0.5, -1.9) until self.pose[3] < globalParameters.OPT_ADV_SPEED
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
