#: description = "The car keeps pace with the ego and then brakes hard in its lane."
#: rephrasings = [
#:   "He sits alongside us for ages and then drops anchor.",
#:   "Vehicle 2 ran parallel to vehicle 1 before decelerating abruptly in the adjacent lane.",
#:   "Level with us, then hard brake next lane.",
#:   "The target matches the VUT's speed abreast and then brakes strongly.",
#:   "It is going the same speed near us, then it brakes much on its lane.",
#:   "The bus beside us matches us metre for metre until it slams to a stop.",
#:   "A motorcyclist cruising abreast suddenly falls back under braking.",
#:   "Neck and neck, and then the lorry next door stands on its brakes.",
#:   "a lad in a Golf ran neck and neck with me for a bit, then dropped anchor in his own lane",
#:   "Vehicle #2 traveled abreast of Vehicle #1, matching speed, before its driver abruptly applied the brakes without leaving his lane.",
#:   "Bus abreast, same v; then sharp decel next lane.",
#:   "The target drives level with the VUT in the adjacent lane at equal speed; it then decelerates at 6 m/s² within that lane.",
#:   "The motorcycle goes with me side by side, same speed, and then he brakes strong, he stays on his lane.",
#:   "Parallel runner, matched velocity for a few secs, then panic stop in the neighbour lane. No lane change!",
#:   "They rode shoulder to shoulder with the lorry until all at once it stood on its brakes and fell away behind their window.",
#:   "The ambulance is cruising along at your elbow... now look, he's dropped away from beside you, stamped on it in his own lane.",
#:   "he was right next to us the whole time matching us n then just slammed it in his lane and vanished",
#:   "The two vehicles were travelling side by side when, according to a passenger, the coach pulled up sharply",
#:   "You maintained station beside the claimant and then, remaining in your own lane, braked with violence?",
#:   "That bike is coming along with us only, same speed same speed, then suddenly in his lane he puts full brake",
#:   "Bloke keeps me company door by door for half a mile, then chucks out the anchors next to me, no reason",
#:   "Abreast running at equal speed followed by abrupt deceleration of the adjacent vehicle",
#:   "Fire truck keeps level with me, then PANIC BRAKES one lane over",
#:   "The van twinned our speed, then dropped like a stone behind its own brake lights.",
#:   "The cab shadows our speed next door, then its nose dips.",
#:   "Side by side we roll, until the coach brakes violently in its lane.",
#:   "It goes equal quick beside me, then makes a full braking there.",
#:   "Ambulance abeam of ego, speeds matched, then harsh decel, own lane kept.",
#:   "Why did the bike riding level with me suddenly clamp on its brakes?",
#:   "The HGV in the neighbouring lane held exactly our forty miles an hour for a good while before its tyres began to smoke under braking.",
#:   "Let a van run alongside the ego at the same velocity, and some metres before the event make it brake hard without leaving its own lane.",
#:   "For a stretch the police car was glued to our side window, doing what we did; then its driver hit the brakes where he was.",
#:   "We had been keeping step with a pickup on our left for a whole song when it braked so fiercely that it was behind us at once.",
#:   "Driver B stated he was maintaining the same speed as the car at his side when he had to brake heavily; he remained in his marked lane throughout.",
#:   "Watch the scooter at your shoulder, he's been exactly as fast as you; there, he's grabbed a fistful of brake, dead straight, in his own lane.",
#:   "I drive an artic and I know what it is to sit level with somebody. This fire engine had been holding station at my cab door since the roundabout, neither gaining nor losing, and then he braked as hard as that thing can, in his own lane.",
#:   "In the paired-lane test the target bus is synchronised with the subject vehicle's speed, front ends offset by a few metres. On reaching the trigger point it is subjected to full braking while its lateral position in the neighbouring lane is maintained.",
#:   "My daughter was waving at the people in the bus since it wasn't getting any faster or slower than us. All at once they jerked forward in their seats; the driver had braked like mad, and he never came over towards us at all.",
#:   "It is reported that the hatchback had been travelling parallel with the claimant's vehicle at a matching speed for some 300 metres. Its brake lamps then came on and it lost speed very rapidly, without deviating from the lane that it occupied.",
#:   "So we're on the dual carriageway, and this motorcyclist in the next lane has picked the same speed as us, you could've passed him a sandwich. Then his front end dives, he's braking for all he's worth, still bang in the centre of his own lane.",
#:   "Level, level, level, then one lane across he brakes like mad.",
#:   "Taxi keeps our speed alongside; abruptly it's all brakes over there.",
#:   "Neighbouring lane: matched speed, then tyres howling to a stop.",
#:   "It wasn't racing us and it wasn't lagging, that pickup in the next lane, it simply went as we went until its tail flew up under braking.",
#:   "Ambulance alongside at identical speed for 200 m, followed by maximum retardation; lateral position in its own lane unaltered.",
#:   "the bus was glued to our side doing exactly what we were doing then BAM full brakes, stayed in his lane tho",
#:   "She told the officer that the lorry had travelled abreast of her for a while and that it had then been stopped short in the lane beside hers.",
#:   "Make the motorcycle stay level with our car at our own pace, and when we come to the spot, have it haul up hard without changing lanes.",
#:   "That coach has sat next to your shoulder since the bridge; now you see it pitch forward, he's emergency-braking over there in his lane, and you carry on.",
#:   "I remember it since I'd been reading the advert on its flank for half a minute, every word of it, as it neither crept ahead nor dropped behind. Then the advert was torn away backwards. The bus had had everything thrown at its brakes, there in the lane next door, and never came our way by an inch.",
#:   "The adjacent target is speed-coupled to the vehicle under test with a tolerance of 0.5 m/s and remains in its own lane. At the trigger distance the coupling is released. The target then undergoes emergency braking along its lane line, no steering being applied.",
#:   "We'd got talking through the open windows, me and a bloke in a yellow van in the next lane, both doing a steady thirty. He was in the middle of telling me the score when his head shot forward. His tyres shrieked, he was stopping for all he was worth over there, and I never did hear who won.",
#:   "Insured's description: third-party HGV was travelling in the lane to the left of ours at the same rate of progress. For reasons unknown it then performed an emergency stop. It kept to its lane, but our driver, startled by the noise, clipped the barrier on the right.",
#:   "What does it look like from a bike? There's a wheel next to yours, a big one, turning precisely as fast as you're going, on and on. And then the hiss, and the wheel isn't turning any longer, it's sliding, in its own lane still, and it has gone out of the corner of your eye.",
#:   "First the gap plot: flat at plus two metres for eleven seconds, so the fire engine was holding our pace in the next lane. Then the line falls off a cliff, minus eight metres per second squared. The lateral plot doesn't budge, it was all done inside its own markings.",
#:   "In China we say two horses, one saddle. The grey car runs together with me, head equal to head, he at left lane and I at right lane, speed no difference. Suddenly he makes very urgent brake in his lane and my son asks where is the car.",
#:   "My wife says I was competing with him and I say I was not. A man on a large motorcycle happened to be going at our speed in the lane alongside, mile after mile, one could have set a spirit level across us. Then his front fork went down to the stops and he was braking for dear life, straight as a ruler.",
#:   "Because a dog had got on to the outside lane, the police car there had to do an emergency stop. Until that moment it had been accompanying the robotaxi, door to door and at the same speed, as the passengers had noticed with some unease. The robotaxi's lane was clear throughout.",
#:   "Was the accused gaining on you? No, my lord, nor falling back; we might have been bolted together, he in his lane and I in mine. What ended that? His brakes did, my lord: the smoke came off them, and he went backwards past my window without ever leaving his own lane.",
#:   "Suddenly there was sky where the cattle truck had been. It had filled the side window, bars and noses and all, since we joined the ring road, for it was going just as we went. When I turned my head I saw it behind us in the lane it had always had, stood on its brakes with the load sliding.",
#:   "Our shadow in lane two suddenly smokes its tyres, still in lane two.",
#:   "Wheel to wheel, then his locked, in his lane.",
#:   "Coach at our elbow, same speed, abruptly anchored where it was.",
#:   "I could've read the copper's watch, he'd been at my window so long, and then his whole car pitched forward in its own lane and was gone behind.",
#:   "Requested: a truck in the neighbouring lane slaved to the ego's velocity; at the trigger its service brake goes to maximum, steering untouched.",
#:   "that ambulance wasn't faster than us or slower than us for like a mile, then it just nails the brakes one lane over, no swerve no nothing",
#:   "The relative speed of the coach in the next lane, nil until that instant, jumped to minus nine, while its distance from the lane marking did not alter.",
#:   "He is going like my brother, side by side, same same, and suddenly in his own line he has pressed full brake, what a screaming there was.",
#:   "Two lanes, two vans, one speed; and then, dear listeners, one van with its back wheels off the floor, though still in the lane God gave it.",
#:   "There's a stretch of wall there, and I'd been watching our two shadows on it, mine and the lorry's, nose by nose. Mine went on along the wall. The lorry's was plucked off backwards with a noise like a pig being killed, and when I checked the mirror he stood there bang between his own two white lines.",
#:   "Evidence bag 3 contains the passenger's phone, on which she was filming the motorcyclist alongside. He remains in the centre of the picture for nineteen seconds, neither gaining nor losing. In the twentieth his head drops, his back wheel lifts, and he leaves the picture by its rear edge; the strip of road between him and the taxi keeps its width throughout.",
#:   "For a good while our boy had been nodding at a boy on the bus, and the boy on the bus had been nodding back. You can't do that unless you're going at one speed. Then the other boy's nose hit the seat in front, six wheels squealed, dead straight in their own lane, and our boy had no one to nod to, though we hadn't slowed a jot.",
#:   "Do you know what we want from a vehicle next to us, Liam? We want it gone, ahead or behind. This fire engine did neither, it hung at your shoulder as if you'd towed it. And now it's gone, all right, it's behind, because the driver has thrown out everything he had, over there, dead straight, in his lane.",
#:   "I came to the window because of the noise, and the noise was rubber. What there was to see then was a hatchback stopped short in the outer lane, blue smoke about it, and a white car going on unconcerned in the inner one. My neighbour, who'd been out there with her dog, says they'd come along as a pair, level as horses in a team.",
#:   "As long as the cab beside me blocked the sun I was comfortable, and it blocked it for the whole length of the bypass, matching me to the inch. When the sun hit me in the eye I looked across. No cab; forty yards back it was standing on its front axle in the lane where it had been all along.",
#:   "Log note, robotaxi 14: adjacent vehicle (box truck) holds 0.0 to 0.4 m/s relative for 14 s, lateral clearance 1.2 m. Then a tyre squeal is picked up by the left microphones and the box truck's relative speed falls off at 7 m/s². Clearance is still 1.2 m, so the lane change alarm that went off was false.",
#:   "My mother-in-law counts things. She'd counted the rivets on the tanker next to us, twice, and it hadn't moved forward or back by one rivet. She'd begun on the third count when they flew away to the rear, all of them together; the man had stamped on his brakes there in the lane alongside, and she blamed my driving.",
#:   "Unit 2 had taken station alongside Unit 1 in lane one and maintained it for approximately a quarter mile, both at 48 mph. Forty-one feet of skid marks begin in the center of lane one and end in the center of lane one beneath Unit 2. Unit 1, in lane two, proceeded without braking and its driver heard rather than saw the event.",
#:   "We were doing eighty, he was doing eighty, the motorcyclist at my right hand, and I have thought: beautiful, we are a film. Then from him comes a cry of tyre. I look at right, I see only air and the white line of his lane, and in the mirror he sits on a machine which stands almost on its head.",
#:   "The duet lasted from the river to the gasworks. Whatever our old bus did, the pickup in the lane beside did too, a little faster when we were, a little slower when we were, like a child that imitates. There it tired of us; its bonnet bowed, its tyres howled, it dropped out of the duet as if through a trapdoor, straight, and on its own side.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pace", "brake"]
#: position = "beside"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -22.0
#: high = 4.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 1.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-22, 4)
param OPT_ADV_AHEAD = Range(1, 6)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 0.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE)
