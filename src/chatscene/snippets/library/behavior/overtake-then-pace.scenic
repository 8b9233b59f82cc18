#: description = "The car comes up from behind, overtakes and then eases off to hang beside the ego's front."
#: rephrasings = [
#:   "He passes us halfway out and then just hovers off our front wing.",
#:   "Vehicle 2 overtook vehicle 1, reduced its speed and travelled alongside its front.",
#:   "Passes, then matches speed just ahead in next lane.",
#:   "The target overtakes the VUT and then keeps station abreast of its front end.",
#:   "He goes before us and then waits near, always the same speed.",
#:   "The truck creeps past and then can't or won't get clear.",
#:   "A biker rolls by and lingers diagonally ahead, looking at us.",
#:   "Having gone by, the coach loses interest and loiters alongside.",
#:   "He caught me up, nosed ahead, then backed off the gas and just hovered by my front wing.",
#:   "Unit 2 approached from the rear, passed, then reduced speed and remained abreast of Unit 1's front fender.",
#:   "Moto passes, eases, hangs at our front corner.",
#:   "The target vehicle overtakes and thereafter reduces its speed to remain adjacent to the front of the test vehicle.",
#:   "The car comes from behind, goes past, then is slower and stays next to my front.",
#:   "Overtaker drops to ego speed once at our front corner and sits there, blocking a lane change.",
#:   "It came up from the rear and edged ahead, and there it lingered at her headlamp as though keeping her company.",
#:   "Police unit is coming by you, he's eased off now and he's riding by your front wheel.",
#:   "he sped up past me then slowed down to sit right by my headlight, creepy af",
#:   "After going by, the car slackened off and kept station at the other's front corner.",
#:   "You drew past, and rather than proceed, you abated your speed so as to remain off my client's bow.",
#:   "This car overtook half and then reduced speed, just staying near my front door side.",
#:   "Goes by me and then can't be bothered, just loiters off my front corner like a pilot fish.",
#:   "Station-keeping of overtaking vehicle beside own front after speed reduction",
#:   "OVERTAKES, THEN REFUSES TO LEAVE - lurks by my bonnet",
#:   "The motorcycle edges past and then loiters at our front flank.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: place = "road"
#: actions = ["overtake", "pace"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 5.6
#: high = 7.6
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"

param OPT_ADV_SPEED = Range(12, 15)
param OPT_ADV_AHEAD = Range(5.6, 7.6)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, globalParameters.OPT_ADV_SPEED, 5)
