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
