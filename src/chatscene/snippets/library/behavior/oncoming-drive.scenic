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
