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
