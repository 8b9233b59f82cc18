#: description = "The oncoming car turns left across the ego's path at walking pace."
#: rephrasings = [
#:   "this guy opposite crawls through his left turn as if we weren't there",
#:   "Vehicle 2, travelling in the opposite direction, made a slow left turn across the lane of Vehicle 1.",
#:   "opposing left turn, very slow, our lane blocked for long",
#:   "The oncoming target turns left across the path of the VUT at not more than 14 km/h.",
#:   "A bus from the front turns left so slowly that the crossing is occupied long time.",
#:   "A cyclist coming the other way meanders left over our lane.",
#:   "The long lorry facing the ego needs ages to drag itself round to the left.",
#:   "Unhurried, it rolls leftward through the gap against the oncoming stream.",
#:   "He came from the other direction and crawled left through the junction right under my nose, slow as treacle.",
#:   "Opposing unit made a left turn at a very low rate of speed across the path of Unit 1.",
#:   "Oncoming bus, L turn at x-ing, snail pace.",
#:   "The opposing vehicle turns left across the path of the test vehicle at the junction at approximately 5 km/h.",
#:   "The car from the front turns left before me but so slow.",
#:   "LTAP/OD at crawl speed: conflict area is occupied for ages.",
#:   "It began its turn and then seemed to run out of will, inching across her way while she bore down on it.",
#:   "Lorry opposite is turning left over you and he's barely moving, he'll be in your way a good while.",
#:   "he turned left in front of me at the intersection soooo slow like grandpa pls",
#:   "A van from the opposite direction made its left turn so gradually that it was still in the way when the car arrived.",
#:   "The turn was to the left, across my client, and it was executed with no more speed than a stroll.",
#:   "Opposite lorry turning left at junction, but so slow like bullock cart, I have to brake.",
#:   "Turns left over me at the crossing as if he's towing a piano.",
#:   "Left turn of opposing vehicle at intersection with extended dwell in own path due to crawl speed",
#:   "LEFT TURN IN SLOW MOTION across my path",
#:   "The oncoming bus crawls leftward through the crossing before us.",
#:   "Bus facing us inches round to its left, right over our path.",
#:   "Oncoming lorry left-turns across us slower than a milk float.",
#:   "Let a cyclist from ahead dawdle through a left across the ego.",
#:   "Opposing cab, left turn over subject's path, walking pace throughout.",
#:   "He came towards us and turned left before us like a snail.",
#:   "It seemed to take the coach opposite a whole minute to lug itself leftward over our side of the crossroads, so gently did it go.",
#:   "The opposing target negotiates its left turn through the path of the vehicle under test at a creeping velocity, thereby occupying the conflict zone for a prolonged time.",
#:   "See that pickup opposite with the indicator going? He's cutting left over your lane now, and at that rate you could read a book till he's clear.",
#:   "The lady in the car in face has turned on her left in front of my capot, but at the step of a man, I waited long.",
#:   "My complaint is that he swung left over my lane from the other direction with so little speed that no one could have got by.",
#:   "I want an oncoming motorbike whose rider, feet almost down, potters through a left turn in front of the robotaxi and takes his time about it.",
#:   "We had the junction to ourselves but for an artic coming the other way. It began a turn to its left, which took it over our lane, and I have seen glaciers with more urgency. By the time its rear lights had cleared us the signal had changed twice.",
#:   "Vehicle 2 approached from the opposite direction and commenced a left turn through the path of Vehicle 1. Based on the video, its speed in the turn was 5 to 6 km/h and did not rise. Vehicle 1's driver had misjudged how long the crossing would stay obstructed.",
#:   "I don't drive so well in the dark myself, so I sympathise. The old gentleman opposite wanted to go left into Elm Grove, and he did go left, straight over where I was headed, only he crawled round as if there were eggs on the roof, and I had to stop for him.",
#:   "Why did we disengage? Oncoming car, left across path, constant crawl. Our gap logic extrapolates a typical turning speed of 20 km/h and concludes it'll be out of the way; in truth it's moving like a pedestrian and is still sideways in front when we get there. No stop, no hesitation, just very slow.",
#:   "As a bike courier you come to hate this one. There's a minibus coming at the car I'm behind, and it peels off leftward, over our lane, at the speed of a shopping trolley. It's in no trouble. It never halts. It's merely being driven round as slowly as an engine will bear.",
#:   "Coach opposite peels left across us at a stroll, taking an age.",
#:   "Have the facing scooter dribble through its left turn over our path.",
#:   "granny opposite doing her left turn in sloooow motion in front of me",
#:   "Coming the other way, a recovery truck took the left over our side of the crossing with all the haste of a cow going to be milked.",
#:   "At approximately 1.5 m/s the opposing target describes its left turn through the path of the subject vehicle, whose clearance time is thereby greatly prolonged.",
#:   "That cyclist from the front was turning to his left, through my way, but at such small velocity that a walking man could have passed him.",
#:   "He's opposite, he wants to go left, he's got to come over your lane to do it, and he's doing it at the speed of a hearse, so wait.",
#:   "Is it right that your minibus, approaching my client from the other direction, turned leftward across his lane without once going faster than a man walks?",
#:   "Sir, opposite side car is taking left turn cutting my path, but he's going so gently gently that signal became red and still he was in front.",
#:   "The pedestrians were overtaking it, that's no exaggeration. A blue van had come from the opposite direction and was on its way round to the left, into Cobden Road, over the bit of junction that we were about to use. A man with a pushchair on the crossing beat it to the corner.",
#:   "V2 was eastbound and initiated a left turn across the westbound lane in which V1 was travelling. There was no stop. V2's speed throughout the turn was between 3 and 4 mph, as a consequence of which V2's trailing half was still in the westbound lane when V1 got there.",
#:   "With two horses in the trailer you don't throw it about, I've been that driver. So when the jeep opposite began to come round to its left over my lane like a ship leaving harbour, I dropped to second, then to first, and admired the horses. First the one went past my bumper, after some time the other.",
#:   "We looked for the reason why ego enters the conflict area while it's occupied. Turn detected: yes, oncoming, to its left, our path crossed. Speed assumed: seven. Speed real: one and a half, from the first metre of the turn to the last. The actor hadn't cleared by the time we thought it would be long gone.",
#:   "I had time to read the entire side of it. \"Hopkins & Daughter, Fine Carpets, Est. 1911\", then a telephone number, then a mouse on a roll of lino. It had been facing us at the lights, and now it was passing across our bows from left to right, I mean turning to its own left, as slowly as a poster being pasted up.",
#:   "One's first thought was that the motorcycle had no petrol. It was coming at us from the far side of the crossroads and leant, if one can call it that, into a left turn which took it over our lane; one could count the spokes. Its rider waved to apologise for the tempo. He never hurried and never halted.",
#:   "Instructor's diary: we were nearly home when a tram-length bus facing us decided on a left. It's allowed to, only not at that pace! My pupil had judged the gap by the book, and the book hadn't met this driver, who let the thing inch round over our lane on tickover until the pupil was reciting prayers.",
#:   "Crikey, you get some patience on the pushbike. Old chap coming the other way, upright as a hatstand, one arm out, and he goes round to his left right through where the robotaxi means to go. He's barely keeping his balance, he's going that slow. Pedal, wait, pedal, wait. The robotaxi just stood there like a butler.",
#:   "For a second time that week she found herself, on the way to the station, in front of the same obstruction. From the opposite approach came the dairy's wagon, and it turned off to its left, that is over her road; but turned as the hands of clocks turn. Her train, she knew, was not so considerate.",
#:   "I sent off a letter to the bus company. One expects a left turn across the oncoming traffic to be made smartly. Yours was coming toward me and swung left at the pace of a funeral, never stopping, I grant you, and I and six others were kept from going straight on until it had dragged its last window out of our lane.",
#:   "Three of us in the car and not a word said for the whole thing. The hatchback over there has its left blinker on; it creeps off the line; it creeps over our lane. You can see the driver's nose on the glass. Its back bumper leaves our lane about the time my ice cream's melted.",
#:   "Coach opposite oozes leftward over our path, slow as treacle.",
#:   "Facing scooter's left turn, done at a grandmother's stroll.",
#:   "Cab from ahead going left across us, dead slow, whole length.",
#:   "You could've read the lorry's entire flank while it was passing before us, its driver having begun, from the opposite side, a left turn which he took at a mooch.",
#:   "An oncoming actor whose way leads left through ours; limit it to about a walker's rate in the turn so that it fills the conflict zone for ages.",
#:   "The wheels of the minibus that was swinging to its left in front of us, out of the contrary direction, turned so slowly that I counted the nuts.",
#:   "He faces you, he's pulling over to his left, and he'll be in your way till Christmas at that pace, so sit back and let him finish.",
#:   "Facing us was a cyclist with two crates, and when he bore away to his left over our lane he went at just the speed one needs not to tip over.",
#:   "From green to amber, that's how long it took the limousine opposite to haul its length, leftward, over the strip of tarmac on which we wanted to go.",
#:   "The light had let both sides go. What should've been a gap, once the bus from over there had got round on its left-hand curve, was for eight seconds bus: its headlamps first, next its door, then a poster, the whole poster, then its engine cover. A pensioner with a frame kept up with it along the crossing, and won.",
#:   "My wife's a midwife and she was on the way to work. She says don't exaggerate. I don't. The chap in the camper van, who'd come from the other end and wanted the street on his left, laid himself before our bumper as you lay a tablecloth, an inch at a time. Nobody would have been angry if he'd walked it, and he'd have been quicker.",
#:   "The occupancy timer of the conflict area has a typical value of two seconds for opposing vehicles that turn left. Run 40 shows eleven. The trajectory is correct, entry from the contrary approach, exit on its left; merely the speed, 1.4 m/s from the first metre to the last, isn't. The ego waited, tried to pass behind, then waited again.",
#:   "When the tall headlights of that artic left off shining into mine and began to shine along the shops, I knew: he's going left. So I waited for his tail lights. There was cab, then there was trailer, then there was, at the same funeral pace, more trailer. His tail lights arrived in front of me with the next phase.",
#:   "It may be that she was looking for a house number. I'd come to the junction as she came to it from the far side, in her little electric box. It bent to her left, into my lane, with no more haste than a cow through a gate. Nor did it find any once it was broadside on. I stopped, naturally.",
#:   "The foreman had told him: with the glass on board, no faster than a man can walk. And there we came from the contrary direction with a green light. So we were given the whole procession. A left turn, right across us, a man going alongside with his hand on the panes, and the man was not stretching his legs.",
#:   "You ask where I'd have put the brake. I'd have put it where you saw that her bonnet, over there, was pointing across our lane and yet didn't get anywhere. People suppose that a car which turns left before them will be gone on arrival. Hers was moving, but as a snail is moving. On our arrival it was all still there.",
#:   "With the tractor from the front we are having this each evening. He's coming, he's taking left side turn through our road, and his speed is equal to his bullocks' speed, which he sold. Full bus is watching him. One passenger got down, drank water, climbed up, and trolley was even then in front of our glass.",
#:   "I pedalled up on the inside of the stopped test car and said to the man, is it broken? No, he says, look. Ahead there was a motorbike and sidecar, come from opposite. It was executing the left-hander over our half with both of its rider's feet paddling on the ground. There was a dog in the sidecar, looking bored.",
#:   "V1's driver believed she had ample time. V2 was first seen in the opposite approach and then at an angle to it, bearing left across V1's lane, which it began to obstruct at 14:02:07 by the signal controller's clock. It was still obstructing it at 14:02:16. In those nine seconds it had covered about the length of two buses.",
#:   "Please make me a hearse. I mean the gait and not the vehicle, which can be a taxi. It stands in the other approach with its face to the ego, and then goes to its left through the ego's way with such dignity that anyone would run out of patience. No stopping in the middle, mind. It has to keep on, at that dignity.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "slow"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(0, 15)
param OPT_SLOW_SPEED = Range(2.5, 3.8)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
