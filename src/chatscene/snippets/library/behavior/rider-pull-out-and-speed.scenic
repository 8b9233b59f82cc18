#: description = "The rider pulls out from the roadside into the ego's lane and accelerates away along it."
#: rephrasings = [
#:   "A scooter shoots out of the side, straight into our lane, and speeds off.",
#:   "The motorcycle entered the travel lane from the shoulder and accelerated.",
#:   "moto pulls out in front, guns it",
#:   "The powered two-wheeler joins the VUT's lane from rest and gathers speed.",
#:   "The bike comes from the side in our lane and makes gas.",
#:   "A courier launches off the pavement and pedals hard down the road before us.",
#:   "The moped kid nips out ahead and opens the throttle.",
#:   "A biker who was standing at the roadside roars off right in front of us.",
#:   "A courier on a bike set off from the roadside into my lane and pedalled like the clappers up the road.",
#:   "The motorcyclist left the shoulder, entered the lane ahead of Unit 1 and rapidly gained speed.",
#:   "MC from edge into lane, opens up, away.",
#:   "The two-wheeler moves from the road edge into the lane of the test vehicle and accelerates in the direction of travel.",
#:   "The bicycle goes from the side on my lane and then rides fast away.",
#:   "Rider joins our lane from the roadside and pulls away ahead, doesn't cross it.",
#:   "He pushed off from the verge, wobbled into her lane and then was off up the street like a shot.",
#:   "Scooter's joining from the side, no signal, he's in your lane, but he's off, he's pulling away.",
#:   "bike came off the side into my lane and then took off down the road fast",
#:   "A moped joined the lane from the roadside and quickly made off down the street.",
#:   "The cyclist quit the verge, entered upon my client's lane and made away along it with increasing haste.",
#:   "One bike from road side came in my lane and raised full throttle, went away straight.",
#:   "Off the side he comes, in front of me, head down and away up the road like the Tour de France.",
#:   "Lane entry of two-wheeler from roadside with subsequent longitudinal acceleration away",
#:   "BIKE JOINS FROM THE SIDE AND TAKES OFF",
#:   "The cyclist slips in from the verge and sprints off along our lane.",
#:   "cyclist sets off from the curb ahead and races along our lane",
#:   "Bike joins from the verge, sprints on in our direction.",
#:   "Pedal courier enters ego lane from edge, speeds off ahead.",
#:   "WHERE DID HE COME FROM? Cyclist jumps in and pedals away",
#:   "Have a racing cyclist leave the roadside and zip off before us.",
#:   "A lad on a bike bumped down off the pavement in front of my car, turned the way I was going and put the hammer down.",
#:   "The bicyclist target leaves the roadside, takes up the VUT's lane and rides on in the same direction as the VUT with increasing speed.",
#:   "She had been waiting by the hedge with one foot on the pedal; then she swung into our lane and went tearing off along the road ahead.",
#:   "A cyclist which was standing at the border has entered in my lane and, standing on the pedals, he has gone away in front of me.",
#:   "From the lay-by a woman on an e-bike steered into our lane and, with the motor whirring, rapidly drew away down the street before us.",
#:   "Look out for the rider at the edge, he's coming in ahead of you, but he's quick and he's going your way, the gap's opening already.",
#:   "I was driving along the seafront when a man in lycra pushed off from the railings and came into my lane just ahead. I had to lift off a bit. He didn't hang about, though: head down, he wound it up and left me behind him.",
#:   "Unit 2, a pedal cycle, was stationary beside the roadway. As Unit 1 approached it moved into the lane ahead, aligned itself with the direction of traffic and gathered speed along the lane until it was travelling at some 30 km/h, without ever crossing to the other side.",
#:   "In this one the rider waits by the roadside until the robotaxi is near, rolls into the lane in front of it, and then pedals off along the very same lane as hard as he can. He neither stops again nor turns off, he simply leaves.",
#:   "There's always one of the food-delivery boys hanging round outside the burger place. Tonight he gets his order, hops off the kerb right into my lane, I hit the brakes, and he's already halfway up the street, his legs going like pistons.",
#:   "The boy had been leaning on the milestone. When the van was almost abreast he kicked away from the grass, slipped into the lane before its bonnet and bent over the handlebars, and by the time the driver had cursed him he was dwindling fast up the road.",
#:   "Off the verge, into our lane, head down, away up it.",
#:   "Cyclist joins ahead of us from the side and powers off forward.",
#:   "E-bike slid in from the hard shoulder and left us behind.",
#:   "The commuter on the folding bike got going from the bus stop, took our lane and was soon doing a merry pace away from us.",
#:   "From a roadside standing start the bicyclist target merges into the ego lane, adopts the ego's heading and builds speed, the gap widening thereafter.",
#:   "Wasn't that cheeky, dropping off the pavement right in front of us and then haring up our lane as if we were giving chase?",
#:   "One cycle boy was resting at road side, just when I reached he entered my lane and with full force pedalling went ahead, same direction.",
#:   "Please let a woman on a racing bike start from the edge, come into the robotaxi's lane and speed off up the road ahead of it.",
#:   "He'd been mending a chain by the hedge, the old boy, and he swung into our lane and bowled off along it in front of us.",
#:   "I braked for him as you do, expecting to be stuck behind a bicycle all the way to the village. He had come in off the side path, right onto my bit of road. Yet I never had to overtake. The faster I went the faster he did, and his back light was out of sight by the mill.",
#:   "Unit 2, a bicyclist, had been halted upon the right shoulder. It steered into the lane occupied by Unit 1, some fifteen metres ahead, and aligned with it. The cyclist's own GPS computer shows eleven, then nineteen, then twenty-eight km/h in the same direction, so the separation was increasing when Unit 1 braked.",
#:   "All right, he's gone and joined in front of you without so much as a glance. A bit naughty. But what's he doing now? He's facing the same way as us, his legs are a blur and he's opening up a gap, so you only need to ease off, no need to stamp on it.",
#:   "The space before our bonnet was empty, then it held a yellow jersey, and then, bit by bit, it was empty again. The jersey had risen from the bank where its owner sat, and come over into the lane; and it was going our way with such a will that we lost it at the bend.",
#:   "Every morning at ten to eight there's a schoolboy by the lamp post. As our coach comes near he shoves off, hops into the lane before us and stands on the pedals, and it's a matter of honour that we shan't catch him before the bridge. The driver says we never have.",
#:   "Proposed: a bicycle parked with its rider at the edge of the road, released by the approach of the subject vehicle. It goes diagonally into that vehicle's lane. It straightens out there and accelerates along the lane to its terminal speed, never crossing, stopping or turning round.",
#:   "The boy who brings the pizza was sitting on the kerb with his bicycle. When we came he jumped on, and whoops, he was in our lane and his big square bag was in front of us. It got smaller and smaller because he was so quick, and I was sad since it smelled nice.",
#:   "Our braking event can be seen to be unnecessary only in hindsight. At the time an electric bike had left the gravel strip and entered our lane at jogging pace. Had we coasted for a second we'd have seen it wind up to thirty-five along the lane and take itself off up the road.",
#:   "He had looked like a man at rest, one elbow on the parapet, the bicycle lolling against his hip. There was a scuffle of shoes. He was in the lane before their lights, he was bent double, he was flying along the causeway ahead of them, and the little red lamp had dwindled to a spark.",
#:   "I write since the report says that I was crossing. I was not. From the border I have entered the lane of the van, yes, perhaps too near, this I regret. But then I have followed the lane, the same sense as him, and I have pedalled with all my strength to not disturb.",
#:   "Lorry driver's tip: the ones with clip-in shoes go like rockets. Tonight it was a girl by the lay-by. She pushed off, she was in my lane, I touched the brakes, and before the air had even stopped hissing she'd put fifty yards between us, straight on up the road, out of the saddle.",
#:   "Pushbike quit the roadside, took our lane, outran our headlights along it.",
#:   "Roadside rider joins ahead of us and simply outpaces us",
#:   "E-bike: edge, our lane, twenty, thirty, forty, tail lamp, nothing.",
#:   "She was adjusting a sandal at the verge; she was in our lane; she was a dwindling reflector far ahead of us, in that order.",
#:   "You brake for the lad leaving the pavement into your lane, and you needn't have, as he's got his head down and he's leaving you as well.",
#:   "The gap from our bumper to his mudguard was five metres at the time he joined from the lay-by and it only ever grew.",
#:   "One fellow with tiffin boxes was standing on the side, he pushed into my lane and pedalled off along it so fast that I never reached him.",
#:   "A bicycle shall depart from the right-hand edge, assume the ego's lane and heading, and increase speed along that lane until it has outdistanced the ego.",
#:   "Would anybody have thought that the old girl leaning on the milestone would hop into our lane and show us a clean pair of wheels?",
#:   "The little flag on its pole is what I followed. It had hung limp by the bus shelter; it came out over the gutter and into my lane, and it was pointing at me by then from the wind of going. It stood out straighter and straighter, further and further up the street, and at the mill I lost it.",
#:   "I said to myself, Horst, now you drive with twelve behind a bicycle until Sunday. Because a boy had stood at the border and just as I come he takes my lane, without a look. But this boy has calves like a horse. With twelve he began, with thirty-five he ended, always along before me, and I had nothing to wait.",
#:   "Two things make it different from your usual bike out of the hedge. One, he doesn't go over: once he's in your lane he lines himself up with it, back wheel to you. And two, he's not there for you to catch, because he's cranking it. You see how your gap's opening? You can ease off that brake.",
#:   "It was a good start, I'll give him that. The timekeeper at the roadside dropped his hand, and the rider rolled off the grass into the lane in front of our camera car, which wasn't part of the plan. Up out of the saddle, bike going like a pendulum under him; we were doing thirty and he was drawing away from us.",
#:   "My brakes had hardly come on before they were wasted. The shape that had separated itself from the parked vans and got in front of me was a courier, and couriers are in a hurry. He'd got a rear light. It was a foot across when I stamped on the pedal and a pinprick, straight up the lane, when I let go.",
#:   "Object 31: bicycle, at rest, beyond the edge line. Object 31: bicycle, on our lane, heading equal to ours, 3.5 metres per second. Object 31: same lane, same heading, 8 metres per second, and the time gap to it rising. Peak brake demand was issued between the first two and withdrawn on the third. Passenger comment: \"Why?\"",
#:   "Dear council, the cyclists by the water fountain don't look. I was passing with the school minibus when a young woman in club colours clipped in, bumped off the pavement and was in front of us. We all went forward in our belts. To be fair, by the time we'd gone back in them she was past the library, further along our lane.",
#:   "The dust hadn't settled where his tyre had spun on the shoulder, and he was already in the lane, and already small. They'd seen him only as one sees a fence post. Now the fence post had bent itself over a handlebar and was streaming away before their headlamps down the long white road, and, drive as they might, they came no nearer.",
#:   "I'm stopped at a loading bay in the wagon, watching. Lad on a fixie's got his hand on my wing mirror. He lets go of it and he's into the lane right in front of one of those driverless pods; it bows. He don't look round. Legs like an eggbeater, up the lane, and by the time it's done bowing he's at the lights.",
#:   "Just for the record, the ambulance did not have to overtake the bicycle. Its crew feared they would. The bicycle, propped by the wayside with its owner, got under way and took the lane ahead of them when they were near. But the owner, hearing what was at his back, put on such a spurt along the lane that they never closed up.",
#:   "Our simulated rider failed review for being too slow. Real ones, our reviewer wrote, hang about at the side of the road, drop into your lane a few lengths ahead, and have vanished up it before you're over the shock. So we've given ours a proper sprint. It enters, it aligns with the lane, and it runs away from the ego.",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "accelerate"]
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.5
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it rides in the end"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 3.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"

param OPT_ADV_SPEED = Range(4.5, 9)
param OPT_ADV_DISTANCE = Range(3, 20)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(3.5) until abs(offsetFrom(egoRoute, self)) < 3
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
