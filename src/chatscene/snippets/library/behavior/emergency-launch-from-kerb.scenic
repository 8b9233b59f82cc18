#: description = "The emergency vehicle standing at the kerb launches into the ego's lane and races off."
#: rephrasings = [
#:   "The parked ambulance fires up its siren and shoots out before us.",
#:   "The emergency unit departed the curb at full acceleration to respond to a call.",
#:   "Parked EMS goes code 3, pulls out, gone.",
#:   "The emergency vehicle leaves the roadside at maximum acceleration ahead of the VUT and continues at high speed.",
#:   "The police car was standing and suddenly starts with the blue light, very fast.",
#:   "A fire engine erupts from its bay and thunders up the road.",
#:   "Paramedics jump in, doors slam, and the van leaps into our lane.",
#:   "Speed trap over: the patrol car bounds off the roadside in pursuit.",
#:   "an ambulance sat at the side of the road and then shot out in front of me like a scalded cat",
#:   "Marked patrol unit, stopped along the curb, accelerated hard into the travel lane ahead of V1 and left at high speed.",
#:   "Fire eng. stationary roadside -> blasts out into our lane, off at full pelt.",
#:   "A stationary emergency vehicle at the kerbside enters the VUT's lane under full acceleration and departs at high speed.",
#:   "The police car is parking, and in one second he starts in my lane and goes away very fast.",
#:   "Blue-light vehicle spawns at the roadside, v=0; on trigger floor it into the ego lane and go, no pause after.",
#:   "They had just come level when the fire truck roared off its parking spot, swept out before them and was away down the street.",
#:   "Unit 12 is rolling, he's gone from the side of the road like a rocket, straight into the traffic lane, mind the car behind him.",
#:   "the parked ambulance just went 0-100 out into our lane lmaooo",
#:   "A fire crew burst from its roadside berth ahead of traffic and sped off to a blaze",
#:   "The police vehicle was at rest beside the pavement, and then it was in your lane and tearing away, is that so?",
#:   "The ambulance parked at the side suddenly chiong out in front, siren all, fly off already",
#:   "Copper's parked up with his sandwiches, next thing he's out under my nose and gone like the clappers",
#:   "Abrupt high-acceleration departure of stationary emergency vehicle from the roadside into own lane",
#:   "Parked POLICE CAR blasts off right in front of me",
#:   "The ambulance catapulted off the kerb into our lane and away.",
#:   "Kerbside fire tender bursts into our lane and is off at speed.",
#:   "Ambulance, stationary at roadside, full power into ego lane, rapidly away.",
#:   "Das Polizeiauto stands on the border, then shoots in my lane, racing away.",
#:   "Parked cop car slingshots into my lane and he's GONE",
#:   "Let a police van waiting by the pavement take off flat out along our lane.",
#:   "The ambulance crew had been idling by the kerb; on the alarm they lunged into the traffic lane ahead of the robotaxi and hurtled off.",
#:   "Attention all units, car 7 has left the kerb hard, he's in the running lane in front of a civilian and going up through the gears.",
#:   "A fire appliance that had been stood outside the school came off the edge of the road with everything it had and went haring down our lane.",
#:   "The stationary police vehicle departs the kerb under full throttle, occupies the VUT's lane and draws away from the VUT at high speed.",
#:   "There was a big red fire engine sleeping by the pavement, and then it woke up and jumped in front of us and went whoosh all the way down.",
#:   "What does the AV do if an ambulance at rest along the kerb suddenly enters its lane with maximum acceleration and goes speeding off down it?",
#:   "I noticed the traffic officer's car only because it stood half under a tree at the side. Before I had drawn level it was in my lane, wheels spinning, and it went away from me so fast that I could hardly see which way it had gone.",
#:   "At 14:06 the emergency vehicle was stationary next to the kerb. Upon receipt of a call its driver entered the lane of the approaching Vehicle 1 at full acceleration and continued along it at a speed considerably above that of the surrounding traffic.",
#:   "They always park up by the kebab shop, the ambulance lot, having their tea. I'm trundling along with twelve tonnes on, the blues come on, and it's straight off the kerb into my lane with its foot hard down and away up the hill like a jet.",
#:   "Nothing about the police car by the kerb suggested haste; its driver seemed to be asleep. Then the tyres shrieked, it hurled itself into the lane in front of her, and its tail lamps shrank down the avenue quicker than she would have believed possible.",
#:   "Ticket 481: actor = fire truck, initial state parked at the kerb on the ego's side. Trigger when the ego is close: steer into the ego's lane, throttle at 100 %, no slowing afterwards, let it run up to its top speed and vanish ahead.",
#:   "Parked fire appliance, sirens, bang, into our lane and gone.",
#:   "Police car off the kerb, foot down, lane's his, vanishing.",
#:   "Stationary ambulance bursts from the roadside and rockets off ahead.",
#:   "With a howl of sirens the ambulance sprang from its place along the pavement into the lane before our noses and was soon a speck.",
#:   "there was a cop hiding by the side of the road and when the call came he launched right into our lane and was doing like 90 in seconds",
#:   "Emergency target at rest on the kerb strip; upon trigger, entry into the VUT's lane with full drive torque, subsequent travel at high velocity.",
#:   "Watch that fire engine standing at the side, crew's aboard, there he goes, out into your lane with everything he's got, let him streak away.",
#:   "In the front of me the ambulance was standing at the footpath, he took the lane in one jump and went like a bullet.",
#:   "Give me a patrol car waiting at the kerb that blasts into the ego's lane on full power and goes on getting faster down the street.",
#:   "I'd just turned to my passenger and said how quiet it was. A fire engine that had been parked outside the flats with its doors open had its doors shut, was in the lane ahead of us, and was doing twice our speed up the hill before I had finished the sentence.",
#:   "The gravel on my windscreen is from the police car. It had been lying up by the kerb near the layby sign, quite still. Something came over its radio, evidently, for it spun its wheels out into my lane, showered me, and was so far away so fast that I couldn't give you the number.",
#:   "Control from Sierra Two, we're moving. We've been on plot at the kerbside and we have gone straight out into the running lane ahead of a blue hatchback, apologies to him. Flat to the boards northbound, passing seventy and building.",
#:   "V2, a marked fire department unit, was stationary along the east curb with its crew on board. Immediately in advance of V1 it entered the travel lane under wide-open throttle. Event data show V2 reaching 62 mph within the same block; V1 braked and lost a hubcap against the opposite curb.",
#:   "They never got their chips. Two paramedics were walking back to the van, which stood with two wheels in the gutter, when one of them started running. I got over a bit, but before I was over it was out in front of my taxi, blues going, and hammering off down the lane as if it were the only vehicle in town.",
#:   "Where there'd been a stripy van beside the pavement there was a puddle, and where there'd been free lane ahead of me there was the stripy van. You never heard such an engine. I looked down to find third gear and when I looked up it was passing the church, half a mile on.",
#:   "My grandson adores them, so I'd slowed down for him to see the fire engine at the side of the road. Well, he saw it all right. It came away from there and into our lane like a cork from a bottle, and then it went hurtling on in front of us, and he clapped until it was out of sight.",
#:   "Subject: lead vehicle with extreme positive acceleration. An ambulance with zero speed at the roadside merges into our lane thirty metres ahead and never presents a closing hazard after the first second, since it continues under full power to its maximum. Verify that the ego yields for the merge and doesn't give chase.",
#:   "I've cycled past that ambulance a hundred times, it's always by the kerb with the crew asleep. Not Tuesday. One squawk from the radio and it flung itself into the lane, the car in front of me had to stand on its nose, and you could hear it going up through the gears all the way to the ring road.",
#:   "Only afterwards did he understand the sequence. The officers had been eating at the roadside with the engine off; a coffee cup had come flying from the window; then the nose of the car was in his lane, tyres smoking, and the whole thing was drawing away from him at a speed that seemed indecent between houses.",
#:   "We were driving normal, 40, and the Polizei was parked on the border of the street. At once he starts, he jumps in our lane with screaming tyres, full gas. Until I had braked he was already by the next traffic light, he must have had more than 100.",
#:   "Kerb, blue lights, our lane, horizon.",
#:   "Resting fire tender rips into our lane and streaks off.",
#:   "Police car stops being parked; our lane's his, at ninety.",
#:   "The kerb had an ambulance on it, next my lane had an ambulance in it with everything howling, and next the lane was empty as far as the church.",
#:   "Actor state: parked, kerb side, zero speed. On trigger, steer into ego lane with throttle 1.0 and leave it at 1.0 until the set maximum is reached.",
#:   "sheriff was half asleep at the curb i swear, then he's sideways into my lane, rear tires lit up, and doing a hundred before i'd even braked",
#:   "You braked for a fire engine that you'd taken for street furniture; it left the roadside under your nose like a sprinter and needs no more room from you now.",
#:   "That police jeep was taking rest at footpath side, one call came, and like rocket he entered in my lane and like rocket only he continued.",
#:   "Witness recalls the parked ambulance's lights coming on, then \"a wall of yellow\" crossing into the taxi's lane, then, almost immediately, its siren from the far end of the street.",
#:   "All that remains of it is two black commas at the edge of the road and a smell. The patrol car that had been standing on them was out in our lane before I could finish saying that it was there. I braked, of course, but I might as well not have, because it went from us so quickly that the gap was safe before my foot was down.",
#:   "I deliver to the fire station and they do it in drill too, but there they open the doors first. This tender was out in the road, along the kerb, hose rolled up, men in their seats. There's a bell. My whole lane is tender, broadside, then tail, then a red dot going at motorway speed between the shops, and I'm on the brakes with my wipers going.",
#:   "Range 25 m, track \"parked, emergency, kerb\". Range 18 m, the same track is moving, its heading cuts into our lane. Range 19, 24, 35, 60 m, dead ahead, accelerating at the limit of what such a mass can do, until it's dropped at 120 m. Please stop the planner from treating the first value as the one that matters.",
#:   "The lollipop lady had words with their sergeant. Her children were all safe on the pavement, but the lady in the Micra, coming along at twenty, was not in the least prepared. That van had been stood by the school wall, and it exploded into the Micra's lane and went shrieking off down it without once letting up, and the Micra stalled.",
#:   "Somebody threw down a cigarette. That was the only warning one had, because it came out of the window of an unlit police car which lay along the kerb with its engine off. The cigarette was still rolling when my headlamps showed me a rear bumper in my lane, squirming with power, and it was still glowing when I'd lost sight of that bumper altogether.",
#:   "Control, Romeo Nine, for your log. We were static at the kerb on Dock Street when your job dropped. Went out hot into lane, cut it fine in front of a people carrier, he's stood it on its nose, no contact. We're now at the ring road, seventy-plus and still climbing, over.",
#:   "I'd been told ambulances were to be treated like elephants at the roadside, they don't move unless they mean it. This one meant it. The side of the road went bare, my lane went yellow and green, and for a moment I had a lovely view of two back doors; they were at the top of the hill before I'd stopped shaking.",
#:   "The doctor asks, why are you having this pain in the neck. I tell him: because of one fire brigade vehicle. Quietly he was standing by the side, I am coming, and without waiting for me he took my lane with all his horsepower. I had to brake like anything, and for what, in five seconds he was at the next village.",
#:   "They keep a Volvo by the kerb outside the courthouse, for looks, we always said. Its looks altered. It squatted on its haunches, swung its snout into the stream right ahead of the mayor's car, and was off along the lane at a rate that left its own siren to catch up, and the mayor's hat lay on the dashboard.",
#:   "Claim 4471, whiplash. Claimant says she was approaching a stationary ambulance parked at the nearside when it \"leapt\" into her lane. She made an emergency stop. Dashcam confirms: wheelspin from rest at 00:03, fully in her lane at 00:05, and by 00:09 too far off down it, at an estimated 60 mph, for its registration to be legible.",
#:   "There was no traffic in front of her, and she'd counted on there being none. She had not counted the thing along the pavement, white with a blue stripe, in which two men were unwrapping rolls. It reared out before her with a scream of rubber, rolls and all, and the street, which is long, wasn't long enough to show her where it stopped getting faster.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "accelerate", "fast"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 13.0
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(8, 22)
param OPT_ADV_SPEED = Range(13, 17)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do ThrottleOnPath(ownLane(egoRoute), 1, 0, globalParameters.OPT_ADV_SPEED)
