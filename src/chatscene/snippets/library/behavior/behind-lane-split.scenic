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
#:   "Moped forces its way past us without leaving our lane, then stamps on the brake.",
#:   "Overtaken inside my own lane by a Vespa that promptly slowed up ahead.",
#:   "Biker brakes under our bumper right after wedging himself between us and the dashes.",
#:   "Zwischen-durch motorbike: same lane as me, past me, brake light in my face.",
#:   "Have a motorcycle share our lane to get by, slot in ahead, decelerate.",
#:   "I want a scene where a motorbike comes up from behind, slips through the narrow strip left in the ego's own lane, settles in front of it and hits the brake.",
#:   "According to the claimant, a motorcyclist rode alongside within the same marked lane, drew in ahead of the insured vehicle and abruptly reduced his speed.",
#:   "Ticket 4471: PTW tracked at 0.4 m lateral distance while going by in our lane, then centred itself before us and decelerated at 5 m/s²; planner reacted late.",
#:   "Never trust the gap at your side, because that's where a bike will come through, line up in front of your bonnet and suddenly knock his speed off.",
#:   "Mummy, the motorbike went by so close I could have touched him, in the same lane as us, and then he went in front and braked!",
#:   "In the reconstruction the two-wheeler gains on the AV, passes it with less than half a metre of clearance inside the lane, moves to the middle ahead and slows hard.",
#:   "I was in the queue on the ring road, doing perhaps forty, when a big touring bike came up behind. Instead of going round he forced himself between my door and the lane marking, pulled in before me and grabbed his front brake. My wife screamed.",
#:   "Dash cam, 17:42. You can hear the engine on the left before you see anything. The rider never touches the other lane, he just squeezes up along our flank, noses in ahead of the bumper and then his brake light is on and we're nearly in his panniers.",
#:   "The motorcycle had been following the robotaxi for some time. Without a lane change it wormed its way alongside, gained the space in front and there scrubbed off most of its speed, which left the robotaxi no choice but an emergency stop.",
#:   "With forty tonnes I don't see much down the side. First thing I knew, this dispatch rider was coming up between me and the kerb, in my lane mind you, then he popped across my front and braked. I stood on everything I had.",
#:   "Simulate a lane-splitter, please. Our car keeps to its lane at city speed; the motorcycle approaches from the rear, uses the leftover width of that very lane to get by, shifts back to the centre in front of us and applies its brakes sharply.",
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
