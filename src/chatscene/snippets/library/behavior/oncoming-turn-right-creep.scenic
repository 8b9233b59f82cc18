#: description = "The oncoming car turns right into the road the ego is taking and crawls along."
#: rephrasings = [
#:   "the one opposite turns right into our street and then just dawdles there",
#:   "Vehicle 2, oncoming, turned right into the same street as Vehicle 1 and proceeded slowly.",
#:   "opposing right turn into same road, very slow",
#:   "The oncoming target turns right into the destination lane of the VUT at low speed.",
#:   "The bus from the other side turns to right in the street where also we go, and drives slow.",
#:   "A lorry facing us rounds the corner to its right at a crawl.",
#:   "Both want the same road, and the van that comes from ahead takes it first, inching round.",
#:   "Coming the other way, it bears right with no haste at all and stays ahead of the ego.",
#:   "The one facing me turned into the same road I was taking and then dawdled along it.",
#:   "Opposing vehicle made a right turn into the street Unit 1 was entering and continued at a very low speed.",
#:   "Oncoming truck turns R into our exit arm, then crawls ahead.",
#:   "The opposing vehicle turns right into the exit road of the test vehicle and proceeds at walking speed.",
#:   "The bus from the other side turns right in the street where I go, and it drives so slow.",
#:   "Opp. actor's right turn merges into our exit lane at creep speed; we end up stuck behind it.",
#:   "She had meant to go down that lane, but it slipped in from across the way and then ambled along before her.",
#:   "That fellow opposite's going right, into the same street as you, and he's not in any hurry once he's in.",
#:   "the car opposite turned into the same street as me and now its crawling n im stuck behind it",
#:   "A car from the opposite approach turned right into the same street and ambled along it ahead of the other.",
#:   "He took, from the contrary direction, the very street my client was taking, and dawdled there.",
#:   "Opposite side lorry turn right to same road I going, then drive like sightseeing.",
#:   "Coming from over the way, he ducks into my turning first and then has the nerve to dawdle.",
#:   "Occupation of own exit road by slow right-turning opposing vehicle",
#:   "STEALS MY STREET then drives at walking pace",
#:   "The bus opposite bears right into our exit and plods.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-right", "slow"]
#: position = "oncoming"
#: maneuver = "left-turn"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -5.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(-5, 15)
param OPT_SLOW_SPEED = Range(2.5, 3.8)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
