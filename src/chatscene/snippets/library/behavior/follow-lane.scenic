#: description = "The car drives along its lane at a steady speed."
#: rephrasings = [
#:   "A vehicle keeps to its lane and its pace.",
#:   "The adversary simply goes on straight ahead.",
#:   "The car follows the road without changing anything.",
#:   "The driver cruises on, neither faster nor slower.",
#:   "The truck stays in lane at constant speed.",
#:   "He just tootles along in his lane, nothing special.",
#:   "Vehicle 2 proceeded in its lane at a constant speed.",
#:   "Target: constant velocity, no lateral motion.",
#:   "Nothing fancy, there was just a car pootling along in its lane minding its own business.",
#:   "Vehicle 2 was traveling within its lane at a constant speed, no evasive or unusual maneuver noted.",
#:   "Bus in own lane, const v, no manoeuvre.",
#:   "The target maintains lane position and constant velocity throughout the test.",
#:   "A car goes normal in his lane, always the same speed.",
#:   "Background actor only: lane keep, cruise at set speed, no events.",
#:   "It rolled on down its lane, neither faster nor slower, as though it had all the time in the world.",
#:   "That lorry's just cruising along, holding his lane nice and even, nothing to worry about.",
#:   "literally just a car driving in its lane nothing happened",
#:   "The bus travelled along its lane at an even pace, according to passengers.",
#:   "And the lorry, so far as you saw, simply kept to its lane and its speed?",
#:   "He was going in his own lane nicely only, same speed, no problem.",
#:   "Bloke in his lane, steady as a clock. Makes a change, I tell you.",
#:   "Lane-keeping traffic participant at uniform speed.",
#:   "JUST A CYCLIST RIDING IN ITS LANE AT A NORMAL PACE",
#:   "The motorcycle hummed along its lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: leader = false
#: actions = ["follow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(4, 9)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
