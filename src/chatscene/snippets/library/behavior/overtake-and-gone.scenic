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
