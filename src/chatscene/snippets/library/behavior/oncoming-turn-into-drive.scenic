#: description = "The oncoming car turns left across the ego's lane into a driveway."
#: rephrasings = [
#:   "he cuts left across us into his drive",
#:   "Vehicle 2, oncoming, turned left across the lane of Vehicle 1 into a private driveway.",
#:   "opposing veh, left across us into a car park",
#:   "The oncoming target turns left across the path of the VUT to leave the carriageway.",
#:   "The van from the other direction turns left for entering in the petrol station.",
#:   "A cyclist coming the other way swings over our lane to reach a gateway.",
#:   "The bus opposite heads left through our way into the depot.",
#:   "A fire engine facing us makes for its station on our side, straight over our lane.",
#:   "The car coming towards me hung a left over my lane into somebody's driveway.",
#:   "The opposing vehicle turned left across Unit 1's lane to enter a private driveway.",
#:   "Opp. car L-turn thru ego lane -> driveway.",
#:   "The oncoming target turns left across the VUT's lane to access a property entrance.",
#:   "The car against me turns left over my lane to go in a house entrance.",
#:   "Mid-block left across our lane into a drive, no junction; gap acceptance by the oncoming actor is poor.",
#:   "He was home at last, it seemed, for he swung over in front of her and in at his own gate.",
#:   "He's turning into that driveway on your side, he'll come across us, be ready to slow.",
#:   "car coming the other way turned left right over us into some house",
#:   "A resident arriving home turned left over the approaching lane to reach her drive, officers said.",
#:   "You were coming toward my client and you cut over her lane to the left to get to your premises?",
#:   "Opposite side van turned left across my lane and went inside one house gate.",
#:   "Can't wait to get his dinner, turns left over my lane onto his own front drive.",
#:   "Left-turn access movement of opposing vehicle to property across ego lane.",
#:   "NEIGHBOR CUTS ACROSS TRAFFIC TO GET INTO HIS DRIVEWAY",
#:   "The oncoming car ducked left over our lane into a driveway.",
#:   "Opposing coach peels off left over our lane, into the hotel entrance.",
#:   "Facing cyclist hooks left through us to reach his garage.",
#:   "Oncoming target exits road leftwards via VUT lane to private access.",
#:   "Did that lorry opposite just swing across you into the farmyard?",
#:   "Ambulance comes toward us, goes left, crosses our lane, hospital gate.",
#:   "Let the oncoming SUV leave the road to its left, over the lane of the ego, and disappear into the entrance of a property.",
#:   "Somebody going home for lunch, a saloon from the opposite direction, steered left over my half of the road and up onto his own forecourt.",
#:   "The motorbike came in front of us, then it bent to the left by our lane and entered to the yard of a house.",
#:   "V2 was approaching from the opposite direction and left the roadway via V1's lane, its driver intending to enter the premises of a builder's merchant.",
#:   "There goes the oncoming minibus, left across your bows without so much as a thank-you, and in through the school gates.",
#:   "A milk float was heading towards us and cut left, over our bit of the road, to get to the dairy's ramp.",
#:   "Mrs Pringle has lived opposite for thirty years and has never once waited. She comes up the street towards you in that yellow hatchback, and when she gets to number nine she sails off to the left, over your lane, and up her drive with time to spare.",
#:   "No junction and no signals are involved. The opposing vehicle, on reaching the trigger distance, makes a left turn at normal turning speed, so that it intersects the lane of the subject vehicle at a right angle, and it leaves the carriageway through a gateway.",
#:   "You can see the dropped kerb on our right in the clip, and that's where the pickup is headed. It's coming the other way, indicator off of course, and it wheels left in front of the robotaxi's bumper, bounces over the kerb and vanishes behind the hedge.",
#:   "I was taking my HGV through the village when the fire engine coming the other way turned in at its own station. Fair enough, only the station's on my side, so to get in there it had to go left over my lane, and it didn't wait.",
#:   "When I was asked where the courier had come from, I said from the front, from where we were going. He rode his moped at us, then leaned left, whizzed across our lane just before our car and shot up somebody's garden path to deliver a pizza.",
#:   "Opposing van dives left through our lane, up someone's ramp.",
#:   "Oncoming fire engine goes left over us into its yard.",
#:   "Facing moped, left across our bows, into the car wash.",
#:   "A lorry approaching us took a left clean through our lane because that was where the cash-and-carry had its entrance.",
#:   "He's been coming towards you, that bloke in the Jag, and he lives there, so over your lane to the left he goes and onto his gravel.",
#:   "Let an opposing bicycle leave the road to its left, by way of the ego's lane, and ride in at the gate of a farm.",
#:   "El autobús de enfrente, the bus in front I mean, it turns to its left by my lane and goes inside of the hotel parking.",
#:   "Unit 2, westbound, left the roadway through the eastbound lane, executing a left turn to gain access to a gas station.",
#:   "Who in their right mind swings left through oncoming me just to be first at the drive-through, without a junction for half a mile?",
#:   "Hydrangeas on either side of the gate, and between them the back end of a Peugeot, disappearing. That's all my dashboard camera got, as I was braking so hard. What it didn't get was the Peugeot coming up the other side, and the great swoop it made to its left, through my lane, to reach them.",
#:   "I know the ambulance crew's got a station to get home to. It happens that the station is on my side of Canal Road. So the ambulance comes along Canal Road the other way, no lights on, end of shift, and goes left into the yard, which takes it right over the lane that I'm using. It didn't wait for me.",
#:   "We pick two kinds of place for a left across oncoming traffic: a junction, and, as here, nothing at all. In mid-block the opposing saloon steers left, traverses the subject vehicle's lane within two seconds at its ordinary turning speed and is gone from the roadway by way of the dropped kerb of a private house.",
#:   "The postie on his moped has a round to do, and gates to get into. When he sees one he likes he has a way of simply dropping his left shoulder. I was coming the other way from him in the bread van; across my bit of road he went, shoulder first, and in at the vicarage.",
#:   "For the avoidance of doubt, the vehicles were not at an intersection. The insured was driving south. The third party, in a people carrier, was driving north, and intended to enter the nursery school on the insured's side. She thus turned to her left over the insured's lane, kept moving, and had her rear bumper clipped in the very gateway.",
#:   "Pop quiz, as we come down this street. Vehicle ahead, coming towards us, driver craning her neck at the house numbers. What will she do? She'll go left when she finds it, over us, and hang the consequences. And there she goes, thank you, right through our lane and into number forty.",
#:   "Every day at four the bus comes home to its depot. It doesn't come from behind us, it comes from the front. Then it makes its big left, and for a moment there's bus all over our side of the street, and then it's gone through the doors. Daddy always brakes. The robot car braked too.",
#:   "Heading of the opposing cyclist at t=0: 180 degrees to ours. At t=1.5 s: 90 degrees, and in our lane. At t=3: off the carriageway altogether, on the concrete of a driveway. There's no intersection in the HD map at that location, so the planner had not been told that a left turn might occur.",
#:   "After the bend the trees close in and people cut it fine, wanting their tea. I met a pickup there last night. It was on its own side until it wasn't: with me forty yards off, it took a slice through my lane to the left, mounted the verge and vanished up the track to Hill Farm.",
#:   "My uncle's petrol pump is in Nashik road. Customers from the opposite direction don't go till the U-turn. They take left from there only, over the lane of the coming people, directly to the pump. Today one tempo did the same before my car, he didn't even slow for me, and already he was asking for diesel.",
#:   "heard a clatter, looked up, and theres a guy with a mower on a trailer going broadside over my lane. hed been coming the other way on his side, all normal. just cranked it left for some driveway, didnt stop or anything, and the trailer bumped over the kerb after him. had me breaking like mad",
#:   "Opposing taxi, left over us, into the multi-storey.",
#:   "he lives on our side so over he swung, left, garage open, us braking",
#:   "Meeting us one moment, up the school drive the next.",
#:   "The gates on my side of the street were opening by remote, and the SUV that came the other way went to them straight over my lane.",
#:   "Caught between its own lane and the farm entrance on mine, the oncoming horsebox was for two seconds a wall across my road.",
#:   "Have the bicycle, which is approaching on the opposite side, lean left without a junction, pass over the ego's lane and vanish through a garden gate.",
#:   "Since when has somebody who wants the car wash on your side got the right to sweep over to it under your bonnet?",
#:   "V2, opposing, angled left toward the entrance of a private lot, in consequence of which its right side was presented to V1 in V1's lane.",
#:   "The ambulance wanted the hospital ramp and the ramp was on our side, so she came over, left, across us, up and in.",
#:   "Look at the dropped kerb, not at the car, I always tell them. There's a dropped kerb on your side, there's a hatchback coming towards you, and the child in the back's unbuckling. What's that make? Exactly, a hatchback over your lane, its left wheel up on the dropped kerb, and a garage door closing behind it.",
#:   "I braked because the bakery van got wider. Head-on, it's as wide as it's tall. It got to be as long as it is, all of a sudden, with \"Hovis\" from one side of my lane to the other, and then it got narrow again, tail lights, as it trundled up the side of the bakery, which is on my left.",
#:   "No collision occurred, but I would ask you to repaint the sign. Persons who come from the town, as this motorcyclist did, and want the campsite, believe that the arrow means now. He accordingly came off his half at an unaltered speed, passed over my half to his left, and was among the tents while I was still skidding.",
#:   "They call it a left turn across path, driveway variant. The important thing for the AV is that there is nothing on the map: no side road, no lights. There's just a coach that approaches, and a hotel with a forecourt on our side. Coach yaws left, covers our lane with twelve metres of glass, and unloads in front of the hotel.",
#:   "My dog knows the sound of Frank's truck, so he was pulling already. Frank came down the street, the robotaxi came up. His yard's on the robotaxi's side. Frank being Frank, he doesn't wait, he brings that truck left round the nose of the poor thing, over its lane and in by his yard gate, waving at my dog.",
#:   "From a car park attendant's window one sees what the drivers can't. The silver estate and the bus were about to pass each other. They didn't pass. The estate peeled off, its left, towards me, over the strip the bus was using, the barrier went up, the bus's nose went down, and I'd a ticket to print.",
#:   "Was the fire engine on a call, counsel wished to know. It was going home. The station lies on the north side; the appliance was westbound, the claimant eastbound, and so the one way home led through the claimant. It went that way, doors open, without stopping for him, in one leftward sweep over his lane and into bay two.",
#:   "The lamps that were meeting me on the other side swung over the hedge, that was a warning of sorts. They swung over me, so that I couldn't see. And when I could, they were lighting up the front of a farmhouse to my left, and the last of a Land Rover was going off my lane and into its yard.",
#:   "Uncle, I was on cycle, no speed. From front side one auto is coming, his side is empty, my side is empty, everything fine. But the wedding hall is on my side. So he cut left hand, over my whole portion, and went into the hall's driveway with the music. I took support of one tree.",
#:   "I left a long black line on Acacia Avenue. It begins where I saw a moped, which I'd been going to meet in the usual manner, dip its left shoulder. It ends at number 40. Number 40 is where the moped lives, on my side, up a short concrete slope, and it had been over my lane to get to it.",
#:   "\"You'd think he'd let the gentleman by first,\" said my aunt, \"seeing it's the gentleman's lane.\" But the butcher's van was making for its own back yard. It had come up the hill as we went down; and now it bore off leftward, a whole van crosswise in front of us, bumped over the gutter, and was in among its crates.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "Euro NCAP car-to-car front turn across path; own code"
#: [slots]
#: actions = ["oncoming", "turn-left"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 50.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns"

param OPT_ADV_SPEED = Range(4, 6.5)
param OPT_ADV_DISTANCE = Range(12, 50)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(1.4, globalParameters.OPT_ADV_SPEED, 6)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
