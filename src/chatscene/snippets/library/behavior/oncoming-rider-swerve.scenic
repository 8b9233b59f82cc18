#: description = "The oncoming motorcyclist unexpectedly swerves into the lane the ego is using."
#: rephrasings = [
#:   "A rider coming the other way veers toward the middle of the road.",
#:   "The approaching motorbike jerks over in front of the ego.",
#:   "From ahead, a two-wheeler suddenly leaves its line.",
#:   "The oncoming cyclist lurches sideways before the vehicle.",
#:   "The biker riding toward the ego darts across its lane.",
#:   "the biker coming at us suddenly jinks across",
#:   "A motorcyclist approaching in the opposing lane swerved abruptly.",
#:   "The rider from in front makes a quick movement to our way.",
#:   "A lad on a pushbike coming the other way suddenly swung over into my lane.",
#:   "The motorcyclist, traveling in the opposite direction, veered without warning into the lane occupied by Unit 1.",
#:   "Opp. biker darts into ego's lane. No sign.",
#:   "The oncoming powered two-wheeler target makes a sudden lateral movement into the lane used by the VUT.",
#:   "The man on motorbike comes against me and suddenly changes into my lane.",
#:   "Oncoming two-wheeler jinks into our lane at short range; head-on risk with a VRU.",
#:   "He came pedalling down to meet her and then, heaven knows why, jerked his handlebars over into her lane.",
#:   "Scooter coming towards you, watch him, he's flicked over onto our side!",
#:   "biker coming at us just swung over into OUR lane im shaking",
#:   "An approaching motorcyclist jerked out of his line into the lane of a family car.",
#:   "The rider, coming the other way, quit his side in an instant and was in my client's lane?",
#:   "Opposite side bike fellow suddenly cut into my lane, heart attack I got.",
#:   "Lad on two wheels coming at me throws it over onto my side. Death wish.",
#:   "Sudden lateral incursion of oncoming two-wheeler into ego lane.",
#:   "MOTORCYCLE SWERVES INTO MY LANE HEAD ON",
#:   "The oncoming cyclist jinked into our lane.",
#:   "Moped approaching head on snaps sideways into the lane we're in.",
#:   "Facing cyclist, no warning, lunges over into ego's lane.",
#:   "El ciclista comes front to me and suddenly throws himself on my lane.",
#:   "Opposing motorcycle breaks across to our side, out of the blue.",
#:   "Let the scooter riding toward us veer abruptly into our path.",
#:   "From the other direction came a boy on a bicycle, quite straight, and then with a twist of the bars he was in the lane we needed.",
#:   "A motorcyclist who was about to pass us in the usual way, driver's side to driver's side, pitched over without notice into our very lane.",
#:   "The robotaxi's lane was invaded when an approaching biker, for reasons still unknown, slewed out of his own half of the road.",
#:   "Nobody had given that cyclist a reason; she was coming the other way and all of a sudden her front wheel was pointing at our lane and she was in it.",
#:   "On closing to forty metres, the opposing two-wheeler departs from its line by a sharp steering input towards and into the lane in use by the VUT.",
#:   "Keep left now, that motorbike up ahead that's heading for us has just lurched across, he's in your lane, be ready for him.",
#:   "I deliver parcels, I look at oncoming bikes all day. This one was a courier like me, coming towards my van on his own side, hands on the bars. Then it was as if somebody had kicked him: he shot sideways and was in front of me on my side.",
#:   "V1 was traveling north. V2, a bicycle, was traveling south in the opposing lane. As the distance closed the bicyclist made an abrupt and unexplained lateral movement to the left and entered the lane in which V1 was traveling, placing the two on a collision course.",
#:   "A moth, it may have been, or a spark from his cigarette. The motorcyclist whom they had watched for a mile coming down the valley towards them gave a start, and the machine with him, and it leapt out of its own half of the road into theirs.",
#:   "In scenario 9 the opposing rider travels its normal path at constant speed. When the gap to the ego has shrunk to the set distance it yaws suddenly and moves into the ego's lane. There is neither a turn signal nor an obstacle which would explain it.",
#:   "Me and my sister were counting motorbikes. The fourth was coming at us from the front and then he went zip, over the white line, right into our bit of the road, and Mummy pulled on the wheel and said sorry to him, but it was him!",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "swerve"]
#: position = "oncoming"
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 40.0
#: unit = "m"
#: meaning = "distance to the ego at which it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.2
#: high = 1.9
#: unit = "m"
#: meaning = "how far it swerves"

param OPT_ADV_SPEED = Range(4, 10)
param OPT_ADV_DISTANCE = Range(12, 40)
param OPT_SWERVE = Range(1.2, 1.9)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
