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
#:   "Walks in, stops, digs his heels in, won't clear our lane.",
#:   "Elderly woman strolls to mid-lane, halts, and will not budge.",
#:   "Lane entered on foot, position taken, position never given up.",
#:   "He took himself off the pavement into my way, came to a stand, and met all my flashing and hooting with a smile and nothing else.",
#:   "Let a woman with a placard go on foot into the ego's lane and hold her place there for as long as the scene may last.",
#:   "There's a chap just ambled into lane one on the bridge, he's standing in the middle of it and he's told my crew he's not leaving.",
#:   "The man walks in my voie, he stops himself in front, crosses the arms, and from there nobody can take him away.",
#:   "Non-motorist stepped off the curb, walked to the center of V1's lane and stood there; he was still standing there when officers arrived.",
#:   "Wait as long as you please, Jodie, that fella walked there to be in your way, he's halted there, and he means to stay halted.",
#:   "The crew had asked for the street to be shut and it hadn't been. So their runner, a slip of a girl with a headset, took matters into her own hands: she went into the lane I was in, stopped at the centre, and put her palm up. I had a delivery slot. She had a director. She stood there till he was done.",
#:   "Twelve minutes and forty seconds the vehicle spent behind a stationary human being, the operator's log says. He'd come walking from the left with a folding chair under his arm. Once he was in our lane he didn't go on. He never even unfolded the chair; he stood beside it, and neither the horn nor the announcement could induce him to go.",
#:   "In our street it was always Mrs Malone against the lorries. You'd hear one change down at the corner, and out she'd march in her slippers to the middle of the lane, and there she'd come to rest with her arms folded. No driver ever got past her. They hooted, they begged; they all backed up in the end.",
#:   "Scenario notes. The pedestrian has no interest in the far side. She enters the lane at a walk; she ceases walking when the centre's been reached; and her third state, \"hold\", has no exit condition. Any solution that relies on her clearing the lane will time out. The vehicle may stop, may ask for help or may wait for ever.",
#:   "What were the options? I put it to you that there were none. To the left a wall, to the right oncoming buses, ahead the plaintiff, who had walked into my client's lane and had stationed himself in it. He was asked to move. He was sounded at. He remained, he said in terms, \"because I can\".",
#:   "I thought at first that he'd stopped for his shoelace. He had walked out quite peaceably from by the bins, got as far as my number plate's worth of road, and stopped. I gave him a minute. I gave him another. By the third I could see that the shoelaces were done up and he wasn't going to shift for me or anyone.",
#:   "The clip that everyone's sharing is dull if you don't know what to look for. A jogger slows to a walk, walks into the path of a robotaxi, halts. After that it could be a photograph, for the car doesn't move and neither does he. He wants to see who gives up first. At 9:58 the clip ends, undecided.",
#:   "Sheep you can push, I'd have pushed sheep. It was their shepherd who'd stepped down off the bank into the road, walked to where my wagon had to go and set his crook on the tarmac like a gatepost. His flock wasn't even there yet. He'd shift when they'd been by, he said, in half an hour, and not before.",
#:   "This matter occurred near to the station. One gentleman, fully drunk, came walking to my lane and stood like Gandhi statue. I said uncle please go. He said this is my road. Horn I gave, light I gave, ten rupees also I gave. He took the rupees but from the lane he did not go.",
#:   "I am a nun, so people expect patience of me. There was a girl with a telephone. She'd drifted from the pavement to a spot exactly before our little car, and there she'd stopped drifting. We prayed a decade. She was still at that spot, deaf to the horn. We prayed the other four, and she'd not stirred an inch.",
#:   "some kid figured out the self driving cars wont hit him. walks out casual af, gets to the middle of our lane, plants both feet, gets his phone out and starts filming US. car honks. he dabs. car flashes. he dabs. support came on the speaker and asked him nicely and he STILL wouldnt move",
#:   "Strolled into our lane, took root, deaf to every horn.",
#:   "Lady steps in, stands, folds arms, meeting's adjourned.",
#:   "Walked to the lane's middle; is still there.",
#:   "He didn't get out of the way when I flashed, nor when I hooted, nor when I begged, having walked there precisely to be in it.",
#:   "Let a protester come off the pavement at a walk, halt in the ego's lane, and stay on that spot however long the ego waits.",
#:   "Six times the lights changed for us, and six times we stayed, because of a man who'd ambled into our lane and wouldn't leave it.",
#:   "V1 was prevented from proceeding by a pedestrian who walked in front of it, came to a halt there, and declined requests to clear the lane.",
#:   "Would you please tell that gentleman that he can't walk up to a spot in my lane and live on it till Christmas?",
#:   "The old mother came walking, she reached my lane, and there she has fixed herself like a post, and I could honk until the battery was empty.",
#:   "Her shopping was melting, you could see it drip from the bag onto the road, always onto the same spot. There was a fair-sized puddle by the end. That's how long she had been standing in my lane with her chin up, after walking out there to have it out with the council about the buses, of which I drive one.",
#:   "I've had deer, sheep, a wardrobe. You drive at them a bit, they shift, bar the wardrobe. This was worse than the wardrobe. It had come out on its own two legs, no rush, right to where my wagon wanted to be; it put them a bit apart, the legs, and it looked at me, and the tea break came and went.",
#:   "After forty seconds the AV's nudge routine was started. It rolled forward by half a metre. A crosser at that point moves on; a daydreamer looks up and jumps. This one, who'd walked in quite purposefully from beside the hoarding, neither jumped nor moved on but put a hand on the hood. The nudge routine was cancelled. He was there at minute twelve.",
#:   "We came late to the wedding by an hour, which my mother-in-law will never forgive. In front of our car one farmer has walked onto the road, slowly, slowly. He didn't go to the other side. He put down his stick, he put down himself upon his two feet, and no horn, no folded hands and no hundred rupees could lift them.",
#:   "The boots are in the same place in every one of the seventy photographs, and the photographs were taken a minute apart. Only in the first do they have mud on the pavement behind them, a short trail, from walking out. They stand across the middle of the tracks of our lane, toes to us. The owner's face shows no interest in leaving.",
#:   "Sergeant, you're asking me where she went. That's what I'm ringing about, she hasn't gone. She walked in front of my cab at ten past, I stopped, she stopped. I've been nice and I've been rude. If you send somebody round you'll find me in the lane and you'll find her in front of me in it.",
#:   "No, you wouldn't go round him, Ellie, that's a solid line. You'd switch off. He's stepped down off the kerb there at a nice steady walk and got himself slap in the middle of us, and read his shirt, it says NO MORE CARS. What does that tell you about whether he'll shift? Quite. Have a sandwich.",
#:   "The figure is to be regarded as a permanent obstacle from the moment when, having entered the lane on foot at ordinary walking pace, it has attained the lane centre and ceased to walk. Sounding the horn, closing in or prolonged waiting shall not cause it to yield. Runs in which the ego awaits its departure time out.",
#:   "Patience is a bus driver's chief virtue and mine had been used up. \"Sir,\" I said through the window, \"you've walked into my lane.\" He agreed that he had. \"And you've been stood in it since.\" He agreed with that. \"And when might you be thinking of walking out of it?\" He said that he wasn't thinking of it.",
#:   "It wasn't a faint and it wasn't the phone, I looked at both possibilities. She'd come at an even stride over the grass, over the kerb, as far as the middle of the lane before my ambulance, and there the stride ended, as if at a counter. We had to back up and take the other road. In the mirror: still at her counter.",
#:   "like 3 million views and nothing happens lol. dude in a dressing gown walks out in front of a robotaxi. stops. robotaxi waits for him to finish crossing. he sips his coffee. robotaxi beeps. he sips his coffee. robotaxi inches. sip. its twenty minutes long and at the end hes got a chair. he never leaves that lane",
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
