#: description = "The truck ahead swings wide to the left and then turns right off the road."
#: rephrasings = [
#:   "The artic in front of us swings way out left and then hooks right.",
#:   "Vehicle 1, a heavy truck, moved left to gain room before making a right turn into an access.",
#:   "Lead truck swings out left, turns right off road.",
#:   "The target heavy vehicle makes a lateral offset to the left and then turns right across the path of the VUT.",
#:   "The big truck makes first to left and then it turns to right, we think it lets us pass.",
#:   "A coach ahead fakes left to get its tail round and sweeps right into the yard.",
#:   "The bus we follow takes a wide arc, out to the left and back across to the right.",
#:   "Looking as if it pulled left, the long lorry suddenly comes round to the right.",
#:   "The artic in front went miles out to the left before hauling itself round to the right.",
#:   "The tractor-trailer ahead moved left to make a wide right turn off the roadway.",
#:   "Semi ahead: out left, then R turn off road.",
#:   "The heavy goods vehicle ahead displaces to the left prior to performing a right turn and leaving the carriageway.",
#:   "Long bus before me goes first to the left side and then turns right.",
#:   "Long lead takes a wide arc, left offset first, then exits right, so don't undertake it.",
#:   "It leaned away to the left so far that he thought it was making room, and then its whole length folded off to the right.",
#:   "Don't go up his inside, that bus needs room, he's swinging out left so he can make the right.",
#:   "the truck ahead went way left and i thought he was going left and then he turned RIGHT",
#:   "A long lorry veered out to the left before sweeping right into a turning, surprising those behind.",
#:   "In order to go right, the bus first bore out to the left, and my client was deceived by it.",
#:   "Trailer in front go all the way left first then turn right, cannot trust.",
#:   "Big rig takes half of Kent to get round, shoves out left and then folds himself off to the right.",
#:   "Leftward off-tracking of preceding long vehicle prior to right turn-off",
#:   "SEMI FAKES LEFT, GOES RIGHT - wide turn close call",
#:   "The long bus balloons out leftward and then bends off to the right.",
#:   "Artic up front: bulges out left, then peels off hard right.",
#:   "Bus ahead needs the whole road: left a bit, now right, gone.",
#:   "I want the lorry before us to arc leftward, then exit the road right.",
#:   "Daddy, the long truck leaned that way first, then went in on the right!",
#:   "Primero the truck ahead opens to left, después it goes inside on the right.",
#:   "The coach we'd been trailing bowed away to the left, as if to oblige us, and then its front came round and it left the road rightward.",
#:   "To line itself up for the factory gate on the right, the low-loader in front had to steer out well over to the left beforehand.",
#:   "Never fill the hole on a big vehicle's right when he's eased over to the left in front of you: watch him now crank it round into that entrance.",
#:   "A heavy goods vehicle preceding the VUT shifts laterally by approximately 2 m to the left before commencing a tight right-hand turn out of the carriageway.",
#:   "It disappeared into the lane on our right in the end, the cattle truck we'd been following, although it had started by heading off towards the left kerb.",
#:   "Did V2, the semi in front, not first go out to its left before it came about to the right and quit the highway for the truck stop?",
#:   "When the truck ahead of me wandered to the left, I thought he was making way, so I started to come up the inside on my motorbike. Luckily I looked at his front wheels. They were already on full right lock, and the entire rig then came sweeping round into a side entrance.",
#:   "Ticket for the sim team: articulated lead vehicle, low speed. It has to displace to the left by most of a lane so the trailer won't clip the corner, after which it makes the right-hander into the depot. Our intent module reads the first half as a lane change left. It isn't.",
#:   "I've driven buses out of that garage for thirty years, and every day some car gets caught. You take her out to the left, as far as the other fellow will let you, and then you bring her round right into the yard, and there's always one behind you who only believed the first bit.",
#:   "The plaintiff was travelling in the wake of the defendant's tractor-trailer. That vehicle, needing room, deviated to the left by some six feet; it then described a broad curve to the right and passed out of the road through the quarry entrance, closing the space in which the plaintiff found himself.",
#:   "Mirrors, everyone! So the clip from this week shows a dustcart ahead of the cammer going for what looks like the left side of the street, and the comments are all \"he's turning left\". Nope, after that little detour he rolls it round to the right and off the street he goes.",
#:   "Bendy bus ahead goes wide left, then tucks itself in to the right.",
#:   "Low-loader in front: false move left, real move right, off the road.",
#:   "First left, then hard right through the gate, says the trailer ahead.",
#:   "It's geometry, my dear: a lorry that long has to borrow ground on its left before it can be got round into an opening on its right.",
#:   "A transporter travelling before Vehicle 1 strayed over to its left, slowed, and from out there commenced the right turn which took it into the plant.",
#:   "The dustcart up ahead, bound for the tip on the right, needed a run-up, so it went out leftward as far as the line allowed beforehand.",
#:   "Instruct the coach we follow to drift most of a lane width to the left and from that position to haul round to the right, out of the street.",
#:   "Schau, the long truck before us makes a belly to the left side, and only after the belly he goes into the yard, which is right.",
#:   "Anyone behind the livestock lorry would have bet on left, its nose being already over there, until the whole outfit came about and departed through a gap on the right.",
#:   "I had a pupil burst into tears over this. Long bus in front, slowing down, and it wandered off to the left, so naturally she took it that the road was hers. It was setting itself up. From over there it came right round, like a door closing, and took its fifty feet of flank into the depot on the right-hand side.",
#:   "There are tyre marks in the flower bed on the left-hand side of the street, and there's a lorry at the loading bay on the right. What connects them is the manoeuvre I'm reporting. It had been leading me down Canal Road, and it could only make the bay, the driver said, by visiting the flower bed first.",
#:   "You could read the sign on its back, TURNS WIDE, and still not believe it. The artic we'd caught up with slid over leftwards until we could see clear road past its right flank. A biker went for that clear road. Then the cab reappeared, on the right, sideways on, heading into the timber yard, and the biker used up all his luck.",
#:   "In Mexico the chofer makes always la finta. The big bus goes in front of my car and he opens himself, opens himself to the left, so much that the people on that pavement jump. You think he will park there. No señor. He brings the nose to the other side and he enters completely in the terminal, at the right.",
#:   "The plaintiff reproaches my client with having feinted. With respect, a vehicle of sixteen metres does not feint; it makes room. It was in front of the plaintiff, it stood out to the left so as to clear the gatepost, and it was then steered to the right and in at the gate, to which its indicator had been pointing all along.",
#:   "Intent labelling for heavy leads, example 17. Annotators gave it \"lane change left\" up to frame 80, and with good reason: the lateral offset reaches 1.9 m on that side. From frame 81 the yaw rate reverses, and between there and frame 140 the vehicle rotates to the right and exits the road. Please relabel as a single wide right-hander.",
#:   "From the handlebars, the lesson is as old as lorries. A truck ahead of you that suddenly leans off to the left isn't giving you the right-hand gap as a present. That gap's where he'll be in a moment. Mine opened it up for me at the bottom of Forge Lane and then went through it himself, all five axles, into the sawmill.",
#:   "Grandma has the front seat and she gives a commentary. \"That horsebox is turning left. No. That horsebox is turning round. No. Oh, I say, he's only been out there to get a better look.\" And with that the great thing in front of us hauled itself to the right and squeezed out of the road between two stone lions.",
#:   "By night a road train is nothing but lamps. We saw the string of them in front of us bend to the left, like a necklace being drawn across a table, and my co-driver said it was the left-hand fork. But the head of the string curled back, crossed our view from left to right and went out, lamp by lamp, down a side track there.",
#:   "Manual, chapter 9, long vehicles in front of the ego. The path consists of an offset, followed by a curve. The offset is to the left, and it should be large enough that a following driver may be deceived by it. The curve is to the right; it begins on the offset, not on the original line, and it leads off the carriageway.",
#:   "It was all a question of whether to trust the winker or the wheels. The coach we were stuck behind winked right. Its wheels took it left, well left, nearly up on the verge with the cow parsley brushing its windows. Dad said winkers lie. But it was the wheels that had lied, since it swept round to the right and up the castle drive.",
#:   "Artic in front shows you left, takes right, leaves the road.",
#:   "long bus ahead drifted way left then FOLDED itself right into the depot",
#:   "Transporter ahead: bellies out left, comes about, off through right gate.",
#:   "The space that appeared on the right of the lorry in front, when it moved over to the left, was the very space it needed a second later for getting through the gate on that side.",
#:   "You'd be a fool to pass that bus on its right just because it's out by the left-hand kerb, since the depot is on the right and its tail is a long one.",
#:   "For a tanker of such length the farm entrance on the right could be hit only after a good helping of the left side of the street had been used up, as we behind discovered.",
#:   "Lead HGV: reduce speed, offset 2 m towards the left edge, hold until the tractor unit is level with the opening, then full right lock and leave the carriageway.",
#:   "The rear of the coach we followed went one way and then its front went the other, and it was the front, swinging in at the hotel on the right, that meant it.",
#:   "I want a lead truck whose first move is a lie: over towards the left, as if it had given up the road to us, and thence round and out to the right.",
#:   "My side mirror's in the hedge of number 5, on the right, and here's how. The removal lorry ahead had got itself right over by the houses with the even numbers, the left ones. I thought, he's delivering. I drove on. Next thing, sixty feet of lorry was shutting like a gate between me and number 5, and its cab was already up the lane there.",
#:   "Draw it for the jury, please. The witness drew a line going up the page; that was the bus, with himself underneath it. The line bulged out to the left. At the top of the bulge it doubled round, came back over where it had been, and left the page on the right-hand side. \"And that's the coach park,\" he said, and put a cross.",
#:   "Fresh paint has its uses. The white line on the left of Quay Street was wet this morning, and a low-loader I was pedalling behind brought some of it away on its left wheels, which tells you how far out it had got. The white prints then curve across the entire street, in front of where I'd stopped, and fade out in the shipyard gateway on the right.",
#:   "The pupil says he's pulling in on the left. I say what's behind him? A trailer. And what's over there on the right? A gap in the wall, no wider than a barn door. So he's not pulling in, he's making himself an angle. Wait. Here comes the cab, right across our bonnet, and it'll be a while till we've seen the last of him through that wall.",
#:   "Robotaxi incident 7: undertaking attempt. A garbage truck in front had slowed and gone leftwards, leaving three metres of free lane on its right, and the planner took this for an invitation. It took eleven metres to find out what they were for. The truck's right flank came round, filled them, and passed out of the street into the recycling yard beyond.",
#:   "Le camion devant moi, he has played me a comedy. He makes himself small at left, he brushes the parked cars there, one says he's letting me by. I put my first gear. And then comes his nose back, and his belly, and his tail, everything over to the right, and he goes out by the porch of the winery, with in the middle my scooter backing.",
#:   "What we got to see of Bath was the rear window of the tour bus. It went down in pace, it edged over until the left-hand railings were scraping on its paint, and our guide said that must be the Abbey. It wasn't; it was the run-up. From the railings it wheeled round through the whole breadth of the street and went in at the hotel yard on the opposite hand.",
#:   "Never judge a semi by its first six feet. That's what my dad told me, and I told it to my lad on Monday with an object lesson right in our windshield. Eighteen-wheeler up front, slow, easing off to the left like he's got a date over there. Then the rig jackknifes, nearly, hauls to the right, and he's out of the street and backing up to the Walmart dock.",
#:   "Evidence of prior lateral displacement in the direction contrary to the exit was looked for, and was found: the leading truck's near-left tyre had flattened a cone placed on the left margin. It then took up an arc which crossed the path of the vehicle under test in its entirety, and which ended beyond the right margin, inside the plant. Duration of the whole: nine seconds.",
#:   "Our cat was on the wall on the left, and she jumped down because a dustbin lorry was nearly sitting on the wall too. Mummy was behind it in the car. She said good, he's parking. But our bins are on the right, up the little alley. He had to go by the cat to get into the alley! He swung right round and his bottom only just fitted. Mummy reversed.",
#:   "There was a noise of brushwood, the left side of the horse transporter being in the trees; we hung back. \"He's off the road,\" my wife said. He was on the contrary taking aim. We heard him blow, and saw the headlamps swing over the road before us from the one row of trees to the other, and the whole stable followed them down the bridleway, right.",
#: ]
#: adversaries = ["truck", "bus"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "turn-right"]
#: place = "road"
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.2
#: high = 2.2
#: unit = "m"
#: meaning = "how far out to the left it swings"

param OPT_ADV_DISTANCE = Range(8, 30)
param OPT_BRAKE = Range(0.4, 0.9)
param OPT_ADV_SPEED = Range(2, 3.5)
param OPT_SWERVE = Range(1.2, 2.2)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 1.5
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) until offsetFrom(advTrajectory, self) > 0.8 * globalParameters.OPT_SWERVE
    do TurnOff(-1.4, globalParameters.OPT_ADV_SPEED, 7)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 5 seconds
    do Halt()
