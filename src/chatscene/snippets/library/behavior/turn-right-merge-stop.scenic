#: description = "The car turns right into the ego's lane and brakes to a stop."
#: rephrasings = [
#:   "he whips round the corner in front of us and stands on the brakes",
#:   "Vehicle 2 turned right into the lane of Vehicle 1, braked hard, and stopped.",
#:   "right turn into our lane, then hard brake, standstill",
#:   "The target turns right into the lane of the VUT and then decelerates to standstill.",
#:   "The bus turns to the right in our lane and immediately it brakes until it stands.",
#:   "A taxi rounds the corner rightward and pulls up sharp.",
#:   "The biker hooks right ahead of the ego, then jams on the anchors.",
#:   "Having come out of the side street to its right, the lorry stops dead in our way.",
#:   "he came out right into my lane from the side road and then pulled up dead in it",
#:   "V2 turned right into V1's lane and braked to a complete stop ahead of it.",
#:   "Bus: R turn into our lane, brk, standstill.",
#:   "The target turns right into the VUT's lane and decelerates to standstill directly ahead of it.",
#:   "The truck turns right in my lane and then he brakes and stays standing before me.",
#:   "Right-turn merge followed by a stop: NPC aligns with the ego lane after the corner, then v=0.",
#:   "The motorcycle had come round the corner to the right to join them on their road, and hardly straight, it braked and stood.",
#:   "He's swung out right, he's in your lane now, and he's stopping! What did he come out for if he's only going to stop?",
#:   "he turned right into our lane then just braked and stopped, like why",
#:   "A lorry rounded the corner to the right, took the lane and at once pulled up",
#:   "You came round to the right into my client's lane and, once in it, braked until you stood?",
#:   "Bus turn right come into our lane, never drive on, straight away brake and stop",
#:   "Comes round the corner, right into my lane, and then drops it on a sixpence",
#:   "Right turn into own lane with subsequent hard braking to standstill",
#:   "Biker turns right into my lane and STOPS DEAD",
#:   "The pickup rounded rightward into our lane and clamped up.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-right", "brake", "stop"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 2.0
#: high = 3.5
#: unit = "s"
#: meaning = "how long it drives in the ego's lane before it brakes"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_TIME = Range(2, 3.5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_STOP_TIME seconds
    do BrakeOnPath(egoRoute)
