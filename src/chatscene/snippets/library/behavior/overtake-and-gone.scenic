#: description = "The car overtakes the ego at high speed and keeps going in its lane."
#: rephrasings = [
#:   "Something screams past us in the next lane and is gone.",
#:   "Vehicle 2 passed vehicle 1 at a speed far above that of traffic and continued.",
#:   "Fast pass, no lane change.",
#:   "The target overtakes the VUT with high relative velocity in the adjacent lane.",
#:   "He passes near us as a rocket and doesn't care.",
#:   "A lorry thunders by in the other lane, way over the limit.",
#:   "The sports bike streaks past our mirror.",
#:   "A speeder shoots up from the rear, draws level and vanishes up the road.",
#:   "A hot hatch tore past me in the next lane like I was parked and that was the last I saw of it.",
#:   "Unit 2 passed Unit 1 at a high rate of speed and continued straight ahead in its own lane.",
#:   "Moto blasts by in adj lane, stays in it, gone.",
#:   "The target passes the VUT at high relative velocity, with no lane change before or after the pass.",
#:   "The car goes by me very fast in the next lane and just goes on.",
#:   "Fast pass only, no cut-in: actor blows by one lane over and disappears ahead.",
#:   "There was a howl at her window and he was by, dwindling up the road in the same lane he'd come in.",
#:   "He's just flying by on the outside, he isn't coming in on you, let him go.",
#:   "some dude flew past in the next lane and just kept going, never seen him again",
#:   "A motorcycle streaked by the column of cars and was out of sight within moments.",
#:   "It went by my client in its own lane at great speed and simply continued; it never came before her?",
#:   "One bike went past me like jet, straight in his lane, gone already.",
#:   "Whoosh, past my window, in his own lane to be fair, and over the hill before I'd blinked.",
#:   "High-speed passing in adjacent lane without lane change.",
#:   "CAR PASSES ME AT WARP SPEED",
#:   "A sports car vapourised past in its own lane.",
#:   "Vroom, past our window, and already just a dot up the road",
#:   "Superbike blasts by on the outside, holds its lane, vanishes.",
#:   "Put a speeding saloon past the ego, staying in its lane throughout.",
#:   "Something low and yellow whistled past, its own lane, and never lifted.",
#:   "Unit passed by sports car, excessive speed, continued on in lane two.",
#:   "motorbike came from behind like an arrow, level with me for a blink, then only its tail light getting tiny in the other lane lol",
#:   "The faster target moves by the VUT in the adjoining lane with a large speed surplus and carries straight on without changing lanes.",
#:   "He must have been doing double my speed when he went by on my flank, and he kept that up in the same lane until the bend swallowed him.",
#:   "V2 overtook V1 in the adjacent lane at high velocity, made no movement toward V1's lane either during or after the pass, and left the area.",
#:   "That one belongs to the let-him-go category: he's rocketing past you in the other lane, he's not interested in your bit of road, wave him goodbye.",
#:   "Yesterday one car has overtaken me like a bullet in the side lane and he just went straight, straight, straight till I could not see him.",
#:   "We felt it before we saw it, a thump of air against the doors. Then a grey coupé was beside the robotaxi, then it was in front but still one lane over, and then it wasn't anywhere at all, it had simply outrun the camera.",
#:   "I would like to see whether our planner stays calm. From the rear, in the neighbouring lane, a motorbike approaches with a huge surplus of speed, sweeps past the AV and carries straight on in that lane, with no cut-in and no braking.",
#:   "Nothing actually happened, as I explained to the nice young policeman. I was pootling along when a car tore by me at some ungodly speed in the lane next to mine, and it kept to that lane and kept up that speed until it was over the brow.",
#:   "From up in the lorry you get a good view of lunacy. The hot hatch came howling up from behind, went by the little blue car as if that was nailed to the ground, and stayed flat out in its own lane all the way to the horizon.",
#:   "The engine note rose, hung for an instant beside her ear and fell away. By the time she had turned her head the rider had passed, bent low over the tank, dead straight down his lane, growing small with absurd rapidity.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "fast"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 20.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 13.0
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it overtakes"

param OPT_ADV_DISTANCE = Range(20, 42)
param OPT_ADV_SPEED = Range(13, 17)

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, 1, 0, globalParameters.OPT_ADV_SPEED)
