#: description = "The car drives extremely slowly along its lane."
#: rephrasings = [
#:   "A vehicle crawls ahead at little more than walking pace.",
#:   "The adversary creeps along and holds everybody up.",
#:   "The driver dawdles far below the flow of traffic.",
#:   "The car inches forward and obstructs the lane.",
#:   "A cyclist trundles on at a very low speed.",
#:   "Some slowpoke is pottering along and we're stuck behind him.",
#:   "Vehicle 1 was travelling at approximately 5 km/h in the through lane.",
#:   "Target vehicle at constant low speed, 5 to 10 km/h.",
#:   "stuck behind some old dear in a Micra doing about five miles an hour, could've walked quicker",
#:   "Unit 2, a farm truck, was traveling well below the posted limit, impeding traffic.",
#:   "Bus dawdling, 5-8 km/h, keeps lane. No stop.",
#:   "The target proceeds in lane at a constant very low speed (10 km/h).",
#:   "In front is one bicycle, he goes very very slow, like a turtle.",
#:   "Need a snail: NPC holds its lane at near-idle velocity for the whole run, never halting.",
#:   "The moped puttered along at a snail's pace and there was no hurrying it.",
#:   "That driver's pootling, isn't he? Look at that, barely moving, and he's happy to stay at that all day.",
#:   "behind the slowest bus in history rn, my nan walks faster",
#:   "Tempers frayed behind a tractor-like lorry making no more than jogging pace through the village",
#:   "Your speed, you accept, was that of a man on foot, though nothing obstructed you?",
#:   "Aiyo the car in front so slow until snail also can overtake",
#:   "I've got a fare with a plane to catch and this Sunday driver's ambling like he's following a hearse",
#:   "Abnormally low travel speed of a lane user; persistent moving obstruction",
#:   "SLOWEST motorbike ever holds up entire road",
#:   "The van oozed along its lane.",
#:   "Geriatric pace: that coach must be doing six miles an hour.",
#:   "Bin wagon ambling in its lane, walkers going past it, over.",
#:   "Make the van drive so slowly that prams would pass it.",
#:   "Das Auto in its lane rolls only with Schritttempo, terrible.",
#:   "Can anything on two wheels go that slowly without toppling over?",
#:   "I missed my dental appointment owing to a hatchback whose driver saw fit to tootle along his lane at a speed at which I could have read every shop sign.",
#:   "Unit 2, a moped, kept to its lane throughout but covered the 200 m between the two cameras in well over a minute.",
#:   "A lorry loaded with hay was plodding along, engine grumbling, at a rate that let the boys on the pavement keep up with it at an easy trot.",
#:   "The obstacle vehicle shall be driven in the centre of its lane at a steady speed not exceeding 8 km/h for the entire duration of the run.",
#:   "Loads of us were going mad, cos this bus was just sort of slithering down its lane at tortoise speed, not stopping, not speeding up, nothing.",
#:   "My daughter says I drive too carefully, but even I lost patience with the gentleman in the brown Rover, who was progressing along his lane more slowly than I walk to church.",
#:   "Nobody could say what was wrong with the truck. It had no hazards on and no flat that we could see, it kept nice and straight in its lane, yet it was going along at about the pace of a funeral, and it kept that up for as long as I had it in view.",
#:   "I want to check how the planner copes with a really sluggish road user. Take any car, keep it in its own lane, and let it proceed at a tiny fraction of the limit from the first frame to the last. No halting and no drifting over, just painfully low speed.",
#:   "As a cyclist you seldom get to complain about slow people. Yesterday, though, there was another chap on a bike, upright basket type, spinning the pedals maybe once every two seconds, and he carried on along his lane like that as if he had till Christmas.",
#:   "Witness states: \"I was smoking outside the shop and the red car went by so slowly I could've leaned in and had a chat with the driver. He stayed in his lane, he didn't stop, he just kept on at that walking-the-dog sort of speed all the way to the bend.\"",
#:   "For the impeding-traffic case we recorded a bus whose gearbox had gone into limp mode. It remained in lane, upright citizens staring at their phones in the windows, and made barely two metres per second, which our following logic mistook for a parked object.",
#:   "Bike at a dribble, own lane, going on and on like that.",
#:   "Coach proceeding; a pedestrian with a suitcase just passed it.",
#:   "Who drives at four miles an hour? This pickup does.",
#:   "The speedometer needle of that moped can hardly have left its peg, and for the entire length of the avenue it was ridden so, straight and without a pause.",
#:   "Take any lorry; give it its lane and a speed that a jogger would be ashamed of; don't let it stop, and don't let it hurry up either.",
#:   "Due to a suspected fuel problem, V2 was being driven at a small fraction of the posted speed and kept to its lane at that rate for six blocks.",
#:   "We counted eleven lamp posts in ten minutes, the bus and we, because its driver would neither get a move on nor pull up anywhere.",
#:   "A constable timed the defendant's van over a measured hundred yards; at eighty seconds he put his watch away, the van still plodding along within its lane.",
#:   "Heavy vehicle, 6 km/h, lane-centred, no variation throughout the run: in effect a wall that happens to be on wheels and moving very gently.",
#:   "It wasn't a breakdown, because when the road bent he bent with it and he never once came to a stand. It was simply an elderly gent in an elderly Volvo for whom second gear was a wild adventure. Prams overtook him on the pavement. A pigeon walked in front of him for a bit.",
#:   "I am a postwoman and do my round on foot. On Monday a yellow hatchback accompanied me down Elm Grove. I'd put a letter through a door and come back to the gate, and there it would be, level with me again, engine murmuring, keeping in its lane, in no sort of hurry with the world.",
#:   "My sat nav said four minutes. It said four minutes for a good long while, because a tractor-tyred lorry was using the lane at what I'd call glacier speed. Nothing wrong with how he steered, and he never actually halted. He just ate up that road one spoonful at a time.",
#:   "Perception flagged the bus as static for the first nine frames, and you can see why. Displacement between frames is about five centimetres. It isn't parked, though, and it isn't braking; it keeps to its lane and makes steady progress at less than the pace of somebody strolling, until the log ends.",
#:   "The child in the back asked whether the car was poorly. It did look it. Its wheels turned so lazily that you could follow the valve going round, and still it went on, in the middle of its lane, never faster and never quite stopping, with a tail of furious people behind.",
#:   "I ordered the taxi to be quick, and what arrives? A driver who tells me that slow is safe. We are rolling in our lane like a wedding carriage, persons with crutches pass by, bicycles ring at us. I jumped out at the end, while he was moving, and did not even stumble.",
#:   "Heat had got into the old man's bones, or into the bike's, for the pedals came round as seldom as a clock strikes. He kept his lane. He kept on. By the time he'd passed the bakery the smell of bread had changed to the smell of cake, and he was still passing it.",
#:   "Test sheet 22 B. Target: two-wheeler. Path: centre of own lane, no lateral deviation. Speed: the lowest at which the rider is able to stay upright, to be held over the complete distance. There is no halt, no final acceleration. Pass criterion: the vehicle under test recognises a moving, not a standing, object.",
#:   "We had the ambulance booked for a film, you see, and the director wanted the road to itself with only a hearse-like procession of one. So I took my Bedford truck down the high street, in lane, in crawler gear, so slow the extras had to take smaller steps. Two cars hooted, and I don't blame them.",
#:   "You're frustrated, I can tell from your knuckles. But the biker's entitled to his lane. He's making, what, five miles an hour, and he'll likely be making five miles an hour at the top of the hill as well. He isn't stopping and he isn't turning, so relax and drop back a bit.",
#:   "Insurers will ask what hit whom. Nothing hit anybody. My frozen fish thawed, that's the claim, and it thawed because the coach that had the lane went along it from Newbury to the roundabout at a speed which would have disgraced a steamroller, and did so with perfect steadiness, and there was no getting by.",
#:   "Moped, own lane, four mph, mile after mile of it.",
#:   "overtaken by a duck. the bus i mean. by a DUCK",
#:   "Ghost of a lorry: it moves, but you need a landmark.",
#:   "My pedometer and that coach's tachograph would have agreed to within a yard, for it kept its lane and a walker's gait from one end of town to the other.",
#:   "Set the target's speed to the smallest value at which it still counts as moving, centre it in its lane, and leave both alone until the end.",
#:   "Ten minutes for one mile is what the electric cargo bike in the lane needed, and it had no more intention of hurrying than of halting.",
#:   "The trouble with the van wasn't that it stopped, since it never did, but that in four changes of the lights it had come no further than the chemist's.",
#:   "In my village we say about such a driver, he is counting the stones. In his lane, correct, straight, and each stone he counts two times.",
#:   "V2's wheel rotation, read off the shop camera, corresponds to 7 km/h; V2 neither varied this figure nor departed from its lane during the ninety seconds recorded.",
#:   "I had my window down, and so did he, which is how I came to hear his whole phone call, from hello to goodbye. I was on foot. I was pushing a pram. The Volvo was in its lane next to my pavement, wheels turning over like a mangle, and I wasn't even making an effort to keep level.",
#:   "Something was in the lane, so the convoy bunched up. The first driver to see past the rest said it was a tractor, the second said a breakdown. When it was my turn I saw neither: it was a tour bus, in fair working order, being driven at the rate at which you'd wheel a wardrobe, and it went on being driven so until the county line.",
#:   "The dew gave it away. That morning each vehicle had left a pair of dark stripes on the road, and when I came upon the pickup the drops were still hanging from the wheel arches, unshaken. It was rolling, I'll swear to that, dead straight in its lane, but a snail would not have felt the draught.",
#:   "For the long-queue experiment we need a plug. Not a parked one, the ego would simply go round it in the map sense; one whose position creeps on by a metre or two each second, in the middle of its lane, no wander, no pause. A lorry does it best, because you cannot see over it. Seven kilometres an hour will do nicely.",
#:   "Why did the bailiff's van take forty minutes from the bridge to the court house, counsel enquired, a matter of two miles? It had not broken down. It had not stopped for anybody. It had not left its lane. \"I was being paid by the hour, sir,\" came the reply, \"and I had her at a tick over the whole way.\"",
#:   "We'd timed the lights so that a car leaving the first on green would meet the other five on green too. The motorbike met the second one on red, the third on red, and so on down the avenue. It wasn't waiting between them; it was just drifting up its lane with its feet skimming the ground, because the rider was afraid for the cake on his lap.",
#:   "Radio says traffic is heavy on the ring road. Traffic isn't heavy, I've had eyes on it. What you have is eighty cars that would like to do fifty, and at the head of them one horsebox whose driver's got the needle sitting on the bottom pin. She's in her lane, she's legal, she isn't stopping, and there's mares in the back. Over.",
#:   "Papa said we could play the game where you guess the next thing we come to. But the next thing was always the same back of the same bus. I learned all the words on it. I learned the number for ringing up about its driving. Its wheels had a yellow bolt, and I could say a whole poem before the yellow bolt came round to the top again.",
#:   "On the third lap the ego's planner began to wonder whether the bicycle was an obstacle or a road user. Its displacement from one second to the next was below a metre and a half, always along the lane, never sideways, never nil. The follower therefore sat at walking speed for four minutes, the correct answer, and drained its battery heating the cabin.",
#:   "It isn't natural for a forty-tonner to be so quiet. You expect the roar, the wind of it, leaves going up. All that came was a sort of purr, and then the radiator, and then, after I'd finished my sandwich on the wall, the door; and when I'd folded the paper up there was still some trailer to come. He hadn't stopped. That was him going by.",
#:   "At first I admired it. Here was a man in a tiny three-wheeled car who'd decided that forty was the world's speed and four was his. Nothing leaned on him: not the hooting, not the tail of us winding back to the dual carriageway. He kept to his lane like a bead on a wire, and against a lamp post you'd see the bead was, just about, sliding.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(0.8, 3.2)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
