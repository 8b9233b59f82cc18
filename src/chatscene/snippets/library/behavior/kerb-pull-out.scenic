#: description = "The parked car pulls out from the kerb into the ego's lane and drives on."
#: rephrasings = [
#:   "The parked car just pulls out in front of us and carries on.",
#:   "Vehicle 2 left its parking position and entered the travel lane ahead of vehicle 1.",
#:   "Parked veh moves off, joins our lane.",
#:   "The target starts from the parking strip and merges into the path of the VUT.",
#:   "The car which is parked goes out of its place and drives before us.",
#:   "The bus leaves its stop and joins traffic without waiting for us.",
#:   "A van at the side of the road sets off and takes our lane.",
#:   "Without a look over the shoulder the rider starts his motorbike from the roadside and slots in.",
#:   "parked car just came out in front of me and toddled off down the road",
#:   "The truck left the curb, entered the lane ahead of V1, and continued traveling.",
#:   "Bus leaves stop -> our lane, drives on.",
#:   "A target parked at the kerbside moves off into the VUT's lane and continues ahead of it.",
#:   "The taxi is parked, then it goes out in my lane and drives.",
#:   "Parked vehicle joins traffic ahead of SUT and keeps driving, no stop, no drama.",
#:   "The van stirred from its parking place, slipped out before them and took the road.",
#:   "That chap at the side is moving off, he's coming out into your lane and he's away. Did he check his mirror? No.",
#:   "parked car just came out in front and drove off without looking, rude",
#:   "A bus setting off from its stop forced its way into traffic and continued along the route",
#:   "You moved away from the kerb into the lane that my client occupied, and you simply drove on?",
#:   "The van parked at roadside anyhow come out into our lane, then drive off, never check one",
#:   "He's off his parking spot and under my nose and away, not a glance over his shoulder",
#:   "Departure of parked vehicle into own lane with continued travel ahead",
#:   "Parked motorbike joins traffic WITHOUT LOOKING",
#:   "The taxi peeled off the kerb ahead of us and motored on.",
#:   "Bus eases off the stop into our lane and gets going.",
#:   "Stationary cab at the roadside wakes up, joins us, trundles along.",
#:   "Let the parked lorry nose out ahead and simply carry on.",
#:   "Ambulance departs kerbside, enters subject's lane, proceeds ahead normally.",
#:   "The parked scooter man came out and rode away before us.",
#:   "A plumber's van which had been standing at the side let off its handbrake, slid into the gap before our bonnet and continued up the road.",
#:   "Along the parking strip a target is at rest; as the VUT nears, it steers out into the VUT's lane and travels on at ordinary speed.",
#:   "There's someone sat in that hatchback with the wheels turned. Yes, out it comes into your lane, and off it goes at a normal lick, follow it.",
#:   "The other party left his parking bay without looking, occupied the lane directly before me and kept going as if I had not been there.",
#:   "I want a police car at the edge of the road that gets under way when the ego is close, merges into its lane and goes on driving.",
#:   "The lorry was sleeping at the border of the street, then he starts, he takes my lane before me, and he continues his travel without hurry.",
#:   "As a cyclist I always look for exhaust smoke in the row of parked cars, and there it was. The old saloon came away from the edge and into the lane, just in front of the car I was behind, and went off down the street at an easy pace.",
#:   "According to the statement of the bus driver, he had finished at the stop, shut the doors and signalled. He then drew out into the lane where our client's vehicle was approaching and resumed his route, without halting again and without any particular haste.",
#:   "It had looked like part of the street, the grey pickup, as fixed as the lamp-posts. Then its front wheels slid away from the gutter, the long flank followed, and it was simply another vehicle on the road, driving ahead of them toward the bridge.",
#:   "Scenario note for the fleet: a delivery truck rests at the kerb. When the robotaxi is about thirty metres off, the truck moves out into the robotaxi's lane and from then on acts as a slow-ish lead vehicle. It neither stops again nor pulls a fast start.",
#:   "fourth time this week outside the chippy, a motorbike that was stood at the side just rolls out in front of me. not even fast. no look, no indicator, in he slides and then he's pottering along ahead of me like we arranged it",
#:   "Parked moped stirs, glides into our lane, and keeps going at its own pace.",
#:   "Have an ambulance leave the kerb ahead and travel on in front.",
#:   "no signal no look, hatchback leaves its spot n potters off ahead",
#:   "The coach had been sitting by the hotel steps; it eased away from the pavement into the lane we were in and went along it like any other traffic.",
#:   "A stationary target at the kerb is set in motion as the VUT nears, enters the VUT's lane ahead of it, and proceeds at constant moderate speed.",
#:   "The camion was garé at the trottoir, he put himself on the way just before my car, and then he rolled in front of me quite tranquil.",
#:   "If the driver's sat in it and the exhaust's puffing, expect it to come away from the side into your lane and carry on up the road.",
#:   "My client's evidence is that the taxi abandoned its place at the roadside, took the lane she was using, and drove ahead of her without interruption.",
#:   "Who gave that pickup leave to come off the kerb into our lane and simply trundle along in front, as though the road had been kept for him?",
#:   "We'd stopped talking because of the rain on the roof. Somewhere on the left there was a row of parked cars and I wasn't minding any of them. One of them minded us: its wheels turned out, it was in our lane, and for the next half mile we looked at its foggy back window going along at thirty.",
#:   "V2, a motorcycle, had been parked at the south curb with its rider astride. As V1 approached at 50 km/h the rider brought it out into V1's lane and continued in V1's direction at approximately 30. He denied having stopped, and the video bears him out. V1 had to brake to that speed.",
#:   "At the trigger the parked police car is released: short creep from the kerb, then into the ego's lane, then steady cruise along it. It is a plain merge from the side and a slow lead afterwards. What I want to see is a soft deceleration by the ego, no horn, no lane change.",
#:   "They're used to people letting them out, bus drivers. This one had all his passengers aboard, and then there was the little tick of the indicator and in the same moment the gap in front of my bonnet was no gap, it was a bus. Off he went up the hill to the next stop but five, and I after him.",
#:   "I do the school run on a cargo bike and I shout at parked cars before they've done anything. I was right about the blue Polo. Gone from its space, out in the lane in front of the robotaxi, never a glance, and then away with it down Park Street at an ordinary twenty-five. The robotaxi lifted off and fell in behind.",
#:   "That the removal lorry was empty you could hear by the rattle. It had stood by the kerb since breakfast. Then, as the milk float of a car that I drive came up, it rattled out before me into the lane and went rattling on ahead of me all the way to Ripon.",
#:   "The space between the skip and the lamp-post, where the fire engine had been all morning, was vacant. She looked for the engine and found it in front of them. It had slid off the kerb and into their lane while she was reading the menu, and it was now leading them sedately through the town.",
#:   "Your honour, I had been parked outside the bank. I saw a car coming but it was some way back. I moved off, I entered the lane, and I continued along Broad Street at the limit. I didn't stop, I didn't dash; if he had been paying attention he would merely have found himself behind me.",
#:   "In our country it is normal like this: the scooter man sits at side of the road with his legs on ground, he has finished his tea. He does not see back, he only starts and comes into your lane, then he goes in front of you with his shopping bag, peacefully, and it is you who should brake.",
#:   "What went through your mind, asked the podcast lady. I said, well, first nothing, because the van's parked. Then the gap between van and pavement got wide, and I thought, he's coming out. And he was. Then he was just some van in front of me, doing its thing, and I had tea all down me.",
#:   "Log 88, 14:07. Row of vehicles at kerb, all tagged static. Third one, a box truck, leaves the row with us at 28 metres and takes our lane. It drives normally from there; we follow it to the end of the route. Tag was corrected to \"dynamic\" only after its front wheels had crossed into the lane.",
#:   "Taxi quits its spot, joins us ahead, potters along.",
#:   "From parked to lead vehicle in one easy move.",
#:   "bus off the stop into our lane and away at its own pace",
#:   "A row of five parked motors had become a row of four, and the fifth was now our leader, rolling along in our lane at thirty.",
#:   "Let the police car that's been resting at the kerb get going as the AV draws near, come over into its lane, and then travel on as normal.",
#:   "Did I have to brake? A bit, as anyone does when somebody who was stood at the pavement is suddenly the vehicle you're following up the hill.",
#:   "Target initially stationary beside the carriageway; on trigger it is driven into the lane of the VUT and proceeds there at constant speed until end of test.",
#:   "The lorryman finished his sandwich, wound down the flap of his mirror, and moved himself and eighteen tonnes from the roadside into the place in front of my bonnet, whence he rumbled off.",
#:   "Its front wheels had been turned out for a while, I noticed. Then the whole van followed them, off the kerb, on to our bit, and up the road in front of us.",
#:   "My coffee spilled, that's all the damage there was. We had the lane to ourselves until the library. From the library onwards we shared it with a blue scooter, which until then I had taken for a thing chained to a lamp-post. It kept to forty, it kept straight, and I kept behind it to the ring road.",
#:   "I get it, drivers don't look for us. But this isn't about me on my bicycle; it's about the robotaxi I was behind. A people carrier had its hazards on by the deli. They went off, the gap between it and the kerb got wider, and the robotaxi had to ease back since there was now someone driving ahead of it.",
#:   "What became of the ambulance? It had left by the time you asked, Sir. When I came up it still had two wheels in the gutter and nobody seemed to be in it. A puff of smoke, and it was over in my lane. I followed its back doors, number 41, all the way to the hospital.",
#:   "She had waited her entire life, so it felt, for somebody to give up a space on Rue Daguerre. And there one was: a saloon was letting go of the kerb, just in front of her, and slipping into the stream, her stream. It drove on without hurry. She did not take the space; she had been too busy braking.",
#:   "V2 was legally parked at the east curb. As V1 came within about sixty feet, V2's left signal was activated and V2 moved into the through lane. It continued north at 22 mph. V1 slowed from 30 mph, adopted V2's pace, and reported the event as a close entry. Neither vehicle stopped at any time.",
#:   "The ghost of my mother-in-law sits in that passenger seat and says \"he's going to go.\" And he went. There were some twenty still cars along the pavement, I'd have sworn to all of them. One, a hatchback, stopped being still, put itself where I'd have been in two seconds, and then simply became traffic.",
#:   "Fleet memo on departures from stops. Our coach left the bay, entered the running lane and carried on with its service, none of which is contrary to rule. The complaint is about timing: the following test vehicle had to shed some 20 km/h in order not to be nearer than it liked to a coach that was only building up speed.",
#:   "On the tape you see him check his hair in the glass and not the road. Then his indicator, one blink. Then it's tail lights where a moment ago there was bare asphalt, ours, and a gap at the pavement in the shape of a Golf. We roll along after him for three streets before our ways part.",
#:   "We don't take this thing for an obstacle, that is the mistake. If you see wheels beginning to creep at the kerb, you must imagine them where they'll be in three seconds: in front, in your lane, and going your way. This fire engine crept, this fire engine came over, and we spent the next mile behind it.",
#:   "In my country one gives first horn, then one goes. The tempo driver has given neither horn nor hand. He was halted at the side, near the tea shop, and when I have come he has come also, in my own lane; afterwards he's driving very peacefully in front of me with his music on.",
#:   "I suppose it's a compliment to the electric kind that you can't hear them leave. There was no engine, no door. It is just that the parked car I was about to pass couldn't be passed any more: it had drifted from the gutter to the middle of my lane, and it was trundling off at the speed of the rest of us.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: leaving a parked position; own code"
#: [slots]
#: actions = ["pull-out"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(12, 30)
param OPT_ADV_SPEED = Range(4, 7.5)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
