#: description = "The rider ahead swings out to the left and stops there."
#: rephrasings = [
#:   "The cyclist in front moves out and then just stops.",
#:   "The bicyclist swerved left within the lane and came to a stop ahead of Vehicle 1.",
#:   "bike ahead swings out left, halts",
#:   "The target ahead shifts laterally and then comes to rest.",
#:   "The cyclist before us goes to the left and stays standing.",
#:   "To wait for a gap to turn, the biker ahead edges out and puts a foot down.",
#:   "The moped we follow pulls over toward the centre line and halts.",
#:   "A courier up front wanders out and props himself in the road to read his phone.",
#:   "the cyclist in front of me veered out left and just planted himself there",
#:   "The bicyclist ahead moved abruptly to the left and stopped, obstructing the lane.",
#:   "MC ahead: wide L, then halts there, way barred.",
#:   "The bicyclist ahead of the VUT deviates to the left and comes to standstill at that lateral position.",
#:   "The bike in front goes out to the left and then stays there standing, I can not pass.",
#:   "Lead two-wheeler: lateral jump to the left, then v=0 so the passing side is shut.",
#:   "The biker before them had leaned out to the left, and there he pulled up and would not budge.",
#:   "She's come out wide to her left, that cyclist ahead, and she's stopped right where you'd want to overtake.",
#:   "cyclist in front swung out to the left n just stopped there",
#:   "A motorcyclist ahead veered to his left hand and pulled up, leaving no way by",
#:   "You moved out leftward without warning and then came to a stand in front of the claimant?",
#:   "The cycle in front suddenly swing left and stop there, how to pass",
#:   "Bike ahead of me slings it to the left and plants it there, like he's dropped his wallet",
#:   "Leftward swing-out of leading two-wheeler with blocking standstill",
#:   "Biker ahead swings left and PARKS IT",
#:   "The cyclist ahead lunged left and anchored himself.",
#:   "Moped in front sheers off to the left and halts right there.",
#:   "Let the leading cyclist dart leftwards, then stop and stay.",
#:   "Biker ahead jinks left, pulls up, boots on the ground.",
#:   "Lady on a bike before us veers leftward and comes to rest.",
#:   "Preceding scooter: lateral step left, zero speed, stays in that spot.",
#:   "The courier we were following sheered away toward the centre line on his left and stood his bicycle there like a bollard.",
#:   "In front of me the motorcyclist makes a bow to the left and there he is stopping, so the place for passing is gone.",
#:   "With the two-wheeler in front, first a leftward swing of about a metre is produced, and then a halt at that offset.",
#:   "You were setting yourself up to pass that bicycle, weren't you, and look, it's kicked out left and come to a dead stand.",
#:   "What on earth made the lad on the scooter ahead lurch out to his left hand and simply stand about there?",
#:   "She's stationary by the middle of the road now, the cyclist who a second ago flicked left in front of the shuttle.",
#:   "A motorbike had been leading us along at a modest pace. With a twitch of the bars it moved across to the left, its brake lamp came on, and it stayed there, engine ticking over, while the rider searched his jacket.",
#:   "V1 was following a bicyclist at approximately 10 mph. The bicyclist steered sharply to the left, then brought the bicycle to rest at the left portion of the lane, stating afterwards that he had seen a nail in the road.",
#:   "My claim is as follows. The moped before me was keeping right and I intended to go by it; instead it shot out leftwards and stopped on the spot, without turning off anywhere, so I had nowhere to put the car.",
#:   "Please build me this: one cyclist ahead of the AV, steady at first. Next he goes wide, to the left, quickly, and as soon as he's out there he brakes and stands still, closing the side where we'd overtake.",
#:   "On my ride home the woman cycling ahead must have spotted a friend over the road. She swept out to the left, no hand signal, clapped on the brakes and remained, one toe down, chatting, with a car waiting behind.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "stop"]
#: position = "ahead"
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 0.95
#: high = 1.3
#: unit = "m"
#: meaning = "how far it swings out to the left"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.8
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(3.5, 5.5)
param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_SWERVE = Range(0.95, 1.3)
param OPT_BRAKE = Range(0.4, 0.8)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for 1.2 seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE, globalParameters.OPT_SWERVE)
