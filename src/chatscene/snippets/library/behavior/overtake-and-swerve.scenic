#: description = "The car overtakes the ego and swerves at it while passing."
#: rephrasings = [
#:   "As he comes past he jerks the wheel at us.",
#:   "While passing, vehicle 2 veered toward vehicle 1 and then straightened.",
#:   "Overtakes with lateral lunge into our lane.",
#:   "During overtaking the target makes an abrupt lateral excursion into the VUT's lane.",
#:   "When he passes he comes to our side and goes away again.",
#:   "A lorry going by gets caught by the wind and lurches over us.",
#:   "The motorcyclist kicks out and weaves at our mirror on his way by.",
#:   "Drawing past, the driver reaches for something and wobbles into our space.",
#:   "As he came by me he gave the wheel a tug and had a go at my wing.",
#:   "While passing, Unit 2 swerved in the direction of Unit 1.",
#:   "Bike overtakes, jerks at us halfway past.",
#:   "During the overtaking phase the target vehicle makes a sudden lateral excursion towards the test vehicle.",
#:   "The car passes me from behind and when it is beside, it steers to me.",
#:   "Overtaker with lateral jab at us mid-pass, doesn't stay level first and doesn't brake.",
#:   "He drew up on her, and in the very act of going by he flung the machine at her door.",
#:   "One coming round you now, watch him, he's swinging in at you while he's still alongside.",
#:   "guy was passing me and mid pass he jerked at my car on purpose",
#:   "While going by, the motorcyclist made a lunge sideways at the car.",
#:   "In the very act of passing, the defendant directed his wheel toward my client.",
#:   "While overtaking that bike suddenly dashed towards my side, almost touched.",
#:   "Halfway past me he has a little lunge at my front wing, charming.",
#:   "Lateral incursion by overtaking vehicle during the passing phase",
#:   "SWINGS AT ME WHILE OVERTAKING",
#:   "The passing car feints at us midway.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "swerve"]
#: maneuver = "straight"
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.0
#: high = 13.0
#: unit = "m/s"
#: meaning = "how fast it overtakes"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -2.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.6
#: high = 2.5
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE_TIME"
#: low = 1.0
#: high = 1.6
#: unit = "s"
#: meaning = "for how long it swerves"

param OPT_ADV_SPEED = Range(11, 13)
param OPT_ADV_AHEAD = Range(-2, 3)
param OPT_SWERVE = Range(1.6, 2.5)
param OPT_SWERVE_TIME = Range(1, 1.6)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do SwerveOnPath(advLane, globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED)
