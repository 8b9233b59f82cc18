#: description = "The pedestrian crosses the road without stopping."
#: rephrasings = [
#:   "A person walks straight across the carriageway from one side to the other.",
#:   "The pedestrian goes over the street right in front of the ego.",
#:   "A jaywalker passes through the lane at an even pace and carries on.",
#:   "The cyclist rides across the lane of the ego and leaves it on the far side.",
#:   "The adversary traverses the roadway at right angles, never pausing.",
#:   "The motorcyclist shoots over the road ahead of the ego.",
#:   "A guy on a pushbike rolls over the road and off the other side.",
#:   "The pedestrian crossed the roadway in front of Vehicle 1 at a constant walking speed.",
#:   "Someone just strolled straight over the road in front of me without breaking stride.",
#:   "A pedestrian traversed the roadway at a steady walk and did not halt for oncoming traffic.",
#:   "Ped walks kerb-to-kerb, const spd, no stop.",
#:   "The cyclist target moves perpendicular to the VUT's path at constant velocity from one side to the other.",
#:   "A man on bicycle goes over the street, he does not wait.",
#:   "Plain crossing VRU: constant speed, no reaction to ego, no pause midway.",
#:   "She stepped off the kerb and went over to the far side at her own even pace, never once stopping.",
#:   "Lady coming over from the pavement, she's walking right across and she won't be stopping for you.",
#:   "lady just walked over like no cars exist",
#:   "Shopper stepped over the busy street without a pause, onlookers said.",
#:   "The man proceeded from one pavement to the other and at no point did he halt; do I have that right?",
#:   "Uncle just walk across steady steady, never stop also.",
#:   "Off he trots to the other side, doesn't hang about, doesn't wait for me neither.",
#:   "Uninterrupted pedestrian crossing movement in ego path.",
#:   "PEDESTRIAN WALKS OVER ROAD LIKE IT'S HIS LIVING ROOM",
#:   "A cyclist traversed the street ahead of us.",
#:   "Kid on a bike comes straight over the road, no stopping.",
#:   "He crosses, plain and simple, kerb to kerb in one go.",
#:   "Simulate a jogger who crosses our street without a break.",
#:   "Old gentleman made his way to the opposite pavement without halting once.",
#:   "Moped traverses the road before us and keeps right on rolling.",
#:   "A woman pushing a pram leaves the left-hand pavement, passes in front of the ego at a constant walk and reaches the right-hand one without interruption.",
#:   "As I was coming down Mill Lane a schoolboy walked out and went clean over to the other side, and he didn't slow or stop at any point.",
#:   "The dummy is propelled perpendicular to the lane from the nearside to the farside, maintaining its speed of 5 km/h throughout; no stop within the path of the VUT.",
#:   "I want somebody to step off the kerb and get to the opposite side in one uninterrupted movement, straight across, while our robotaxi is approaching.",
#:   "Die Frau, sorry, the lady, she goes from the right side to the left side of the street, always the same tempo, and does not stand still for us.",
#:   "Because he was wearing headphones, the student simply carried on to the other kerb at the pace at which he had started, cutting our path at a right angle.",
#:   "It was getting dark and the wipers were on. From between the market stalls a man in a grey coat set out for the opposite pavement; he walked neither fast nor slow, he didn't look up and he didn't pause until he was there.",
#:   "Pedestrian 1 entered the roadway mid-block from the west kerb. He continued due east on a line square to the street, his gait unchanged, and was clear of the far edge when V1 came to a halt. He told officers he never noticed the car.",
#:   "Funny thing, I've cycled across that road at the same place for twenty years. That day too I rolled off the cycle path, straight over in front of this self-driving thing, and up the dropped kerb opposite, no foot down, nothing. It coped all right.",
#:   "ok so small clip from the mornig commute, girl with a yellow umbrella comes off the kerb by the bakery walks straight over in front of me like its nothing, doesnt stop doesnt hurry and goes into the tube station oposite",
#:   "When the AV is thirty metres away, let a person begin to walk from one edge of the road to the other. The motion should be uniform and at right angles to the traffic, with no halt anywhere on the way, until the opposite edge has been reached.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 54.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary starts to move"

param OPT_ADV_SPEED = Range(1.5, 5)
param OPT_ADV_DISTANCE = Range(18, 54)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
