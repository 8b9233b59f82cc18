#: description = "The car turns left across the ego's way without yielding."
#: rephrasings = [
#:   "A vehicle swings left through the junction in front of the ego.",
#:   "The adversary makes a left turn and takes the ego's priority.",
#:   "The other driver turns to the left, cutting the ego's path.",
#:   "A left-turning car crosses before the ego.",
#:   "The motorcyclist sweeps left over the crossroads ahead of the ego.",
#:   "he hangs a left right across us",
#:   "Vehicle 2 turned left and failed to yield the right of way.",
#:   "The target turns left across the path of the VUT at constant speed.",
#:   "He hung a left right across my bows without so much as a by-your-leave.",
#:   "Unit 2 failed to yield while making a left turn and crossed the path of Unit 1.",
#:   "Truck left turn at x-ing, no give way, cuts us off.",
#:   "The target vehicle executes a left turn across the path of the test vehicle, disregarding priority.",
#:   "The bus goes to the left before me, but I have priority.",
#:   "LTAP: actor ignores our right of way and turns left at normal speed.",
#:   "She had the right of way, but the cyclist simply leaned to the left and took it from her.",
#:   "He's going left, he hasn't looked, he's not going to give way to you, brake.",
#:   "she turned left right in front of me like i didnt exist, my turn btw",
#:   "A bus turned left through the path of a motorist who had the right to go first.",
#:   "You were bound to let my client pass; instead you took your left turn before him.",
#:   "He has taken the left turn across me, giving way is not in his dictionary.",
#:   "Lefty there reckons he owns the crossing, round he goes over my front, manners of a goat.",
#:   "Priority violation by left-turning vehicle across own path",
#:   "DIDN'T YIELD! Left turner cuts right across",
#:   "The cyclist turns left and snatches our priority.",
#:   "Priority was ours; the cab took its left regardless.",
#:   "Cyclist goes round to his left straight over our path, no yield.",
#:   "Let a lorry turn left through my way at the crossing.",
#:   "She should have waited, but she swung it left before us.",
#:   "Failure to give way by a motorbike making a left at the junction.",
#:   "At the crossroads the milk float, which ought to have let us pass, bore round to its left over our half of the road.",
#:   "The driver of V2 stated he believed he could make his left turn ahead of V1, and did not yield as required.",
#:   "In this test case the other vehicle doesn't grant the ego its right of way and at normal pace turns leftward through its path.",
#:   "Why is this bus making his left now, when it is my go, and passing his whole length before my eyes?",
#:   "That bike's signalled left and he's not waiting for anybody, he's sweeping round in front of you at the crossing, cover the brake.",
#:   "he had the give way sign i didnt and he still chucked a left across me, unbelievable some people",
#:   "I came up to the junction at my usual thirty. The gentleman in the estate car looked me in the eye and took his left-hander over my path all the same, neither fast nor slow, as if I had not been there.",
#:   "We had a scooter at the four-way that owed us the right of way. It curved off to the left in front of the shuttle anyway, at an ordinary speed and without a stop, and the shuttle braked at minus five.",
#:   "The crossing by the church is marked clearly and my road goes first. The camion did not respect this; he has turned to his left and cut my route, and me I had to brake very strongly.",
#:   "It was the bus driver's opinion that size decides who goes first. He hauled the great wheel round and took his passengers leftward through the junction, under the nose of a little blue car which had every right to be there.",
#:   "Think of the junction as a clock. The pickup comes in, peels off leftward and passes over our line before we get to the middle, although his was the road with the yield triangle; he simply presumed we'd brake.",
#:   "The left he took belonged to me; I had priority.",
#:   "Round to the left he goes, through my path, no by-your-leave.",
#:   "Lorry helps itself to a left turn across our right of way.",
#:   "Who taught that cyclist to peel off to the left through the junction with us bearing down on her and the priority ours?",
#:   "My path over the intersection was closed by the side of a coach whose driver had chosen to make his left before letting me by.",
#:   "A crossing moped is to make its left-hander right over the ego's lane, ignoring that the ego has precedence, at normal town speed.",
#:   "He must wait, it's written on the sign, but the van is bending to the left hand in front of me like the sign is for decoration.",
#:   "Unit two was given a ticket for failing to give way, as it came round leftward through the box in front of unit one, who had priority.",
#:   "Your Honour, the bus was broad on to me from one door to the other, curving away to the left, where it should've been standing and waiting.",
#:   "I'd a full load of gravel and forty tonnes doesn't stop on a sixpence. The lady with the stop sign knew I was coming, we looked at one another. Out she brings her little car all the same, bends it to the left right over my lane, and drives off down the valley as if nothing had happened.",
#:   "First his indicator, then his elbow, then his whole flank: that was how the post van unrolled itself before us, on its way round to the left. We'd been on the main road since breakfast, and there is a triangle on his street as tall as a man. None of that seemed to weigh with him.",
#:   "Why had the shuttle come to a halt? Nobody aboard knew, till a motorbike with a sidecar swam through the picture from one side, heeled over to its left, passed right over the shuttle's way through the junction and rode on. It was supposed to have waited for us, said the attendant.",
#:   "If the AV drives assertively it will hit him; if it drives timidly we'll never get through the junction. So here is what he does: his light's no different from ours, he's the one who must give way, and he takes his left turn over our lane at a steady twenty-five without the least regard.",
#:   "My nephew drew me a picture for the insurance. The thick arrow is me, going where I was entitled to go. The thin arrow is the grocer's boy on his bicycle, and it bends round to the left straight through the thick one, at the middle of the crossing. \"He did not give you your turn,\" the nephew wrote.",
#:   "You can have right of way and still end up in hospital, remember that. That minibus ought to hold back for you. Is he going to? Look at his front wheels: they're over to the left, he's rolling, there he goes, over your path and down Station Road. And you braked, well done, you live.",
#:   "V1 was northbound with no traffic control. V2, facing a yield sign, entered the intersection and described a left turn, its right side being exposed to V1's front throughout. The driver of V2 cited the sun. V1's automation applied full braking and the right rear door of V2 was grazed.",
#:   "It wasn't fast and it wasn't slow, it was simply rude. A silver people carrier emerged as though no other road met his; he gave his wheel a left turn, drew a handsome curve over the bit of junction that I needed, and showed me a sticker reading \"baby on board\". I'd the right of way. I had the hooter, too.",
#:   "On the recording you can hear me say \"after me, my friend\" in French, because he had to let me pass. The truck didn't know French. He went to his left hand, long as a train, and the junction was cut for me from the beginning of the cabin to the last wheel.",
#:   "People think we cyclists are saints. Well, I saw one of my own do it to a learner on Friday. She'd a dashed line to wait behind, he'd nothing; she stuck her left arm out like that settles it, and pedalled round to the left through his path, while the poor lad stalled it.",
#:   "She was already composing the letter of complaint. The driver of the number nine had seen her, had had every obligation to her, and had nonetheless brought his enormous vehicle about to the left, through the precise piece of the crossing over which she was about to travel. Her hat, she would mention, was ruined.",
#:   "Left he went, over my path, and priority be damned.",
#:   "A cyclist curled leftward across the way that was ours.",
#:   "Lorry's left-hander robs us of our turn, no yielding.",
#:   "It was our go, but the postwoman on her moped leaned into a left and passed over our half of the junction as if we'd waved her on.",
#:   "From the front I saw his lamps, then his door, then his tailgate: that's a left-hander, taken by a van which had to let me through first.",
#:   "At the junction the opposing party's bus shall come round to its left over the subject's path, at ordinary pace, although the subject has precedence.",
#:   "Had she honoured the give-way sign I should be in possession of a headlamp; she preferred to bring the estate about to the left, through my line.",
#:   "Ma'am, the scooter didn't stop for you, it drew its curve to the left across your lane and carried on toward the market, is that correct?",
#:   "Why the emergency stop, and nobody in red-light trouble? Because a truck with a yield sign before its nose took the left regardless, over our lane.",
#:   "I'd have bet my pension on him waiting. He had the triangle, he had the dashed line, and he'd looked at me for as long as it takes to say good morning. What I then got to see was the near side of his horsebox, all of it, from jockey wheel to tail lamp, as it rolled by in an arc towards the left-hand road.",
#:   "The shop camera is above the door, so you get it like a plan. Our taxi comes up the page. From the other road there's a pickup, and it doesn't cross the page, it bends; it leaves at the arm to its left. In between, its flank is precisely on the line we are about to use, and the right of way on that line is ours.",
#:   "We were four cyclists and a support car, with the main road, and a coach didn't think that this was enough. Its front went by, with the driver looking where he wanted to go, down to his left; its middle swept after it; its back end swung out to say goodbye. The support car's brakes were smoking, as the coach's never were.",
#:   "If you want to know who gives way, look at the signs; if you want to know who really does, look at the wheels. His were cocked to the left and going round, my dear, while yours had every right to. So what do we do? We let him have his corner, over our bit and out by the pub, and we live to moan about it.",
#:   "On the police sketch the constable gave me a straight arrow with a P on it, which stands for priority. The moped got a bent one. It begins at the side arm, goes up to my arrow, through it, and off by the left-hand exit toward the chip shop. \"And she never stopped at all?\" he said. Never so much as wobbled.",
#:   "Normal speed, normal radius, normal indicator. Nothing about that minibus would have upset anybody, except for the fact that it hadn't the right to be there. It should've been standing behind its line till our robotaxi was through. As it was, we'd its eleven side windows pass before us, one after the other, as it curved away to its left.",
#:   "The rose bowl was between my knees when my husband trod on it. Why? There was a boy on a bicycle. He was meant to wait, Harold says, there's a sign as big as a tea tray. Round he came regardless, one arm stuck out to his left, over our side of the crossing, and off down Chapel Row, and I'd water in my shoes.",
#:   "In Lyon the right comes first, here it's the wide road; I had learnt it by heart and so I was driving. The lady of the camionette hadn't learnt. She has made in front of me her beautiful curve, toward her left, her elbow on the window, and when I made the horn she thanked me.",
#:   "All the planner had to find out was whether the other would yield. The odds were ninety to ten, since he faced a stop sign. In the run he belongs to the ten. Without haste and without a halt he steers round leftwards through the junction, our path underneath him, and clears it in 3.8 seconds; we stop with two metres in hand.",
#:   "Because of the tractor's size, I suppose, nobody had ever asked it to wait, and this lorry from the same farm had the same upbringing. Out of the lane it came; round it went towards the mill, which lies to the left as he looks; and the doctor's car, on the road that goes first, was brought up on its springs.",
#:   "he doesnt stop. he doesnt look. its literally my right of way and this motorbike just swoops left thru the junction so close i can see my own face in his pipe. goes off down the left road like its nothing. im still shaking",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["acrossMeeting", "advMeeting", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-left"]
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -4.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(-4, 26)
param OPT_ADV_SPEED = Range(4, 10)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
