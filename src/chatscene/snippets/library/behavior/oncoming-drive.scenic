#: description = "The oncoming car keeps coming along its lane."
#: rephrasings = [
#:   "A vehicle approaches from ahead and does not give way.",
#:   "The adversary drives toward the ego at a constant speed.",
#:   "Opposing traffic comes on steadily.",
#:   "The cyclist rides toward the ego and holds the line.",
#:   "The other driver, facing the ego, carries straight on.",
#:   "he just keeps on coming",
#:   "Vehicle 2 was travelling in the opposite direction at constant speed.",
#:   "The oncoming target drives at constant speed in the adjacent lane.",
#:   "The other car just carried on towards me in its own lane, nothing out of the ordinary.",
#:   "Unit 2 was proceeding in the opposite direction within its lane at a normal speed.",
#:   "Oncoming bus, steady, holds lane.",
#:   "The opposing vehicle continues in its own lane at constant speed without deviation.",
#:   "From the front comes a truck, it stays on its side and drives normal.",
#:   "Plain opposing traffic: lane keeping, no manoeuvre, just doesn't give way.",
#:   "It neither slowed nor swerved; it simply came on down its own side of the road.",
#:   "There's a cyclist coming the other way, he's on his side and he's staying there, so wait for him.",
#:   "theres a car coming the other way, just normal, nothing weird",
#:   "Traffic came from the opposite direction and kept to its proper side.",
#:   "The opposing vehicle held its lane and its pace, and did nothing to which anyone could object.",
#:   "Opposite side one bus is coming in its own lane, simply normal driving.",
#:   "Something coming the other way, keeping to his own side for once, no bother.",
#:   "Regular opposing traffic in its own lane, no deviation",
#:   "Oncoming car does... absolutely nothing wrong",
#:   "The oncoming lorry plods along its own lane.",
#:   "A lorry approaches from the front, keeping to its side.",
#:   "Oncoming moped stays its course and passes as expected.",
#:   "Opposite-direction cyclist, constant pace, own lane throughout.",
#:   "just put a bus coming the other way nothing fancy",
#:   "Facing us, a car drives down its own lane undisturbed.",
#:   "The van coming towards you isn't going to do anything clever; he is staying on his half of the road at the speed he's got.",
#:   "V2 was westbound in the westbound lane, approaching V1 at an unchanging speed, and made no steering or braking input before the two met.",
#:   "Can I get some simple opposing traffic, say a motorbike that comes from the far end and rides down its own lane without any change?",
#:   "I had to wait for him, naturally, since he was coming from the opposite side in his proper lane and had no intention of slowing down.",
#:   "The bicycle which was coming in the contrary direction has continued on its way, on its part of the road, always with the same speed.",
#:   "The opposing target travels in its designated lane toward the VUT with constant velocity and zero lateral deviation during the entire test run.",
#:   "The other motor car was simply coming towards us on the left-hand side, as motor cars do. It didn't hurry and it didn't dawdle, and so far as I could see the gentleman at the wheel never moved his hands. It just kept on.",
#:   "We need a baseline with oncoming traffic that does nothing surprising. A coach comes the other way, stays between its lane lines, holds its speed and does not yield to anybody, and the vehicle under test has to fit its own plans around it.",
#:   "I'm not saying the bus did anything wrong. He was on his side, I was on mine, he came along at thirty or so towards me the whole time and he carried straight on. I only mention it because I couldn't have gone out in front of it.",
#:   "In the clip you can see the headlights of a truck coming down the opposite carriageway from way back. It sits square in its lane and its speed never varies. It's the sort of vehicle you have to let by before you can do anything yourself.",
#:   "When you look up the road, what's there? A lady on a bicycle, coming this way, on the other side, pedalling evenly. She has no reason to stop for you and she won't, so treat her as something that will keep right on coming.",
#:   "Opposing Skoda, own side, unvarying, gives way to nobody.",
#:   "A bus ahead, coming our way, sticking to its half, nothing more.",
#:   "Here comes a moped from the front, steady as a clock.",
#:   "On the far half of the road a lorry was heading our way, and it neither hurried nor hung back nor drifted.",
#:   "Adversary: opposite heading, centred in its proper lane, speed held from spawn to despawn, no reaction to the ego of any kind.",
#:   "What was the other driver doing when you first saw him? Approaching in his lane, sir, and he went on approaching in it.",
#:   "Put in a coach that approaches us down its own lane and minds its own business until it has gone by.",
#:   "From opposite side one scooter was there, correct side, same speed, it was coming and coming, no problem with it, but I had to let it pass.",
#:   "There's a bicycle bound this way along the other lane, it'll keep up its twelve miles an hour whatever we decide to do.",
#:   "I was waiting behind a skip and hoping for a friendly soul. The blue van wasn't one, though I can't fault him. He'd right of way, he was where he should be across the white line, and he drove on toward us at the same pace until the skip was shaking in his wake.",
#:   "The number on his front, the dead flies on his headlamp, the postcard behind his windscreen: all of it came up slowly and evenly, as when you turn the ring on a camera lens. The lorry had its half of the road, I had mine. He never lifted and never pressed.",
#:   "The control run is deliberately dull. A passenger car starts at the far end of the road, faces the vehicle under test, and proceeds along its designated lane with speed and lateral position both constant. It will not brake to oblige anybody. Any conflict arises solely from what the VUT itself does.",
#:   "Do look up, dear. There's a motorbike on its way to us on the other side. It isn't racing, it isn't dithering, and it isn't going to let you through, because why should it? It'll be here in about six seconds and past in about seven, and then it's our turn.",
#:   "Relative speed of the approaching object: 22 metres per second, and 22 again a second later, and so on to the last frame. Relative offset: three and a half metres to the left, likewise unchanging. In other words a bus in the opposite lane, behaving like a bus, and we braked for it.",
#:   "Everybody wants to know about the other cyclist and there's nothing to tell. She was riding towards the car from the opposite end, in her own lane, at a pace you could have set a watch by. She had her eyes open and hands on the bars. She just kept pedalling.",
#:   "Nobody could have called it a challenge, yet he felt it as one. The grey saloon had appeared at the end of the avenue, on its own side, and it was drawing on towards him without haste. It didn't waver. He saw that if either of them were to yield, it would have to be he.",
#:   "On our road there's only room if somebody stops. A fellow in a tipper was headed my way in his lane, and going by his face he'd no plan to be that somebody; the needle can't have shifted by one mile an hour. So I was. He lifted a finger off the wheel going by.",
#:   "The wind of it rocked our little car, and that was the most exciting thing it did. Before the wind there'd been half a minute in which a coach came nearer and nearer on the other carriageway, in a dead straight line, at a dead level speed, and I sat with my hands in my lap.",
#:   "I make complaint against my robot, not against the truck. The truck came from front in the lane where it belongs, with normal velocity, always equal, it did not go left or right. A human sees that such truck will not wait for him. My robot did not see it.",
#:   "Traffic at the scene was light, consisting of one taxi. It was travelling east as V1 travelled west, was at all times within the eastbound lane, and was neither slowed nor accelerated before the two drew level. Its driver had seen V1 and, having priority, continued as he was.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "follow"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(4, 10)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
