#: description = "The oncoming pedestrian steps into the ego's lane, pauses there in doubt and then goes on across."
#: rephrasings = [
#:   "Someone coming our way cuts over, dithers in our lane, then carries on to the far side.",
#:   "A pedestrian walking against traffic entered the lane, paused, and then completed the crossing.",
#:   "oncoming ped crosses, hesitates mid-lane, continues",
#:   "The approaching target interrupts its crossing within the VUT's lane.",
#:   "The person comes to us, goes in the lane, waits a little and goes further over.",
#:   "A walker who meets us halts before our bumper unsure which way to jump.",
#:   "The old lady heading toward us wavers in the road before she makes it over.",
#:   "Midway to the other pavement, the passer-by facing us stops and thinks.",
#:   "A chap walking towards me strolled out into my lane, stood there umming and ahhing, then went over.",
#:   "Pedestrian, who was walking facing traffic, entered the lane, paused, and then continued to the opposite side.",
#:   "Ped facing us, steps in, unsure, waits, then crosses.",
#:   "The pedestrian target, approaching in the opposite direction, enters the lane, dwells there briefly and then completes the crossing.",
#:   "A woman comes against me on foot, goes in my lane, thinks, then goes to other side.",
#:   "Walker heading towards us steps off the edge, single dwell in lane, continues across.",
#:   "He had been coming up the road to meet her when he stepped in her way, seemed to wonder what he was about, and then passed over.",
#:   "Jogger's coming toward you, he's in your lane, he can't decide, let him, right, he's gone over.",
#:   "guy walking towards me stepped into my lane, stood there like idk, then crossed",
#:   "A man on foot coming the other way entered the lane, lingered uncertainly and then made for the far side.",
#:   "He was walking to meet my client's car; he came into its lane, tarried in doubt, and passed over.",
#:   "Facing me one lady was coming walking, came into road, stood thinking, and afterwards crossed.",
#:   "Walks up towards me, wanders out, stops for a ponder in my lane and then ambles over.",
#:   "Lane entry of facing pedestrian with irresolute dwell and subsequent completion of crossing",
#:   "MAN WALKS AT ME, STOPS TO THINK, THEN CROSSES",
#:   "The walker coming our way enters the lane, dithers and goes over.",
#:   "Walker meeting us turns in, stands there undecided, then completes his crossing.",
#:   "Facing pedestrian crosses our lane with one baffled stop midway.",
#:   "Old man heading our way: into lane, stuck wondering, then over.",
#:   "Toward us, into our lane, a doubtful halt, and finally across.",
#:   "Let a jogger who's approaching us enter our lane, dither, finish crossing.",
#:   "A woman who had been walking down the road in our direction set foot in our lane, came to a halt as if she'd forgotten something, then finished her crossing.",
#:   "The dummy moves opposite to the VUT's direction of travel, enters its lane laterally, is at rest there for two seconds and resumes until the lane is cleared.",
#:   "The schoolboy was on his way towards me when he swung into my lane, stuck there not knowing whether to run or stay, and afterwards got himself to the other side.",
#:   "Please have somebody walk along the road against our travel, step in front of the ego, stand there unsure for a moment and proceed to the far kerb.",
#:   "One uncle come from front, walk into my lane, stop there blur blur, think finish already then go across.",
#:   "Watch the postman coming to meet you: he's off the kerb, he's stopped in your lane, doesn't know if you've seen him, okay, on he goes to the other side.",
#:   "I was driving up the lane and he was walking down it, so we could see one another perfectly well. All the same he stepped out in front of me, came to a stop with his stick in the air, and after some thought he continued over to the far verge.",
#:   "Pedestrian 1 was walking south, facing northbound V1. He veered into the northbound lane, ceased walking for an estimated three seconds, looking alternately at V1 and at the far curb, and thereupon resumed and reached that curb.",
#:   "Her face was towards us the whole time, which is why I remember it. She came on, turned into our lane, and there all her resolve seemed to leave her; she stood, bit her lip, looked at the opposite gate, and only then walked through to it.",
#:   "Bug report: VRU approaching head-on along the shoulder, heading changes to crossing, velocity drops to zero inside ego lane for 2.1 s. Tracker then decides it is static. VRU goes on toward the far side and our car has already begun to roll. Please reproduce.",
#:   "I was out with the dog, going along against the cars as you're meant to. I went in the road to get over to the stile, and there's this car with nobody in it, so I stopped right in its way, not sure of it, and then I went on over.",
#:   "Walker coming at us enters our lane, wavers there, then gets across.",
#:   "Facing me, then before me, standing in two minds, then over.",
#:   "Let an oncoming hiker cut into our lane, stop unsure, continue across.",
#:   "A postman walking up the road to meet us turned into our lane, stood for a moment as though he'd lost the thread, and then walked on over.",
#:   "Counter-directional pedestrian: lateral entry to the VUT's lane, dwell at rest on its path for the stop time, then completion of the crossing at original speed.",
#:   "He came towards us on the edge of the road, he stepped in, he was not sure any more and stood, and after a little he finished to cross.",
#:   "The woman with the pram, who'd been facing us, swung into our lane, baulked halfway over it and, having made her mind up, pushed on to the other side.",
#:   "Wants to come over, the old boy that's walking towards you; he's in your lane, he's stuck, give him a second, and now he's off to the far side.",
#:   "On his way down towards the car the boy veered in front of it, halted with one foot lifted, evidently in doubt, and then trotted on over to his friends.",
#:   "The scarf was what I steered by. It grew as he and I neared each other; it went from the side of the road to the middle of my lane, and there it hung, for two seconds or three, while its owner looked from my headlamps to the far hedge. In the end it went to the hedge.",
#:   "We were told that she hadn't slept. She was walking against the traffic, that is towards us, and she turned into our lane like someone opening a door to the wrong room. She stood in it. One could see her ask herself whether to go back, and then she went forward, and out of it at the other side.",
#:   "Pedestrian 1 was northbound on the shoulder and V1 southbound. At approximately forty feet, Pedestrian 1 moved laterally into the southbound lane and ceased moving, by his account because he was \"not sure the thing had seen me.\" He remained there about two seconds and then completed his crossing to the opposite shoulder.",
#:   "Question for the group. Say a person has been coming along the roadside towards your car and now walks out in your lane and stops, clearly dithering. Do you go? Ours did go, an inch, and then he made his mind up and carried on over to the far pavement, and it had to brake a second time.",
#:   "Lollipop ladies aren't what they were. Ours was plodding up the hill in my direction with her stick under her arm, and into my lane she turned. There she had to have a think, should she put the stick up or not, and I sat waiting for the verdict; then over she plodded to the school gate.",
#:   "Three seconds of film, run it slowly. Frame one, a man is walking towards the lens at the road's edge. Frame thirty, he's square in our lane. Frames thirty to seventy, he is rooted to it and only his head moves. Frame seventy-one, he takes a step, the right one thank God, and finishes his crossing.",
#:   "For a heartbeat he was nobody's: not of the near side, which he had left, and not of the far one. All along the avenue he had been coming on towards the carriage, swinging his cane, and now that he'd turned into its path he did not know, it seemed, if he wanted to. Then he did know, and passed over.",
#:   "Add an actor to the country road map. She walks on the right in the opposite direction to the robotaxi. Just ahead of it she turns and enters its lane, where she is to come to a standstill out of uncertainty. As soon as the pause has elapsed she takes up walking again and clears the lane on the far side.",
#:   "My mobile was ringing, and so I'm afraid I did it without looking. I had been walking home with the cars coming towards me, and I had started over. Then I saw one, and I couldn't think, I simply stuck there in its lane. When it had nearly stopped I went on to my side of the street.",
#:   "Arre, one aunty was walking opposite to us, coming and coming. Suddenly she has cut into our lane, in front of the cab, and there she is standing, one hand on the head, \"should I go, should I not go.\" Cabbie said namaste to her. Then she went, to that side, and he could drive.",
#:   "Victor Five, the missing gentleman's found, he's on foot on the mill road coming towards my vehicle. He has now wandered into my lane and he's stopped, he seems confused. I'm stationary. Wait one. He's walking again, he has gone across to the north side of the road, I'm getting out to him.",
#:   "Facing us, then in our way, then undecided, then over.",
#:   "A jogger meets us, turns across, gets cold feet, finishes anyway.",
#:   "Have the woman coming our way falter in our lane, then complete.",
#:   "Face to face we were, he and I, when he came off the verge before me, planted himself there scratching his ear, and at last went on to the other verge.",
#:   "A walker headed our way was all at once ahead of our bumper, neither coming nor going, until she made her mind up for the far side.",
#:   "The pedestrian target, initially opposed to the VUT's heading, enters its lane, is at rest there for the dwell time, and thereafter leaves by the far edge.",
#:   "I know the look of someone who has forgotten whether the stove's off, and he wore it, standing in my lane, having come up the road to meet me; then over he went.",
#:   "What the boy walking towards us was after was the other pavement, and he got to it, but only after he'd stood in our lane like a lost parcel.",
#:   "Her nerve gave out in front of our bonnet and came back a bit later, so the old lady who'd been coming down the hill at us did get across.",
#:   "The hat, the beard and the buttons had all been growing nicely, as they do when a man is walking up the road to you. Then I'd his ear. He had turned, and was in my lane, and the ear stayed where it was, first one ear and then the other. Finally the hat went off towards the duck pond.",
#:   "I'd put it down as a very short friendship. He came along the verge, in the opposite sense to me, and we nodded. He stepped in front of the car; he stopped; I stopped. His eyebrows asked me something. I think my eyebrows must have said yes, for he started up again and got to the far ditch.",
#:   "The robotaxi inched, and that's what has caused the complaint. It had given way to a lady who had been walking towards it on the shoulder and was by then standing in its lane, hand to her mouth. When she had shown for two seconds no wish to be elsewhere it inched; when it inched she completed her way over the road.",
#:   "You'd think someone who is looking straight at you would know what you're going to do. This chap is. He's been looking at us all the way up the hill. He's in our lane now, and what's he doing? Standing, one foot in front of the other. Does he want to go back? No. There he goes, over to the bus stop.",
#:   "Distance walked along the road by VRU 2: minus eleven metres, that is, towards us. Distance walked laterally: 1.9 m, which brought it to the middle of our lane, then none at all for 2.6 seconds, and then a further 4.1 m to the opposite edge. Our yield logic was fine till the \"none at all.\"",
#:   "At the inquest her brother explained that she'd always been afraid of the road's middle. She was on her way home, so with the traffic in her face. She would get as far as the lane, she would think about it there, rooted, and once she had thought she'd go on. The hearse, he noted bitterly, had waited as well.",
#:   "It's the pause that I'd have you look at, ladies and gentlemen. A postman is coming to meet the camera car. He cuts in front. At this point every one of us predicted either \"carries on\" or \"jumps back.\" Instead he has an attack of doubt, in our lane, letter in hand; and only afterwards he carries on, to number 9.",
#:   "My torch must have dazzled him, or his lamps me. I had it pointing down the lane, at the car, as one should when one walks towards it. I'd meant to be over before it came. In its lane I thought \"no,\" and stood there with the torch on my boots, and then I thought \"yes,\" and was over.",
#:   "So we're creeping up this street in the truck, right, and there's a girl coming the other way on foot, texting. She drifts off the pavement and she's in front of us. And she looks up. And she just stands, like a save game's loading. And it's loaded, she's off, she goes the rest of the way, other pavement. End of story.",
#:   "Monsieur the sacristan approached on the border, in our direction face to face. I esteemed that he'd stay there. But he has entered in my lane with his candles; and there, what to do, to the front, to the back? He had planted himself. After a small prayer, I suppose, it was to the front, and he has terminated his crossing.",
#:   "Something had been bothering the hiker, one could tell by the map. It was in front of his face all the while he came up the road to where we were coming down it. It was in front of his face when he turned into our lane. There he lowered it, looked at us without hope, raised it, lowered it, and at length walked on over.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "cross", "hesitate"]
#: position = "oncoming"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 4.6
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 22.0
#: high = 36.0
#: unit = "m"
#: meaning = "distance to the ego at which it steps in"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 1.6
#: unit = "m"
#: meaning = "how far from the ego's line it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.4
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_SPEED = Range(3, 4.6)
param OPT_ADV_DISTANCE = Range(22, 36)
param OPT_STOP_DISTANCE = Range(0.2, 1.6)
param OPT_STOP_TIME = Range(0.4, 1.4)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.4) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
