#: description = "The truck ahead breaks down, limps toward the edge of the road and stands half in the lane."
#: rephrasings = [
#:   "The lorry in front of us packs up, limps over to the side and still sticks out into our lane.",
#:   "Vehicle 2 suffered a defect, moved to the edge and came to rest partly within the travel lane.",
#:   "Lead disabled: drifts right, stops, partially obstructing.",
#:   "The target reduces speed, shifts laterally toward the road edge and stands overlapping the path of the VUT.",
#:   "The truck has a panne, goes to the right side but not enough space, it stays half on our lane.",
#:   "The coach ahead dies and only just reaches the verge with its tail still in the road.",
#:   "A car before us pulls over with the hazards on, not quite clear of the lane.",
#:   "The van we follow gives out and wallows to the margin, leaving us half a lane.",
#:   "the lorry in front packed up, hobbled towards the verge and was left with its backside sticking out into my lane",
#:   "The truck preceding V1 became disabled, moved toward the shoulder and came to rest partially in the travel lane.",
#:   "Bus ahead: mech. failure, limps R, stops half on rd.",
#:   "The lead vehicle loses speed, steers toward the carriageway edge and stands with partial overlap of the VUT's lane.",
#:   "The car in front is broken, he goes slowly to the side and stays, but half is still in my lane.",
#:   "Lead has a simulated failure: decel, drift to roadside, v=0 at ~50 % lane overlap.",
#:   "The ambulance before them faltered, dragged itself to the roadside like a wounded beast, and stopped there, half on the road.",
#:   "He's got a breakdown, he's nursing it to the side, hasn't got it all the way off; you'll have half a lane to play with.",
#:   "truck in front died and sort of dragged itself to the side but its butt is still in our lane",
#:   "A stricken bus hobbled to the roadside yet left half its bulk in the carriageway",
#:   "Your vehicle having failed, you steered it for the edge but it did not clear the lane, did it?",
#:   "Lorry in front spoil already, slowly go to side but half body still blocking",
#:   "His engine's gone, he's nursing it to the gutter, and there he's stuck with his backside out in my road",
#:   "Disabled lead vehicle partly clear of the lane; residual lane obstruction at the road edge",
#:   "Van in front BREAKS DOWN, only makes it halfway off the road",
#:   "The ambulance ahead faltered, hobbled kerbward and stranded itself half in.",
#:   "Van ahead conks out, crawls sideways, stops half off the road.",
#:   "Leading bus fails; ends up stranded partly in our lane.",
#:   "lorry infront dies edges to the verge its rear still out",
#:   "CASUALTY VEHICLE ahead, drifted nearside, standing, half a lane gone",
#:   "The fire engine before us broke down halfway onto the shoulder.",
#:   "Smoke came out of the coach we were following, it got slower, leaned over to the roadside and stopped with half of it still on the driving lane.",
#:   "Give the car in front of the AV an engine failure: it loses pace, bears off toward the edge and stands there, partly in the lane.",
#:   "He only just made it to the gutter before the motor quit altogether, and even so his right-hand wheels were left standing in front of me.",
#:   "The lead vehicle, simulating a defect, decelerates, displaces itself laterally to the border of the road and comes to rest obstructing part of the lane.",
#:   "Because her car was giving up ahead of us, she let it roll over to the side, where it stood too early, half in our way.",
#:   "The truck before my car has got some fault, gently it is going to the side, then standing, half on the earth and half on the road.",
#:   "I'd been behind the removal lorry since the roundabout when its hazards came on. It lost speed little by little while he eased it over to the nearside, and when it finally stopped there was a good metre of it hanging out over my lane.",
#:   "V2, directly ahead of V1, experienced an apparent mechanical failure. Its operator let the vehicle decelerate while steering to the outer edge of the roadway, where it came to final rest with its left half remaining in the travel lane and no warning triangle displayed.",
#:   "You'll see him run out of puff in a moment, the school bus in front. There: no power, so he's guiding it over to the edge as best he can. He won't get it right off the road, though, it has stopped with its flank in our lane.",
#:   "We were on the way to the seaside, and the car in front of us made a funny noise and went slower and slower. It went over to the grass, but only a bit of it fitted on the grass and the rest stayed on our road.",
#:   "Request for the hazard set: the vehicle we follow loses drive. It must not simply stop in the lane, but has to use its remaining momentum to veer to the roadside, and there stand for good, leaving perhaps half the lane for the test vehicle.",
#:   "Hazards, smoke, sideways drift: leader expired half on the hard strip.",
#:   "The tanker leading us sickened, sidled kerbward, died straddling the edge line.",
#:   "Coach ahead lost heart, sought the verge, parked only half its bulk there.",
#:   "My lead car had no more power in it; it sank toward the edge of the road and finished up leaving me half a lane.",
#:   "The preceding vehicle sheds speed following a simulated fault, migrates toward the road boundary and ends stationary with part of its width inside the ego lane.",
#:   "Did the lorry ahead manage to get off the road when its engine failed? Only by half, officer, the remainder stayed on the tarmac.",
#:   "Front bus has become breakdown, somehow driver is taking it to left-out side slowly, but back half is remaining on our road only.",
#:   "Let the fire engine we're behind conk out, hobble over to the edge of the carriageway and stay put with its flank projecting.",
#:   "She nearly got the Mini off the road when it packed up in front of us, nearly being the word, for half of it stayed out.",
#:   "I smelt it before I saw it, that hot clutch stink. The horsebox in front began to lag, though we were on the flat, and crept across to the nearside with its hazards blinking. It had run out of road speed before it had run out of road, and stood there half on, half off.",
#:   "Grass on one side of him, our lane on the other, and the wreck sat astride the line between. He'd been leading us quite nicely until something let go under the bonnet. What way he had left he'd used to coax the pickup to the margin, and it was a yard too little.",
#:   "V2 was immediately ahead of V1 when its operator noted a loss of oil pressure. He allowed speed to decay and steered for the outer edge of the roadway. V2 came to final rest encroaching on V1's lane by approximately 1.2 metres, and no attempt was made to move it further.",
#:   "The radio told it as a delay of ten minutes on the ring road. What we had was a school bus, poorly, forty yards in front. It grew slower, tended more and more to the kerb, bumped one wheel up, and gave its last with the other three on our side of things.",
#:   "Here's a thing they don't put in the handbook. When the one in front begins to fade and wander to the side, don't assume it will tuck itself away. That's as far as he's going to get, poor fellow, with his offside hanging out in your lane, so you've half a lane's width to work with.",
#:   "I'd be grateful for a lead vehicle with a sick engine. It mustn't just halt in our path; I want to see it bleed off speed, veer towards the roadside with the last of its way, and come up short, so that it lies there for good as a half-width obstacle.",
#:   "From the passenger seat I could see the kerb stones vanish one after the other under the ambulance ahead. It hadn't the strength for the rest. There was a cough, a shudder of the rear doors, and it was finished, two wheels in the gutter and two in what was supposed to be our lane.",
#:   "We had slowed already since the gap was melting and no brake lights explained it. The truck was evidently ill. Its tail moved to the right, little by little, until we could see past its left-hand corner; and at that it stuck, neither out of our way nor altogether in it.",
#:   "Papa's friend has an old car, and it was in front of ours because we were all going to the lake. It made a bang and it didn't want to any more. It rolled slower to where the ditch is, and there it stayed with its bottom still on the street.",
#:   "Sorry I'm late, chief. Artic in front of me lost all his air or his drive or whatever, and I watched him shrink from fifty to a crawl. He pointed her at the hard standing and didn't make it. Trailer's still stuck out across half of the lane, I squeezed by with the mirrors folded.",
#:   "The engine of the bus is broken, this we could hear, as it was loud before us and then no more loud. The chauffeur has guided it with the rest of the swing to the side of the street. But the swing was not enough, so the bus stands half in my lane today still.",
#:   "Ahead: smoke, crawl, sidle rightward, dead. Half our lane's gone.",
#:   "fire engine we were following conked out, only half made the verge",
#:   "Leader expires at the margin, two wheels on our side still.",
#:   "The bus we were behind lost its breath, leaned for the gutter, and ran out of way with one shoulder in our lane.",
#:   "Only the right-hand pair of its wheels found the grass before the van leading us gave out; the left-hand pair is what you'll be steering round.",
#:   "Ahead of V1 the truck shed speed without braking, migrated to the outer edge, and came to final rest with 50 percent of its width encroaching.",
#:   "She is sick, my truck in front, she coughs, she goes slow to the border, and there she remains, one half on grass and one half for me.",
#:   "When it gave up, the ambulance ahead had got itself just so far over that an optimist could have squeezed by on the left.",
#:   "Let the leading lorry suffer a power loss, bleed off its speed, steer shyly for the shoulder and finish up neither in the lane nor out of it.",
#:   "First the smell of hot oil came in through the vents, and I told the wife it wasn't ours. It was the coach's. We came up on it though I hadn't touched the pedal; its corner drew aside, inch by inch, toward the ditch, and gave us a sliver of view. The sliver never got any wider, as it had died there.",
#:   "It's the last metre that costs the money, said the recovery man. He meant that a dying lorry will nearly always reach the edge of the road but hardly ever get over it. The one in front of us hadn't. It had wilted up the rise, bent its course to the kerb, and now it hung its left side in our lane.",
#:   "You'll see we've got a bit of room on the left and none on the right. Where the room's gone, that's his tail. He'd been in front of you right along, hadn't he, then his engine went and he tried to nurse her off the road. He has got her off by half. Mirror, and squeeze round when it's clear.",
#:   "Nobody had braked, yet we were four lengths nearer to the tanker we had been trailing, then two. Steam rose over the cab. Its nearside wheels left the tarmac and sent up gravel, which was a hopeful sign, and then the gravel stopped, the wheels stopped, and the remaining half of it was ours to deal with.",
#:   "Test of partial obstruction caused by a failing lead. The lead vehicle, followed at constant gap, loses speed; simultaneously its lateral offset drifts toward the right-hand road edge. Both come to an end together, at zero speed and an overlap of about half a lane width. It stays thus. The ego may pass or stop.",
#:   "There was a bang inside of it and the lights went out, all the back ones, so I only had its shape to go by. The shape came nearer and at the same time moved off to the right. I thought good, it's out of the way. My nearside mirror found out that it wasn't, not altogether, and the shape was quite still.",
#:   "Recovery wanted, A9, northbound, one pickup and horse trailer. Caller was following it when it lost all drive and went grinding along slower and slower. Driver's done his best and made for the edge, but the trailer's offside wheels and most of the pony are standing in the running lane. Caller's stopped behind with his flashers on.",
#:   "Every cyclist knows how wide a lane is to the inch, and I can tell you this one ended up half as wide as it was. Old Land Rover, puffing along ahead of me and of the car I was behind. It puffed less, it veered for the nettles as though looking for somewhere soft to lie down, and lay down too soon.",
#:   "Grass cuttings on the right wheel arch, dust of the road on the left: you could see from the wreck how it had spent the night. At dusk it had been going along in front of Hansen's cart. It had failed by degrees, crept sideways in search of the verge, and never brought more than one flank of itself to safety.",
#:   "The engineer's log has it that propulsion of the lead bus was cut at 31.0 s and right-hand steering applied at 31.5 s. The bus didn't manage to clear the carriageway. Final overlap with the following car's path 1.1 metres, speed nil. The following car came to rest four metres behind it, considering whether the remaining width would do.",
#:   "Half a van's no good to a man who wants to get home. We'd trundled after it from the plant gate, and it packed in somewhere past the bridge; you could tell since he'd got his arm out, waving us down. He coaxed her over to the side of the road. Got the one half over. Other half was still ours.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "swerve", "stop"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.17
#: high = 0.24
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.1
#: high = 1.8
#: unit = "m"
#: meaning = "how far to the right of its line it comes to stand"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_BRAKE = Range(0.17, 0.24)
param OPT_SWERVE = Range(1.1, 1.8)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE, -globalParameters.OPT_SWERVE)
