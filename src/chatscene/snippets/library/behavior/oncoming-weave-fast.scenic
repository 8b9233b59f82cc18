#: description = "The oncoming car comes at high speed, weaving from side to side."
#: rephrasings = [
#:   "he's flying towards us and snaking all over the road",
#:   "Vehicle 2 approached at high speed on an erratic course.",
#:   "opposing veh, fast, swaying left-right",
#:   "The oncoming target travels at 43 km/h or more on a sinuous path about its lane.",
#:   "A motorcycle comes with big speed making zigzag.",
#:   "A biker barrels along with a violent tank-slapper.",
#:   "A speeding hatchback fishtails toward us.",
#:   "Far too quick and out of control, it sways this way and that as it comes.",
#:   "Some headcase came the other way flat out, snaking all over the place.",
#:   "Opposing vehicle approached at a high rate of speed, swaying from edge to edge.",
#:   "Bike oncoming, v. fast, zigzag.",
#:   "The opposing vehicle approaches at elevated speed with sinusoidal lateral oscillation.",
#:   "The car from the front is very fast and goes left right left right.",
#:   "Opp. traffic: high v plus slalom around its own lane, unlike the slow weaver that sits in ours.",
#:   "It tore down upon them, slithering from side to side like something hunted.",
#:   "Fast one coming at you, he can't hold a line at that speed, he's fishtailing.",
#:   "some maniac flew towards me swerving side to side at like 100",
#:   "A car hurtled toward oncoming traffic, swinging from left to right as it came.",
#:   "It approached at a breakneck rate, your Honour, and never for two seconds on the same line.",
#:   "Opposite bike coming zig-zag in full speed, like video game.",
#:   "Coming at me flat to the boards and wagging like a dog's tail.",
#:   "High-speed approach of opposing vehicle with alternating lateral deviations",
#:   "ONCOMING LUNATIC SLALOMS AT FULL SPEED",
#:   "The oncoming motorcycle slithers toward us at tremendous speed.",
#:   "Hatchback hurtling at us, tail swinging like a pendulum.",
#:   "Opposing bike: way over the limit and all over the shop.",
#:   "Send a speeding oncoming saloon whose path wobbles left, right, left, right.",
#:   "omg here he comes doing like a hundred swerving side to side",
#:   "Oncoming motorcycle at great velocity, never on a straight line.",
#:   "The sports car approaching us was going far beyond the limit and couldn't be kept straight, lurching to the verge, then to the middle, then to the verge again.",
#:   "Opposing target: speed not less than 60 km/h, lateral motion periodic with 0.8 m amplitude about the lane centre for the whole approach to the VUT.",
#:   "I want an oncoming motorbike to charge in our direction at full tilt while it sways from one edge of its lane to the other and back.",
#:   "Claimant noticed the third party from afar because it was approaching much too quickly and rolling this way and that like a ship in heavy seas.",
#:   "Control, be advised, stolen Astra heading towards you on the old road at high speed, he's all over his carriageway, left and right, drunk by the looks of it.",
#:   "Una moto came from the front as a rocket, and with this velocity it was also dancing from one side to the other side.",
#:   "What frightened me wasn't only the speed, although he must have been doing ninety. It was that the car would not run true. It leaned over to the left, then over to the right, then left again, and all the while it was getting bigger in my windscreen.",
#:   "According to three residents, Vehicle 2 came down the grade toward Vehicle 1 at an estimated seventy miles per hour in a thirty-five zone. Its rear end was swinging to alternate sides, and the tire marks on its side of the road form a long S.",
#:   "Have a look at this one. Country lane, I'm pootling along, and out of the distance comes a lad on a superbike giving it everything, and the whole bike is swaying, left, right, left, right, handlebars flapping, and he shoots past me like that.",
#:   "Grandpa pulled right up to the hedge because he'd seen the big silver car in front coming so terribly fast. It was wiggling too, first to the grass and then to the white line and then to the grass, and the wind of it shook us when it passed.",
#:   "For the paper we recreated the worst class of opposing traffic, that is, an actor which couples excessive approach speed with a continuous side-to-side oscillation of its path, so that neither its time of arrival nor its lateral position can be trusted by the ego.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave", "fast"]
#: place = "road"
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 2.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swings"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.0
#: high = 4.0
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(12, 15)
param OPT_ADV_AMPLITUDE = Range(2, 3)
param OPT_ADV_PERIOD = Range(3, 4)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
