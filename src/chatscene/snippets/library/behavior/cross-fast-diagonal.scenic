#: description = "The pedestrian sprints across the road on a slant."
#: rephrasings = [
#:   "He cuts the corner at a flat-out run, slanting away over the road in front of us.",
#:   "The pedestrian ran diagonally through the roadway at a high rate of speed.",
#:   "ped sprints diagonally over",
#:   "The target crosses obliquely at running speed, not perpendicular to the VUT's path.",
#:   "The person is running very fast over the street, but in an oblique way.",
#:   "A fare dodger pelts across at an angle with somebody after him.",
#:   "Late for the bus, she charges slantwise through traffic.",
#:   "The young runner takes the long diagonal over the tarmac at full tilt.",
#:   "This lad legged it over the road at an angle, taking the long way across instead of straight over.",
#:   "The male subject ran at full speed across the roadway in a diagonal direction.",
#:   "Ped sprinting, slantwise X-ing, kerb to kerb.",
#:   "The adult pedestrian target runs on an oblique trajectory, at an angle to the VUT's path, at sprint speed.",
#:   "A boy runs very fast over the street, not straight but crooked, like from corner to corner.",
#:   "Ped trajectory is oblique, not perpendicular, at 5+ m/s; predictor assumes a 90 degree crossing and fails.",
#:   "He was late for his bus and tore across cornerwise, making for a point far down the opposite pavement.",
#:   "Runner! He's cutting the road cornerways, full pelt, so he'll be in your path longer than you'd think.",
#:   "some guy sprinting corner to corner over the road like its a 100m final",
#:   "A young man raced over the carriageway on the bias, heading for a waiting bus.",
#:   "He did not go straight over, did he; he ran, at full pelt, on an oblique line to the far pavement?",
#:   "One boy ran very fast across, not straight also, slanting slanting to other side.",
#:   "Can't go the short way, this one, he has to gallop over cornerways in front of me.",
#:   "High-speed pedestrian crossing on oblique trajectory.",
#:   "GUY SPRINTS ACROSS ROAD DIAGONALLY, DOESN'T LOOK",
#:   "A runner slashed cornerwise across the street.",
#:   "Teenager bombing over the road slantways, hood up.",
#:   "Jogger at full speed cuts over the street obliquely.",
#:   "Have somebody race across at an angle, flat out.",
#:   "Lady legging it slantwise through traffic, lane to far corner.",
#:   "Subject fled over both lanes obliquely at top speed.",
#:   "A kid with a football under his arm came haring over, not the short way but aiming for the ice-cream van further along.",
#:   "The woman was running how you run from a dog, and she made a crooked line over the whole avenue in front of my car.",
#:   "V1's camera recorded the pedestrian traversing the lane at a dead run on a heading some forty-five degrees off perpendicular.",
#:   "Did you see that man shoot over the street on the cross, heels flying, as if the shortest way did not interest him?",
#:   "For scenario 12 the walker shall be replaced by a sprinter, whose track over the carriageway forms an acute angle with it.",
#:   "From the cab I saw him go like a hare, kerb to kerb, but skewed, so he was in front of me twice as long.",
#:   "It was pouring and a fellow with a newspaper over his head came belting over the road. He didn't take the straight way, he bore off toward the tube entrance down the street, so our two paths met for ages.",
#:   "Officer, she never looked. She flew off the pavement as fast as her legs would carry her and took the carriageway on the slant, heading for the tram shelter, and my car had to stop very hard.",
#:   "Now this one is nasty for the tracker. The pedestrian bolts, around six metres per second, and the line she takes over the road is angled along it, so the predicted exit point keeps sliding away from you.",
#:   "The boy is chased by his friends in the play. He runs very quick over the street and he goes like the line from one corner of a box to the other one, and the robot car must see him.",
#:   "From the saddle I watched a suited man launch himself over the road, tie over his shoulder. Rather than going square he slanted away up the street at a gallop, towards the closing doors of a bank.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "diagonal", "fast"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.5
#: high = 0.95
#: unit = "rad"
#: meaning = "how far its way turns from straight across"

param OPT_ADV_SPEED = Range(4, 7)
param OPT_ADV_DISTANCE = Range(6, 18)
param OPT_ADV_ANGLE = Range(0.5, 0.95)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
