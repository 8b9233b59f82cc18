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
#:   "Coach just keeps rolling in lane at an unchanging 50.",
#:   "Let a lorry proceed down its lane, speed fixed.",
#:   "dull one hatchback sticks to its lane n pace throughout",
#:   "The moped neither sped up nor slowed nor wandered.",
#:   "Simple cruise, own lane, constant speedometer, that's the bus.",
#:   "All the cyclist does in this run is pedal along his lane with an even cadence, and there is nothing for our car to react to.",
#:   "Vehicle 2, a tractor-trailer, was occupying its lane normally and the recorder shows no change of speed in the thirty seconds before the event.",
#:   "I'd like a bit of ordinary traffic please: a pickup that holds whatever lane it has at the same velocity from start to finish.",
#:   "The lady in the Honda was driving as one should, officer, sticking to her lane, forty on the clock the whole time, no funny business whatsoever.",
#:   "Baseline trajectory for the surrounding vehicle: follow the lane centre with zero lateral offset and no acceleration until the end of the simulation.",
#:   "Notice how that motorbike is riding: tidy, in the middle of his lane, not speeding up, not backing off, and that's how I want you to ride too.",
#:   "There is really not much to tell. The other car, a grey estate, went along in its lane at what I'd call a normal speed and it was still doing so when I lost sight of it. It didn't brake, it didn't drift, it did nothing.",
#:   "For the control group we need an actor without any event. The bus runs along its lane, as given by the map, at a preset speed which it keeps to the last frame, and the ego gets no surprise from it.",
#:   "Cruise control set at fifty-six, elbow on the window, radio on. I stayed in my lane with the trailer dead straight behind me and never touched a pedal for eleven miles, and what that robot car was doing is its own affair.",
#:   "Grandad drives his old Mercedes like a tram. He goes in his lane and he goes at one speed, and he doesn't hurry up and he doesn't slow down, even when people wave at him, and I like it because I don't feel sick.",
#:   "The truck was travelling with regular speed in the lane where it belongs. I have observed it well because nothing was happening: always straight following of the road, always same tempo, no manoeuvre of any kind until we arrived there.",
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
