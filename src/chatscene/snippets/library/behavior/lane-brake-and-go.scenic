#: description = "The car brakes suddenly and then drives off again."
#: rephrasings = [
#:   "A vehicle decelerates hard for a moment and afterwards picks up speed.",
#:   "The adversary brake-checks the ego and accelerates away.",
#:   "The car next to the ego slows sharply, then resumes its pace.",
#:   "The driver stamps on the brake and shortly after on the gas.",
#:   "The motorbike dabs the brakes violently and pulls away once more.",
#:   "He brake-tests us once and takes off again.",
#:   "Vehicle 2 decelerated abruptly, then resumed its travel speed.",
#:   "Hard brake pulse, then acceleration to prior speed.",
#:   "Chap jumped on the brakes for no reason and then off he went again.",
#:   "Vehicle 2 braked abruptly without cause, then resumed its speed.",
#:   "Car: hard brake, brief, then away again. No full block.",
#:   "The target applies sudden braking and, after a short interval, accelerates back to speed.",
#:   "The bus brakes suddenly and then goes on again.",
#:   "One brake event then recovery: decel spike, then throttle back up, keeps its lane.",
#:   "He stamped on the pedal out of the blue, seemed to come to his senses, and got going again.",
#:   "He's thrown the brakes on, wait, no, he's pulling away again, carry on.",
#:   "he braked outta nowhere and then just drove off like nothing happened",
#:   "For no evident cause the driver checked his car violently, then picked up his pace once more, a resident said.",
#:   "You braked with violence, released, and resumed your journey, all within a couple of seconds?",
#:   "Car suddenly put brake, then again started going, I don't know what for.",
#:   "Whacks his brakes on, thinks better of it, picks up again. Like driving behind a yo-yo.",
#:   "Unexpected short braking event with subsequent recovery of speed.",
#:   "RANDOM BRAKING THEN DRIVES OFF LIKE NOTHING HAPPENED",
#:   "The bus choked its speed and then revived.",
#:   "Coach drops anchor for a second, weighs it, and off again.",
#:   "Put in a scooter that brakes out of nowhere, then gets a move on.",
#:   "Brake lights! Oh. Never mind, the truck's picking its feet up again.",
#:   "Er bremst like for a ghost, then gives gas like before.",
#:   "car did a massive brake for a pigeon then just carried on",
#:   "The driver of the estate must have imagined something in the road, since he threw out the anchors and a second later was bowling along as before.",
#:   "Test 9b: the target applies 0.7 g for 1.2 s without visible cause, releases, and re-accelerates to its initial travelling speed in the same lane.",
#:   "It was soon rolling along at full speed again, that bus, but a moment earlier its nose had dipped so sharply that every strap-hanger aboard had lurched.",
#:   "Is he stopping? He's braked hard enough... no, he's let it off and he's gathering way again, so we just keep our distance and follow on.",
#:   "According to the motorcyclist's own statement he snatched at the lever when a wasp got into his helmet, then opened the throttle and continued on his way.",
#:   "The lorry stopped being a lorry and became a wall for a heartbeat; then it sighed, let go of its brakes and resumed its way down the road.",
#:   "I'm a courier, so I spend my days looking at other people's rear ends. The van today went from fifty to about twenty in no time at all, brake lights blazing, nothing in front of it whatsoever, and then the driver seemed to wake up and put his foot back on the accelerator.",
#:   "V1 was in steady traffic when V2 slowed with considerable force, for reasons its operator could not afterwards explain. The slowing lasted under two seconds. V2 then increased its speed once more and left the scene without its occupants having noticed that V1 had gone into the verge.",
#:   "Dear insurers, I enclose my sketch. The silver car suddenly slackened its pace so violently that my dog ended up in the footwell, and while I was still gathering him up it had already got back up to speed and was disappearing along the road as though nothing had occurred.",
#:   "Phantom-braking scenario wanted: the other vehicle, itself probably an assisted one, tracks its lane, fires a short, strong deceleration for no reason, and recovers. Afterwards it must be seen speeding back up and driving on, because the recovery is what our tracker keeps missing.",
#:   "My husband always says trucks cannot stop quickly, but this one did nearly. All of a sudden its wheels were smoking and its tail was in the air, then the smoke was gone and it trundled off with rising speed, leaving the two of us to remember how to breathe.",
#:   "Minibus: savage dab of brake, no reason, now rolling up to speed again.",
#:   "Taxi nosedives, recovers, trundles on as if nothing was the matter.",
#:   "brake! ...oh ok hes going again",
#:   "He had a wasp, a sneeze or a change of heart, that motorcyclist, for he shed half his speed at a stroke and then opened the tap again.",
#:   "Longitudinal profile of target: cruise, step to minus 7 m/s² for about a second, immediate return to cruise; no lane change before or after.",
#:   "Between one lamp post and the next the coach threw everyone into the seat in front, and by the third lamp post it was bowling along as usual.",
#:   "Could it be programmed that the lorry suddenly bites hard on its brakes, thinks the matter over for a second and picks up where it left off?",
#:   "Slammed his anchors, he did, for a crisp packet, and while I was still swearing he'd got his boot back down and was on his merry way.",
#:   "The driver of V2 mistook a shadow for a dog, applied the service brakes forcefully, recognised his error and brought the vehicle back to its previous speed.",
#:   "We were singing in the car, I'm not ashamed of it. In the middle of \"Delilah\" the van's rear end came up and all its lights came on, and we stopped singing. By the time we'd drawn breath the lights were off again and it was pulling away as happy as Larry. The dog is still under the seat.",
#:   "My smartwatch rang to ask if I'd had a fall. I hadn't; I'd only done what the bus did. The bus had gone from a steady forty to about ten without warning, and just as I'd got my own bike under control it breathed out and went back to its forty.",
#:   "From the perspective of the lidar there are two events and not one. The first is a fierce loss of speed by the truck with nothing whatever ahead of it. The second, and this is the one which our planner missed, follows a second and a half later, when it gathers pace again and leaves us braked to a crawl.",
#:   "I had the caravan on and was keeping to the slow lane. The estate's occupants were having a row, you could see their arms. At one point the driver must have stamped on the wrong pedal to make a point, because it stood on its nose. The arms went on waving, and the car went on as well, quick as before.",
#:   "The accused was asked what he had hoped to achieve. He wished, he said, to \"wake them up\". To that end he had braked his lorry with all its might for the space of a second, and, satisfied that they were awake, had put on speed and continued along his lane in the direction of Leicester.",
#:   "On the film there's a squirrel, then there isn't. The scooter's back wheel leaves the ground, that's how hard the girl is pulling on the lever; she bounces down, she sees there's no squirrel any more, and she twists the grip and whirrs off the way she'd been going. The camera car comes within a nose of her.",
#:   "Ja, in the Autobahn works there is everywhere dust. A truck was in his lane with constant speed, and from nothing his tyres were crying and he becomes short, like an accordion. I am braking too, my heart goes. Then the truck becomes long again, drives away with his normal eighty, and I understand nothing.",
#:   "A friend who tests these things tells me the horrible part isn't the deceleration. You're ready for that. It's that the motorbike which has just hauled itself down as though for a brick wall doesn't end up at the wall. The wall isn't there; the rider's back on the gas, and you're left at a standstill with a queue behind you.",
#:   "The lady on the radio calls it a ripple. It begins with someone like the man in that Honda, who had a clear lane and a dry road, and who nevertheless jumped on his brake pedal as if he'd seen the devil. He got over it. In a moment he was travelling as fast as ever, but four miles back they'd stopped altogether.",
#:   "Keep your distance and you'll never be bothered by it. See, that pickup's gone from cruising to practically nothing, tail high, and you've had time to squeeze gently. And what's he doing now? He's sorted out whatever it was and he's piling the speed back on. So we do the same, without any fuss.",
#:   "Everything that had been on the parcel shelf is now on the dashboard, and I can date the moment. It was when the cab's stop lamps lit, hard and all together, for I suppose a second. It hadn't stopped, mind you. It was on the move again, accelerating away along the lane, while my umbrella was still in the air.",
#:   "One ugly jab of brake from the lorry, then business as usual.",
#:   "scooter did a stoppie for nothing n then just buzzed off again",
#:   "Pickup: lamps full red, two beats, lamps dark, pulling away. Over.",
#:   "For about as long as a cough lasts, the bus was in an emergency; then its lamps went out, its engine took up the tune again and it rolled off.",
#:   "I braked to the floor for a car which, by the time I'd finished doing so, had no longer any wish to be slow and was well on its way again.",
#:   "The interval shrank as though the van had hit treacle and then, just as I was ready for the bump, opened up again because it was off.",
#:   "Program the truck with a short fit of panic: for one second all its braking power, without a reason, and after that the throttle until it's cruising as before.",
#:   "My standing passengers will tell you the motorbike's fit of braking was over in a moment, since the lad on it was away up his lane before they'd picked themselves up.",
#:   "The event recorder of V2 shows 31 mph, 12 mph and 31 mph within the space of six seconds, with the brake circuit closed for only the first two of them.",
#:   "It cost me a full cup of tea. The taxi was in its lane, I was minding mine, and out of a clear sky its boot reared up and its tyres gave a bark. I hadn't even got the handbrake up before there was blue smoke at its exhaust and it was putting the metres between us again.",
#:   "A yawn on the accelerometer, a cliff, and a ramp. That's the coach in one breath: it had been going steadily, it fell off the cliff to a third of its speed, nobody knows why, and a second later it was climbing the ramp back. The ego is to come out of it without having stopped altogether.",
#:   "On two wheels you steer by other people's red lights. The Polo's came on so fiercely that I locked up and went into the hedge. From the hedge I noted that they had gone out, that the Polo was in second, then third, then round the bend. Whatever it had seen, there was nothing on the road but me.",
#:   "What annoys me is that there was no obstacle to show the police. \"Why did the lorry brake?\" they ask. It braked as though a child lay there. I heard the air, I saw eighteen tyres leave their rubber. Then I heard the air once more, off, and gears, and it took its eighteen tyres to Rotterdam. I've the front of a caravan to explain.",
#:   "Ich sage immer, who brakes must have a reason. The bus had none. From fifty to ten he goes in one second, my glasses fly, I stand on my pedal and wait that he stops. But he stops not! He has already the foot on the other pedal, he goes forth with fifty, and I'm the one who stands.",
#:   "Hear that chirp? That was the van's tyres. Look, he's lost half his speed for no earthly reason, and you'd be forgiven for planning to stop behind him. Only watch the lamps before you do. Out they've gone, you see, and his nose has come up, so he's getting under way; don't sit there gawping, follow him.",
#:   "We on the pavement were treated to a small comedy. A hearse was proceeding along its lane. All at once it bowed, so low that the wreaths slid, and the gentlemen in the limousine bowed too; and then, its manners having lasted a second, it picked its skirts up and proceeded at its former pace, while the gentlemen looked for their hats.",
#:   "Would counsel accept that there were two acts? I would. In the first, my motorcycle was slowed with everything its discs could give, the cause being a plastic bag. In the second, I having recognised the bag as a bag, the throttle was reopened and I went on my way. Between the two, perhaps a second. It was during the second act that I heard the crash.",
#:   "The wiper blades were the giveaway, says our fleet analyst. They flew forward on the screen when the truck nosedived, and lay flat again when it squatted, and between nosedive and squat there's hardly one stroke. Our robotaxi read the first and not the second, and was therefore left standing in a live lane with the truck a hundred metres off, gaining.",
#:   "Someone must have dropped a phone in that estate. It went along sensibly enough until, whoops, every light on its backside was lit and I could read the small print on its bumper. And while I was still steering round where it should have come to a stand, it had found its phone, I suppose, and was trotting off with the lights out.",
#:   "The convoy's rule was sixty yards. It was sixty yards when the sergeant lit his pipe. It was fifteen when he dropped it, the lorry having squatted on its front axle as if it had been shot. It was sixty again before he'd found the pipe, for the lorry had shaken itself, growled, and taken the road as though no shot had been fired.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["brake", "accelerate"]
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
#: [[parameters]]
#: name = "OPT_BRAKE_TIME"
#: low = 0.7
#: high = 1.6
#: unit = "s"
#: meaning = "for how long"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 12.0
#: unit = "m/s"
#: meaning = "how fast it drives afterwards"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.4, 1)
param OPT_BRAKE_TIME = Range(0.7, 1.6)
param OPT_ADV_SPEED = Range(7, 12)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
