#: description = "The motorcycle squeezes past the ego inside its lane and brakes in front of it."
#: rephrasings = [
#:   "A biker filters past our mirror, swings in ahead and brakes.",
#:   "The motorcycle split the lane, passed vehicle 1 and slowed in its path.",
#:   "PTW lane-splits by us, cuts back, brakes.",
#:   "The powered two-wheeler overtakes the VUT within the lane and decelerates ahead.",
#:   "The moto passes between us and the line, comes before us and brakes.",
#:   "A scooter threads by our door with inches to spare and chops its throttle.",
#:   "A courier on two wheels squirms through beside us and anchors.",
#:   "The rider shaves our flank, tucks in and jabs the lever.",
#:   "Some lad on a scooter threaded himself between me and the kerb, popped out under my nose and slammed his anchors on.",
#:   "Operator of motorcycle #2 passed Unit 1 on the left without leaving the lane, then decelerated sharply directly ahead of Unit 1.",
#:   "MC from rear, filters thru in our own lane, brake-checks us.",
#:   "A powered two-wheeler approaching from the rear shares the lane of the vehicle under test while passing, then applies its brakes ahead of it.",
#:   "Motorbike comes from back, goes by very near me in same lane, and after it he brakes.",
#:   "Repro: biker lane-splits past us from the rear (never leaves our lane), merges to centre and hits the brakes.",
#:   "He had been in her mirror a second ago; now he scraped past her door with an inch to spare and his brake light flared right in front of her.",
#:   "Watch that rider behind, he's going to filter up through your lane, and there, he's past your mirror and he's braking on you.",
#:   "bro this moped literally went thru the gap next to my door n then stopped short on me lol",
#:   "A motorcyclist slipped by the car without ever changing lanes and then pulled up sharply in front of it, witnesses said.",
#:   "Your Honour, the rider shared my client's lane as he went by, and no sooner was he ahead than he shut off his speed.",
#:   "This bike fellow came from back, adjusted himself between me and the divider, then simply put brake in front only.",
#:   "Them delivery riders, they shave your mirror going through and then have the cheek to slow down on you.",
#:   "In-lane passing by powered two-wheeler from the rear with subsequent deceleration ahead of own vehicle",
#:   "BIKER FILTERS PAST AND INSTANTLY REGRETS NOTHING - brake check!",
#:   "The motorcycle wriggles by inside our lane and clamps down ahead.",
#: ]
#: adversaries = ["motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "swerve", "brake"]
#: leader = false
#: position = "behind"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.65
#: high = 2.1
#: unit = "m"
#: meaning = "how far beside the ego's line it passes"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 1.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_SWERVE = Range(1.65, 2.1)
param OPT_ADV_AHEAD = Range(1, 5)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do DrivePath(advTrajectory, 11, globalParameters.OPT_SWERVE) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do SwerveOnPath(advTrajectory, 8, 0) until abs(offsetFrom(advTrajectory, self)) < 0.8
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 1
    do DrivePath(advTrajectory, 4)
