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
