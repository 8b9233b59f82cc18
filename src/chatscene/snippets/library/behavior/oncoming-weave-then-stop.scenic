#: description = "The oncoming car weaves from side to side and then stops."
#: rephrasings = [
#:   "he's wobbling about over there and then he just stops",
#:   "Vehicle 2 approached on a weaving course and came to rest.",
#:   "opposing veh, zigzag, then halt",
#:   "The oncoming target follows a sinuous path and then brakes to standstill.",
#:   "The truck goes left and right, left and right, and finally it stands.",
#:   "A tipsy cyclist wavers toward us and comes to a stop.",
#:   "The lorry opposite snakes along until it grinds to a halt.",
#:   "After slaloming a while, a biker facing us pulls up.",
#:   "the car coming the other way was wobbling left and right like he'd had a few, and then he just pulled up",
#:   "The oncoming vehicle swayed repeatedly from side to side before coming to a stop.",
#:   "Opp. bicycle: snaking, then halts.",
#:   "The oncoming target oscillates laterally and finally comes to standstill.",
#:   "The truck from front goes left-right, left-right, and at the end stands.",
#:   "Opposite actor: sinusoid in lateral offset, amplitude a lane or so, then v=0.",
#:   "The motorcyclist had come reeling towards them, now this side, now that, until he gave it up and stood still.",
#:   "Bus coming at you's all over the shop, swinging one way then the other... and now he's come to a halt, thank God.",
#:   "car coming at us was swerving all over then just stopped",
#:   "An approaching lorry veered from one side to the other before coming to a stand",
#:   "You were observed to wander left and right on your approach, and then to stop altogether?",
#:   "Opposite fellow driving like snake, left right left right, then stop there just like that",
#:   "He's coming at me all over the shop, can't hold a line, and then he just parks up",
#:   "Laterally unstable opposing traffic with final standstill",
#:   "Oncoming cyclist swerves everywhere then STOPS",
#:   "The van facing us lolled from side to side and stalled out.",
#:   "Opposing scooter meanders left, right, left, and draws to a halt.",
#:   "Oncoming pickup slaloms over its lane, then stationary.",
#:   "Car opposite, it dances right and left, at last it stays standing.",
#:   "Give me an oncoming bus that sways about and then pulls up.",
#:   "Zigzagging towards us, then not moving at all: a cyclist.",
#:   "A hatchback coming the other way drew a wavy line down the street, over and back, over and back, and ended it by stopping.",
#:   "Whoever was driving that coach towards us couldn't keep it straight; it yawed to one side and the other for seconds and eventually braked to a rest.",
#:   "The opposing vehicle's lateral position alternated about its lane centre with a period of some two seconds before the vehicle decelerated to standstill.",
#:   "My headlights picked out a motorbike coming against me with its lamp swinging like a lantern, left, right, until it hung there quite still.",
#:   "Witnesses describe an artic that approached the robotaxi in serpentines down the hill and, having done so several times, was finally brought to a stop.",
#:   "It had come to rest facing us after snaking towards us for a hundred yards, now at the kerb, now at the white line.",
#:   "He came towards us on his bicycle with a crate of beer on the handlebars, so you can imagine. The front wheel went this way and the back wheel that way, and so it went on all down the lane, till he gave up and stopped.",
#:   "Vehicle 2 was northbound, facing Vehicle 1. For approximately four seconds prior to stopping it moved alternately left and right within and beyond its lane in a repeated pattern. Its driver, who was later found to be diabetic, then applied the brake and Vehicle 2 stopped.",
#:   "In this test the facing target is made to follow a sine-shaped path of given amplitude and period. When the programmed interval is over, the lateral motion ends and the target is braked gently to zero, remaining in front of the vehicle under test on its own route.",
#:   "I can tell a sleepy trucker when I meet one, having been one. That rig ahead was coming at me like washing in the wind, drifting one way, correcting, drifting the other. I flashed him and flashed him, and at long last he stood it still.",
#:   "You know those toy cars whose wheels are bent? The car that was coming to meet our school bus drove just like one, first to us and then to the hedge and to us again. Then it wasn't driving anymore, it had stopped, and a lady got out.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave", "stop"]
#: place = "road"
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.3
#: high = 2.2
#: unit = "m"
#: meaning = "how far it swings"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 2.5
#: high = 3.5
#: unit = "s"
#: meaning = "how long a full swing takes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 4.0
#: high = 6.0
#: unit = "s"
#: meaning = "how long it weaves before it stops"

param OPT_ADV_SPEED = Range(5, 8)
param OPT_ADV_AMPLITUDE = Range(1.3, 2.2)
param OPT_ADV_PERIOD = Range(2.5, 3.5)
param OPT_STOP_TIME = Range(4, 6)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(advTrajectory, 0.7, 1.5)
