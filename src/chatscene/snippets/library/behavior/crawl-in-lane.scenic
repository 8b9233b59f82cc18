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
