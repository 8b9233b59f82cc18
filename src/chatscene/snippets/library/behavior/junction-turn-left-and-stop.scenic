#: description = "The car turns left across the ego's way and stops in the intersection."
#: rephrasings = [
#:   "A vehicle swings left through the junction and comes to a halt before the ego.",
#:   "The adversary makes a left turn and then stands still, causing a near collision.",
#:   "The other driver turns to the left in front of the ego and freezes.",
#:   "Turning left, the car stalls in the middle of the crossroads.",
#:   "The left-turning vehicle stops short and blocks the ego.",
#:   "he swings left in front of us and then just stops there",
#:   "Vehicle 2 turned left and came to rest in the path of Vehicle 1.",
#:   "left turn, then standstill across our lane",
#:   "he hung a left right across my bows and then stopped slap in the middle of the crossroads",
#:   "V2 made a left turn across V1's path and stopped within the intersection, blocking it.",
#:   "Truck L turn over our path, halts in mid-jct.",
#:   "The target turns left across the VUT's trajectory and comes to rest before completing the turn.",
#:   "The car wants to go left, crosses my way, and then does not go on, it stays in the crossing.",
#:   "Left-turner stops halfway through its turn, in the SUT's way; should remain there till the end.",
#:   "The coach had begun to swing left before them and then, turn half done, it stopped and barred the way.",
#:   "He's going left over you, and, oh dear, he's not clearing, he's pulled up halfway round in your path.",
#:   "guy turned left across us then froze halfway thru the turn",
#:   "A removal lorry embarked on a left turn before oncoming shoppers and got no further than the middle",
#:   "You commenced a left turn before my client's car and then abandoned it in mid-junction, did you not?",
#:   "He take left turn in front of us then stop halfway, whole junction choke",
#:   "Cuts left over my front and gives up halfway round, sat there like a lemon",
#:   "Left-turn conflict with standstill of the turning vehicle inside the intersection",
#:   "Bus turns left ACROSS me... and never finishes the turn",
#:   "The motorcycle peeled left over our path and then petrified mid-turn.",
#:   "Turns left over our path, then sits tight inside the junction.",
#:   "Scooter goes left ahead of us, halts mid-bend, stays.",
#:   "Articulated lorry: left turn begun, never completed, stuck across us.",
#:   "I want a van to turn left before us and stand there.",
#:   "LEFT TURN FAIL: bus comes round, stops dead on the junction",
#:   "The black saloon took the left turn right through where I was going and then, for whatever reason, came to rest in the centre of the crossroads.",
#:   "Vehicle 2 initiated a left turn across the trajectory of the AV, braked part-way through the manoeuvre and was stationary within the intersection at the end.",
#:   "In the middle of going left the coach driver must have seen a pedestrian in the side road, for he braked and stood still over our lane.",
#:   "Before our car turned a motorcycle to the left, and in the middle of the crossing it remained standing, so that I had not any place.",
#:   "We could not get through the junction, as a taxi that was bending round to the left in front of us had given up moving altogether.",
#:   "He puts his wheel over to the left, he's coming over in front of you, and he's stopped, he isn't going to clear; stay back!",
#:   "I had a green light and was about to go across. A people carrier swept to the left through my line of travel, and I expected it to be gone in a second. Instead it braked and planted itself in the junction, side-on to me, and remained.",
#:   "Our insured states that the other party's lorry made a left-hand turn in the intersection ahead of him. It failed to carry the turn through to the end but halted with the cab pointing into the side street and the body closing off the insured's lane.",
#:   "For the junction suite: the adversary waits, then starts a left turn that takes it across the path of the vehicle under test. On that path it brakes until stationary and never moves off again. The test checks that we stop before it and do not expect it to clear.",
#:   "The tram stop was full of people and I reckon that's why the hatchback couldn't get out of the junction. She'd swung left across us all right, but then she ran out of road to turn into, hit the brake and was marooned in the middle.",
#:   "Well, I am eighty-one and I have never seen such driving. The young fellow turns to the left under our very noses, and when he is half round he pulls up, folds his arms, and there his motor car stands in the crossing like a monument.",
#:   "Left-hander over our bows, aborted halfway, vehicle now an island.",
#:   "Swung leftward into our way and got no further, the crossroads blocked.",
#:   "Arcing left ahead of us, the minibus digs its heels in mid-box.",
#:   "I'd have cleared the crossroads easily if the removal van, going left ahead of me, hadn't pulled up with its turn half made.",
#:   "Adversary: left turn through the ego's path, brake application before completion, final speed zero inside the junction area, heading change about fifty degrees.",
#:   "The bike was supposed to bend round to the left and be gone; instead it stood slantwise in the junction with our lane underneath it.",
#:   "Kindly note that the bus was taking left turn across my front side and in the centre only he applied brake and became a statue.",
#:   "Could we get a pickup that begins a left turn over the AV's route through the crossroads and then comes to a permanent halt on it?",
#:   "What good is a left turn if you only do the first half, plonk yourself before my bumper and leave the thing there?",
#:   "The approach was clear and I had no reason to slow. A lorry then started to wheel leftward in the intersection, and its trailer drew itself across in front of me like a curtain. I waited for the curtain to pass. It didn't, because he'd put his brakes on, and there it hung.",
#:   "Statement of the cyclist who was riding beside V1: the saloon was curving to the left through the crossroads, cutting off both of us. A pushchair was on the zebra in the side street. The saloon therefore stopped where it was, pointing half left, and was standing there when I got off my bike.",
#:   "Something had the junction by the throat. It was a coach, at an angle, with its left indicator going and its wheels on full lock, and it wasn't moving a hair. It must have been on its way round when it got stuck for space; at any rate our road led straight into its side windows.",
#:   "Listen to what she's asking for: the actor isn't allowed to finish. It takes the left turn so that it sweeps over the lane of the test vehicle, and in the midst of that sweep it brakes to zero. There it remains, inside the intersection, until the clock runs out.",
#:   "He took the left-hander like a man who has done it a thousand times, one palm on the wheel. Halfway about, with the van's flank right before us, the thousand and first went wrong: a dog, a bollard, I couldn't see. The van stopped on the stones of the crossing and did not stir again.",
#:   "Lads, new clip: you see the Vauxhall's wheels go over to the left, it comes round through the junction across our bonnet, all normal. Now freeze it here, because the Vauxhall does. That is it. Thirty seconds of footage and the muppet's still parked across our lane mid-turn.",
#:   "The insured expected the third party's motorcycle to complete its leftward turn and so vacate the intersection. It failed to do so. Having intruded upon the insured's path it was brought to a stand, and the insured, who could go neither round it nor through it, had to brake to a halt.",
#:   "Alpha two, junction of Fifth and Main, you'll find a box truck there that won't be going anywhere. It was making a left in front of the caller and stopped dead with the turn half done, square in the caller's path. No collision. Caller says the driver's just sitting behind the wheel.",
#:   "When you cross here, count the indicators. Orange on the left, so that car's going to bend round over your path, and you give it a second. But its back end has dipped and its wheels have stopped in the junction, so there'll be no gap behind it, the way's plugged. You stop too.",
#:   "As a German I wait until I can leave the crossing. The lady in the Opel has not learned this. She drove to the left, directly over my way, and in the curve she saw that her street was full; so she stood, in the middle, with her car before mine, and she stood long.",
#:   "What came of it was that Auntie missed her train. A big lorry wanted to go left, and it was going left past our noses, and then it had a rest in the very middle of the crossroads. Our car had to stop because where we wanted to be was lorry.",
#:   "Left-hander over our path, never finished: van's a roadblock.",
#:   "Wheels hard left, no longer turning, and we've nowhere to go.",
#:   "Sharp left before us, brakes on, remained there. Junction ours no more.",
#:   "The taxi got round as far as north-west, as it were, crossing our way leftward, and north-west is how it stayed.",
#:   "I waited for the end of his left turn like you wait for a bus on Sunday; it is still not come, and he still stands there.",
#:   "Halfway through bending left over our line the coach dipped, shuddered and became part of the crossroads, with our nose a yard off its belly.",
#:   "The indicator went tick, tick, tick, the motorbike leant over left across us, stood up, put its stand down, and the indicator goes on ticking.",
#:   "Please make a pickup that swings left ahead of the robotaxi and, once squarely in the robotaxi's way within the intersection, goes dead for good.",
#:   "There were two witnesses to the left turn and none to its completion, for it was never completed; the defendant's lorry had halted athwart my client's lane.",
#:   "You can draw it for yourself. Put our car at the bottom going up, and draw a hook that comes over our way and bends to the left. Now rub out the last half of the hook. Where you've stopped rubbing, that's the bus, and that's where it was when the tow truck came for us both.",
#:   "Our light was fine and our lane was fine and I had my eye on the far side, where my sister was standing. She got smaller and smaller at the edges, it seemed. It was a horsebox, coming round to its left between us, and when the gap with my sister in it had closed entirely the horsebox put its brakes on.",
#:   "You're allowed to be slow in a left turn, and you're allowed to be quick. What this gentleman's done is neither. He's taken his minibus round to the left as far as the front of your bonnet, and he's put the brake on, and he's getting out. So that's your journey finished for now. Handbrake.",
#:   "The steering angle of the target is 28 degrees left when it passes before the ego, and stays at 28 degrees for the remainder of the test, for the target has by then braked to a stop in the intersection. It's neither pulled back nor driven on. The ego's reference path runs through its rear axle.",
#:   "My pizza boy's moped, I'd know it anywhere. I'm coming up to the crossroads and he's banking to the left in front of me with the box on the back, and the box slides and he panics and stops. He's there with his arms round the box, in the junction, in my road, and he won't move till somebody takes it from him.",
#:   "Squeak, went something; that was his brake shoes. I'd looked down for my glasses, you see. When I looked up there was a flatbed across our way, canted to the left like a ship on a sandbank, every wheel at rest. It must have come round while I was looking for the glasses. It was there all afternoon.",
#:   "Air brake hiss, trailer swing, and then the trailer ought to swing on by, that's what trailers do. I watched its rear axle come up to my lane on its way round to the left. I watched it come into my lane. I'm still watching it, pal. He's met a parked car in the side road and he can't get his tail out.",
#:   "Vehicle 1 was in the intersection's approach when a delivery truck initiated a turn to its left, from which it would normally have cleared within three seconds. At three seconds it was stationary across Vehicle 1's path. At ten, the same. The operator said that his load had shifted and he had dared not go on.",
#:   "The fog let them have the crossroads in small pieces. First they had a lamp, amber, winking on the left of something. Next they had the something, a grey flank that wheeled leftward over the road before them. There was a gasp of brakes, and the flank ceased to wheel, and from then on the fog would let them have nothing else.",
#:   "I'm a cyclist, I filter, I thought I would nip behind her as she went round. So I aimed for where her tail was going to be gone from. It never was gone, since the car had quit in the middle of its left turn with the wheels still cocked, and the AV on my right and I both ended up stopped at the same door.",
#:   "They say that she had missed her street. It's the left one she took, over the front of the police jeep, and in the midst of the curve she has seen the sign \"no entry\". What does the good woman? She stands on the brake and remains so, in the crossing, over our lane, and looks at us with big eyes.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["acrossMeeting", "advMeeting", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-left", "stop"]
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 4.0
#: high = 7.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(4, 30)
param OPT_ADV_SPEED = Range(4, 9)
param OPT_STOP_DISTANCE = Range(4, 7.5)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 8 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
