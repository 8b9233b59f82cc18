#: description = "The oncoming pedestrian sways along the road toward the ego, now beside the lane, now in it."
#: rephrasings = [
#:   "A drunk comes tottering toward us, into the road and out of it.",
#:   "The intoxicated pedestrian approached Vehicle 1 on an unsteady, weaving path.",
#:   "oncoming ped, swaying, in and out",
#:   "The target approaches the VUT with an oscillating lateral position.",
#:   "A drunken man goes to us, sometimes left, sometimes right.",
#:   "Somebody facing the traffic wavers like a reed in the wind.",
#:   "A reveller heading our way reels between the verge and the tarmac.",
#:   "The walker who meets us cannot hold a straight course.",
#:   "Some drunk was tottering up the road towards me, one moment in the gutter, the next in my lane.",
#:   "An intoxicated pedestrian was observed staggering toward Unit 1, drifting in and out of the traffic lane.",
#:   "Ped facing traffic, staggering, in lane / out of lane / in.",
#:   "The pedestrian target approaches along the road edge, alternately entering and leaving the VUT's lane.",
#:   "Drunk man walks against me, sometimes on the side, sometimes in my lane.",
#:   "Lurching ped walking at us, lateral wander in and out of our lane boundary, never crosses fully.",
#:   "He reeled along to meet her, lurching into her lane, reeling out of it, and lurching back again.",
#:   "We've a caller about a man staggering along towards the traffic, in and out of the lane, can't walk straight.",
#:   "wasted dude stumbling down the road at us half in our lane half out",
#:   "A reveller lurched along the roadside into the face of traffic, straying into the lane and out again.",
#:   "The man coming toward you was unsteady, and he was by turns on the verge and on the carriageway?",
#:   "One drunken fellow was coming opposite, swinging here and there, sometimes inside my lane.",
#:   "Closing time, and here's one rolling up the road at me, in my lane, out my lane, hello ocifer.",
#:   "Unsteady oncoming pedestrian with repeated lane-edge encroachment.",
#:   "DRUNK MAN WALKS AT CAR, CAN'T STAY OFF THE ROAD",
#:   "An oncoming walker teetered over our lane edge and back, over and over.",
#:   "Drunk lurching up the road at us, over the line, back, over.",
#:   "Ped approaching unsteadily, in and out of ego's lane by turns.",
#:   "Have a tipsy man wobble toward the AV along the lane edge.",
#:   "He comes from front like a boat, sometimes road, sometimes grass.",
#:   "wavering joger facing us one moment on our tarmac next off it",
#:   "An old man whose legs would not obey him was making his way to meet us, tipping into our lane, righting himself, and tipping in again.",
#:   "The walker faces the VUT and advances along the edge line on a serpentine course, so that he is alternately outside and inside the lane.",
#:   "Why won't she keep to the side? She's tottering at you along the verge, then a yard into your lane, then the verge, then your lane.",
#:   "We met a girl with her shoes in her hand who was walking up against the traffic in big curves that led into our lane and out.",
#:   "He was drunk like a sailor, monsieur, he advanced in my direction and his line went onto my road, off my road, without to stop.",
#:   "Simulate somebody on foot who approaches the ego head-on along the road and can't hold a line, repeatedly drifting into the lane and away from it.",
#:   "The wedding had spilled out by then. One of the guests came toward my lorry along the gutter, tie round his head, and the road seemed to tilt under him: it tilted him in front of me, it tilted him back to the hedge, and then it started all over again.",
#:   "Witness states that she was driving home when a male appeared in her headlights, on foot and approaching. He was reeling, she says. For two or three steps he would be in her half of the road, the next two or three he'd be on the grass, and so it went on.",
#:   "Perception log, night run: pedestrian, opposing heading, walking speed. Lateral position relative to our lane edge oscillates with a period of around three seconds and crosses the edge each time. He never goes over to the other side. The predictor flips between \"will enter\" and \"will leave\" for the whole approach.",
#:   "I felt sorry for her, to be truthful. She walked to meet my car as if she were on the deck of a ship in a gale, now in among the parked bikes, now well out in front of me, and no amount of hooting could persuade her to choose one or the other.",
#:   "Council to act on \"stagger mile\": residents complain that after closing time people come rolling up Station Road into the face of the traffic. \"They swing out in front of you, swing in again, and out again, all the way towards you,\" said bus driver Amir, 52.",
#:   "Tipsy bridesmaid sways up the road at us, lane, verge, lane, verge.",
#:   "Have an old man reel toward the AV, crossing its lane edge repeatedly.",
#:   "bloke staggering at us, on the tarmac, off it, on it agen",
#:   "He came up the road to meet us with legs of string, and they led him out before our bonnet and back to the hedge, turn and turn about.",
#:   "The pedestrian approaches the VUT head-on along the lane boundary on an undulating line, such that the lane is entered and vacated in regular alternation.",
#:   "He is coming from the front full tight, madam, sometimes inside my lane, sometimes on the mud side, again inside, how I can pass him like this?",
#:   "Keep well over, because that chap walking towards you isn't steady: he's out in the lane, he's back by the wall, and there, he's out again.",
#:   "Isn't it a fact that, while making your way toward the lorry on foot, you tottered into its lane and out of it a number of times?",
#:   "Caller reports a female with one shoe, walking against the traffic on Dock Road, lurching out in front of cars and back to the side, over and over.",
#:   "I was driving the band home. There was a figure in the lamps with a traffic cone on its head, facing us and coming on. It'd take three steps toward the crown of the road, so we slowed, then three towards the ditch, so we didn't, and so on, until I just stopped and let it arrive.",
#:   "V1 was westbound on an unlit road. A pedestrian was walking eastbound, toward V1, near the edge line. His path was unsteady; the video shows him inside V1's lane, then on the shoulder, then inside the lane again, four times in nine seconds. A strong odor of alcohol was noted.",
#:   "The trouble with the approach phase is prediction. At each swing outward the walker, who is facing us and getting nearer, looks as though he's about to cross; at each swing inward he looks as though he has given up. He does neither. Treat the whole width he wanders over as occupied.",
#:   "Mum says the man had had too much lemonade. He walked at our car from the front and he couldn't do a straight line. First he was on the grass, and then he was on our bit, and then he fell nearly on the grass, and then our bit again, like when you've been on the roundabout.",
#:   "You learn to recognise them by their shadow. It comes swinging long and thin over your lane, pulls back to the parked cars, and comes over once more, and behind it is some poor devil from the Anchor, making his way up toward you with one hand on an imaginary rail. I ride round by the canal now.",
#:   "The gap between her and my wing was two metres, then none, then two, then none. All the time she was drawing nearer, and she was singing. I was at walking pace by then, in the coach, trying to guess on which beat of the song I'd get by; but the road and the gutter had an equal claim to her.",
#:   "My grandson filmed it, so nobody can say I made it up. Old Bert was coming home along Fore Street as we were going out. His stick went one way and Bert went the other, now off the pavement side and in front of me, now in again, like a pendulum on legs, and always on toward us.",
#:   "On my scooter behind the robotaxi I thought, why is it braking, braking, braking? Then I see him: a guy in a suit, approaching, with his tie over the shoulder. He drifts in where the robotaxi wants to go. He drifts out. He drifts in. It's like he's docking a boat.",
#:   "It's not in the manual, how to pass a man who's at sea on dry land. He was bearing down on the snowplough with his arms out. Each wave that only he could feel took him off the verge into the plough's lane, and each backwash returned him; so he came on, wave by wave, out of the dark.",
#:   "Party of one, eleven p.m., Harbour Street. I'm in the artic, dead slow. He's on foot and coming at me, and he's doing the slalom with one ski: into my lane by a yard, out of it by a yard, into it by a yard. Never goes over, never stays off. I switched off the engine and waited till he'd got past.",
#:   "I was sober since it was Ramadan, he was not. From the opposite direction he walks, near the edge of the street, and always he is falling a little to my side, so he's in my way, and falling a little to the other, so he's not in my way. I didn't know which one to believe.",
#:   "Man reels toward us, tarmac, gravel, tarmac, gravel.",
#:   "approaching drunk tacks like a dinghy, in lane, out, in, out",
#:   "Facing us, tottering nearer, half his steps in our lane.",
#:   "He drew nearer the way a drunk man reads, going off the line and coming back to it, and the line was the edge of our lane.",
#:   "With each swing the woman walking at the ambulance was in its path, with the next one she wasn't, and she'd still sixty swings to go until she was level.",
#:   "What I want you to notice is that he won't stay where he is now: coming at us, he's on the grass, but his next lean will bring him in again.",
#:   "Lateral position of the approaching dummy alternates about the lane boundary with a fixed period, while its longitudinal distance to the test vehicle diminishes steadily.",
#:   "Let a wedding guest come walking up the road at the AV in great curves that take him out on to the verge and over into its lane by turns.",
#:   "I'd start to go by, he'd wander in; I'd stop, he'd wander out; and all the time he's getting nearer with his bottle and his song.",
#:   "In the cone of the lamps his shirt was on for three seconds and off for three, on for three and off for three, like a lighthouse. When it was on, it was above our lane, and when it was off, he'd be among the cow parsley. And every time it came on it was larger. I had stopped by then, as one does for lighthouses.",
#:   "He had half a wardrobe on his back and no idea of his width. From the pub to the bridge he came along at us, bowed to the tarmac so that he saw nothing, and the weight walked him: three paces on to the roadway where we were, three off it, three on. I kept my hand on the horn and my foot where it needed to be.",
#:   "The trail in the snow is of great use to us. It runs opposite to the traffic and along its edge, and it's never straight: it bulges over into the lane, then over to the ditch, back into the lane, seven bulges in all. At the seventh, the prints stop beside the tracks of a car that was already standing. No one was hurt.",
#:   "There's no crossing intended, please, the dummy isn't going anywhere but up the road to meet us. Give it a sine. Its positive halves lie in our lane and the negative ones beside it. I've run it a dozen times, and each time the planner starts to pass during a negative half and has to bail out in the next positive.",
#:   "My daughter thought he was dancing. He did look as if he was leading someone, a step or two out here to where we were driving, a step or two back there to the hedge, out, back, and with every figure he'd come closer to our bonnet. I've seen my own father walk home that way, so I didn't laugh.",
#:   "He was my landlord, that was what made it awkward. He came along Mill Lane from the Swan as I was driving up to it, and he couldn't hold to the gutter to save his life. First you thought, he's past the worst, he's off the road. A second on and there he was, waving his cap right before my lamps, and off it again.",
#:   "The oncoming figure cannot be passed on either assumption. Assume it's in the lane, and by the time you've moved over it has gone to the verge; assume it's on the verge, and it is in the lane with its arms spread. Meanwhile the range is falling from both ends. The safe course, said the examiner, is to wait till it has swayed by.",
#:   "Madam, this gentleman had taken full bottle I think. He's coming opposite to my auto on foot. His one leg is saying road, his other leg is saying footpath, so he's listening to both: some steps inside my way, some steps outside my way, and again inside. I put first gear, I put horn, I put my faith in God.",
#:   "Stop press from Dock Road. A lad with his shirt undone is walking into the traffic stop. Not into one place stop. Sometimes he's with us on the road, sometimes he's against the wall, he never stays with either stop. All the while he's coming on stop. Driver of test car has put hazards on and is letting him come stop.",
#:   "When at last I had him beside my mirror he was, by luck, on one of his outward legs, and I got by. But it had cost me a minute. His whole approach, from the church on, had been done in scallops, each of which began on the pavement side, reached well over into my half, and ended at the pavement.",
#:   "It wasn't the gin, it was the wind, the old lady told us, and she a feather. It was blowing across the dyke in gusts. She had her face to our car and her hat in both hands, and each gust set her down in our lane, and each lull let her get back to the edge, and so she was delivered to us by instalments.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.8
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 34.0
#: high = 48.0
#: unit = "m"
#: meaning = "distance to the ego at which it sets off"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.6
#: high = 1.0
#: unit = "rad"
#: meaning = "how far each leg slants"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 1.2
#: high = 1.8
#: unit = "s"
#: meaning = "how long a leg takes"

param OPT_ADV_SPEED = Range(1.8, 3)
param OPT_ADV_DISTANCE = Range(34, 48)
param OPT_ADV_ANGLE = Range(0.6, 1)
param OPT_ADV_PERIOD = Range(1.2, 1.8)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(3, 1) until abs(offsetFrom(egoRoute, self)) < 2
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1 - globalParameters.OPT_ADV_ANGLE) for globalParameters.OPT_ADV_PERIOD seconds
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED, 2 * globalParameters.OPT_ADV_ANGLE) for globalParameters.OPT_ADV_PERIOD seconds
        do MoveAhead(globalParameters.OPT_ADV_SPEED, -2 * globalParameters.OPT_ADV_ANGLE) for globalParameters.OPT_ADV_PERIOD seconds
