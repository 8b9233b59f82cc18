#: description = "The car in the target lane suddenly brakes."
#: rephrasings = [
#:   "A vehicle in the neighbouring lane slams on the brakes.",
#:   "The adversary ahead decelerates hard and without warning.",
#:   "The car next to the ego performs an emergency stop.",
#:   "The driver in front hits the brake abruptly and blocks the lane.",
#:   "The lorry loses speed sharply and comes to a standstill.",
#:   "The bloke ahead stands on the brakes out of nowhere.",
#:   "Vehicle 2 decelerated suddenly without apparent cause.",
#:   "Target decelerates at 6 m/s² without warning.",
#:   "I was moving over and the motor in the lane I was heading for suddenly hit the brakes",
#:   "As V1 changed lanes, V2, already established in that lane, braked abruptly.",
#:   "Van in lane we want: sudden brk.",
#:   "The vehicle in the destination lane performs a sudden braking during the VUT's lane change.",
#:   "I want to change the lane, and the truck which is there brakes at once.",
#:   "Target-lane NPC should decelerate hard the moment the SUT commits to the merge.",
#:   "They were slipping over into the next lane when the bus that had been leading it jammed on its brakes.",
#:   "You're going for that other lane, mind the bike in there, whoops, his brake light's come on full.",
#:   "was gonna switch lanes and the car there suddenly slams the brakes",
#:   "Just as the teacher was about to move across, a bus in the lane she wanted braked without warning",
#:   "The vehicle occupying the lane you intended to enter slowed violently, is that your account?",
#:   "I want to change lane, the lorry there suddenly e-brake, lucky never go in yet",
#:   "I'm all set to slip over and matey in that lane goes and stamps on it",
#:   "Sudden hard deceleration of traffic in the intended destination lane",
#:   "Bike BRAKE SLAMS in the lane I was moving into",
#:   "The coach in the other lane clamped its wheels.",
#:   "Taxi in the adjoining lane brakes like it's hit a wall.",
#:   "Out of nowhere the coach drops its anchors.",
#:   "Target-lane lead decelerates at once, hard, no cause given.",
#:   "What did the biker see that made him pull both brakes so violently?",
#:   "NO WARNING: LORRY STOMPS THE BRAKE",
#:   "Make the pickup that occupies the lane we mean to use brake abruptly, as though a child had run out, though there is nobody.",
#:   "I had picked my spot behind the blue van over in that lane when its rear end rose and its speed collapsed.",
#:   "A sharp reduction of speed, without warning and for no apparent reason, was made by the bus in the lane to which the claimant was headed.",
#:   "Behind that truck in the other lane you'd have been all right, only he's gone and clobbered his brake pedal.",
#:   "The camion on the lane where I want to go, he pinches the brakes of one blow, I have no time to understand.",
#:   "Brake lights, tyre smoke, and the sedan in our destination lane had shed half its pace before the AV finished checking its mirrors.",
#:   "The road was dry and empty in front of him, that's what I can't get over. The motorcyclist in the lane beyond had nothing before him for two hundred metres, and yet he squeezed everything he had and the back wheel came off the ground.",
#:   "During the merge assessment, the vehicle holding the lane to be entered applies full service braking at the trigger point. There is no preceding acceleration and no lateral motion; only its velocity falls, rapidly, and the subject vehicle must revise its gap choice.",
#:   "I looked over my shoulder, everything fine, the coach in that lane was a good way up. When I looked forward again it was huge, because in that one second its driver had rammed on the brakes, and there I was with my indicator going.",
#:   "My pupils hate this one. You've chosen your lane, you've chosen the hatchback you're going to follow in it, and then without rhyme or reason that hatchback's nose dips and it's braking for all it's worth. Plan for it, leave yourself a way out.",
#:   "My granddaughter drives and I keep her company. There was a lorry in the lane she fancied, going along quite nicely, and then there came such a screeching from it, for the man had jammed his foot down, and nobody could tell us why he braked.",
#:   "Bus over in our intended lane performs a crash stop.",
#:   "The hatchback in the lane we'd picked nosedives without reason.",
#:   "Lane two, which I want: truck hauls up violently.",
#:   "My mirror said go, my shoulder check said go, and then the Citroën in that lane put all four tyres into a skid for no reason.",
#:   "While the ego is about to move over, have the motorcycle that is using that lane scrub off its pace as violently as it can.",
#:   "He wanted to go behind the tanker on the other lane, but the tanker, from one moment to the other, made a Vollbremsung.",
#:   "Unit 9, I was going to take the outside lane but there's an SUV in it just gone full on the anchors, stand by.",
#:   "The witness confirms that the coach occupying the lane into which the insured was signalling had reduced its speed with great suddenness and no warning.",
#:   "Funny, I'd never noticed how many lights there are on the back of a Tesla until the one in the lane I was headed for lit them all at once.",
#:   "We were boxed in by roadworks cones and I had to get into the right-hand lane. There was a removal van in it going at a decent pace, so I meant to drop in after it. I'd got as far as thinking so when every strap in that van must have snapped taut; its front went down and its speed simply went.",
#:   "Dear Motor Claims, on the 4th inst. I intended to occupy lane two. Your policyholder was occupying it already. He was not asked to leave it, or to speed up, or to do anything at all, and yet, with an open road ahead of him, he trod on his brake so hard that his luggage came through to the front.",
#:   "For the merge planner the rate of closing is everything. The lead vehicle in the goal lane holds the speed of the ego until the event distance is reached, and then without any external cause brakes with the configured value. Observe whether the AV postpones its merge, brakes too, or carries on as though nothing had happened.",
#:   "A cyclist sees things from the verge. There was the electric car with nobody in it, blinker going, wanting the next lane. In that lane was a lad on a big Kawasaki. I don't know what possessed him, a bee maybe, but he grabbed such a handful that the back of the bike was snaking, and he went from sixty to twenty-five.",
#:   "What had looked, a heartbeat ago, like a sensible space was now full of trailer. She had not moved any nearer to the lane in which it was; it was the articulated lorry there that had, so to speak, come to her, its brakes shrieking, its driver bolt upright, and no visible obstacle before him.",
#:   "A lesson from today: Ayesha checks properly, signals properly, and is a second from going across. The minicab she'd chosen to sit behind picks that second to jam everything on. Not because anyone's in his way, he'd just been asked to let someone out. So what do we say? The space isn't yours until you are in it.",
#:   "Question from a listener in Leeds. She was changing lane on the A64, and the pickup that was driving in the new lane \"just folded up in front of me\", as she puts it. She means that its brakes came on hard, with no traffic ahead of it at all. Is she to blame for her scratched bumper?",
#:   "Video timestamp 0:14, brake lamp of the coach in the left-hand lane off. Timestamp 0:15, brake lamp on, and the coach, which we had expected to lead us in that lane, is now going at half its speed. There's nothing before it. Our own vehicle's indicator had been on since 0:12.",
#:   "It says on my statement that I was \"about to pull out\". I was. The lorry had that lane all to itself, bumbling along at fifty with me, and I'd have gone in after it nice as you like. Only it shed all its speed with a noise like a scrapyard, and I thought, well, not in there, then.",
#:   "I have driving licence since two months. The teacher says \"change lane\", so I look, and in that lane is one bus, far enough, same speed. I turn my eyes to the front, turn again to the bus, wah, the bus is so big. It has braked very strong, people inside fall down. I not dare to change.",
#:   "the gap i was aiming for closed like a lift door. i hadnt done anything yet, just had my blinker on, and this scooter girl in that lane yanks both levers cos her hat flew off. whole thing squirmed about and basicly lost all its speed. glad i wasnt in there already",
#:   "Picked my new lane; its bus promptly stood on its nose.",
#:   "the van over there where were headed dropped anchor",
#:   "Lane-change destination: lorry sheds speed hard, unprovoked.",
#:   "I'd already chosen my slot behind that estate in the other lane when its boot reared up and the slot went.",
#:   "Get the motorcycle that occupies the lane I'm about to change into to throw away its speed as hard as its brakes permit.",
#:   "Behind the tanker on the right there was to be a place for us, and there was, until the tanker's tyres began to smoke.",
#:   "Indicating right, mirror, shoulder, and in the lane I'd looked at the whole back of the minibus was ablaze with red, its speed in ruins.",
#:   "Why must the coach in the very lane you fancy choose the very second you fancy it for a full-blooded emergency stop?",
#:   "Upon V1's intended change of lane, V2, which was established in the lane of destination, lost 35 km/h within two seconds through heavy brake application.",
#:   "We never made it into lane one. What had looked like a train of traffic bowling along as fast as ourselves turned, in the blink of an eye, into a lorry with its cab dipping, its trailer hopping and its stop lamps on, and I hauled our wheel straight again. He'd nothing in front of him but tarmac.",
#:   "The lad on the Honda never knew we existed. We were going to drop in after him on the left, he was setting a nice tempo. Then his front fork went right down, his back wheel went light, and he was going at half that tempo, bolt upright in his own lane, while we wobbled on in ours.",
#:   "Ticket title: gap acceptance uses stale speed. At t minus 1 s the pickup occupying the neighbouring lane does 22 m/s, AV signals and accepts the gap behind it. At t, pickup jerk goes through the floor, 6 m/s² of deceleration, no lane change on its part, no cause visible. AV had its front tyre on the marking.",
#:   "I heard it before I saw it, and I'm the one with hearing aids. Such a scream of rubber, on my left, where my daughter was just about to take us. She stayed put. When we drew level, the taxi that had been spinning along in that lane was crawling, with its driver's face as white as his shirt.",
#:   "What should've been an easy move for the robotaxi went to pots. In the lane it had asked for a removal van was cruising. Nothing wrong with that. But when the robotaxi had its indicator on and its wheels about to turn, the back of the van was growing, quickly, with its high-level lamp lit. Abort, said the screen.",
#:   "We Germans have the Rechtsfahrgebot, so I wanted back to the right. On the right goes a Kombi, good distance, same tempo. I set the blinker, and in this moment I see how the Kombi goes in the knees, and between him and me are at once not forty metres but ten. Why he did it, only he knows.",
#:   "Take it from an old coach driver: your eyes want to go to the empty bit behind the other fellow. Don't let them. Leave them on the other fellow, in that lane you're after. Mine last week was a Corsa. Had I watched the empty bit I'd have been into it as it shrank, when she slammed everything on.",
#:   "Q. You had your indicator going. A. I had, for lane three. Q. Who was in lane three? A. A silver Lexus, a bit ahead. Q. And when you looked again? A. A silver Lexus, alongside, with smoke off its wheels. It hadn't come back to me, if you follow. It had stopped going away from me.",
#:   "Two smells on a motorbike: cut grass and other people's brakes. I'd got the second in my nose before my head was round. The truck in the lane I was about to lean over into had been clamped down on so fiercely that its mud flaps were still swinging forward. I stayed in my own lane, thank you.",
#:   "On activation the vehicle in the lane which the subject vehicle is to enter, and which until then has matched the latter's motion, receives the parametrised brake pressure. It keeps to its lane. Neither a cause for the braking, such as a further vehicle, nor a warning beyond the stop lamps is provided for in the simulation.",
#:   "The parcels told the driver what he'd done. He'd had them stacked to the roof of the van as he cruised down the left lane, and now they were in the front with him. It hadn't been for my sake, I'd only been thinking about joining that lane. I thought about something else instead.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
