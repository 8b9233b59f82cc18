#: description = "The pedestrian walks into the ego's lane, plants itself there and refuses to move."
#: rephrasings = [
#:   "Some guy ambles out in front of us and just stands there like a post.",
#:   "The non-motorist walked into the travel lane and remained standing in it.",
#:   "ped strolls into lane, stays put, blocks us",
#:   "The pedestrian target moves to the centre of the VUT's lane and remains stationary.",
#:   "A protester wanders onto the carriageway at leisure and takes root in the middle of it.",
#:   "The man goes on the street and stays standing in our way, he does not go away.",
#:   "A woman glued to her phone drifts off the kerb and comes to stand squarely in the lane.",
#:   "Someone calmly walks to the centre of our lane and bars the road with their body.",
#:   "A bloke wandered into my lane, folded his arms and wouldn't shift.",
#:   "The subject walked into the traffic lane, stood there and refused to leave.",
#:   "Protester walks into lane, stands ground, won't budge.",
#:   "The pedestrian target walks into the VUT's lane, comes to rest and stays stationary for the rest of the test.",
#:   "A man walks in my lane, stands there and does not want to go away.",
#:   "Ped as permanent blocker: walks in, stops for good, never clears our lane.",
#:   "She marched out before him, set her feet and stood her ground, and no hooting would move her.",
#:   "We've got a man standing in the traffic lane, walked out there and he's having none of it, won't clear the road.",
#:   "this dude walked in front of us n just stood there, wouldnt move at all",
#:   "An activist took up a position in the traffic lane and declined to leave it.",
#:   "He walked into your lane and there he stood, and no amount of sounding the horn shifted him?",
#:   "One fellow walked to my lane and stood there only, horning also he never move.",
#:   "Strides out, plonks himself in front of me and that's that, you'd need a crane to move him.",
#:   "Deliberate standing obstruction of ego lane by pedestrian.",
#:   "MAN STANDS IN FRONT OF CAR AND REFUSES TO MOVE",
#:   "A protester anchored himself in our lane.",
#:   "Jogger trots in, halts before us, won't be shifted.",
#:   "Woman enters our lane on foot and holds it like a sentry.",
#:   "Target pedestrian: walks in, stops, remains for duration of test.",
#:   "The man walked in front of our car and wouldn't ever go away.",
#:   "How do you get past somebody who's walked in and won't leave?",
#:   "I want a man who steps off the kerb, goes to the middle of the ego's lane, stands there and stays, come what may.",
#:   "She had taken up residence in my lane, having walked to it quite calmly, and neither lights nor horn persuaded her to give it up.",
#:   "The pedestrian proceeded on foot into V1's lane, ceased moving, and remained there for the entire time that V1 was waiting, ignoring verbal requests.",
#:   "A señora walks to the middle of my lane and there she nails herself, I make pi-pi-pi, she doesn't go neither back nor forward.",
#:   "Control, the demonstrators' leader has walked into the nearside lane, he's come to a stop there, and he says he's staying till the press arrive.",
#:   "It's no use hooting, he walked there, he stopped there on purpose, and that's where he intends to be when you've gone home.",
#:   "In twenty years on the buses I've had drunks and geese and a piano. Never had this. A young woman strolls into my lane, turns to face me, puts down her handbag, and that's it. She's stopping. I switched the engine off in the end.",
#:   "Once the pedestrian target has walked from the roadside into the centre of the subject vehicle's lane and has come to rest, it shall not be moved again. The subject vehicle is required to stand before it, or to find a way around, but never to expect clearance.",
#:   "The driverless taxi did all that could be asked of it: it slowed for the teenager who was walking into its lane, and when he stood still it waited. Then it waited some more. He knew perfectly well it couldn't run him over, so he simply stayed put.",
#:   "Police were called when a farmer, angry about the bypass, walked out in front of a motorist and took his stand in the middle of her lane. He had been asked several times to move, a spokesman said, and had each time replied that he was comfortable.",
#:   "Grandad's dementia was bad by then. He'd wandered from the garden into the road, right to where the lorry had to go, and come to a halt, staring up at it. And he stayed standing there however nicely the driver begged him, like a tree that had grown overnight.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "stop", "block"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.1
#: high = 1.8
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 30.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 1.25
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(1.1, 1.8)
param OPT_ADV_DISTANCE = Range(30, 48)
param OPT_STOP_DISTANCE = Range(0.2, 1.25)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
