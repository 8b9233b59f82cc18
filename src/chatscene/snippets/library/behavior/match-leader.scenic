#: description = "The car in the target lane slows down and matches the speed of the slow leading vehicle, blocking the lane."
#: rephrasings = [
#:   "A vehicle beside drops back until it is level with the leader and stays there.",
#:   "The adversary adjusts to the pace of the slow car ahead and forms a wall with it.",
#:   "The neighbouring car decelerates to the leader's crawl, so nobody gets past.",
#:   "Driving as slowly as the vehicle in front, the car closes off the other lane.",
#:   "The driver in the target lane falls into step with the slow leader.",
#:   "The one beside us drops to the slowcoach's speed, and now both lanes are shut.",
#:   "Vehicle 3 slowed in the adjacent lane to the speed of the lead vehicle, leaving no passing lane.",
#:   "Adjacent veh adopts leader's low speed, rolling roadblock.",
#:   "I wanted to move over, but he sat alongside the slowcoach and wouldn't let anyone by, like a rolling roadblock.",
#:   "Unit 2 reduced its speed to that of the slow vehicle ahead of Unit 1, preventing a lane change.",
#:   "Truck in next lane drops to speed of slow one ahead, both lanes plugged.",
#:   "The vehicle in the adjacent target lane adapts its velocity to that of the slow lead vehicle so that the passing lane is obstructed.",
#:   "Car in the other lane goes now same slow as the truck before me, I cannot change.",
#:   "Target-lane actor eases down to v_lead, so no overtake is possible on either side.",
#:   "He came down to the tractor's speed and stayed there, the two of them side by side, a moving wall in front of her.",
#:   "You won't get past now, the bus in the other lane has eased down level with that slow wagon.",
#:   "the car in the other lane slowed to the same speed as the slow one in front so now im boxed in ugh",
#:   "Two vehicles ended up side by side at the same low speed, leaving the follower with no lane to use.",
#:   "By dropping to the pace of the laggard ahead, the defendant denied my client the lane he meant to enter.",
#:   "I want to change lane but that side car also became slow like the front lorry, both are going together.",
#:   "Snail in front of me, and now his mate in the other lane's dawdling level with him, so I'm stuffed.",
#:   "Blocked target lane due to speed adaptation of its occupant to slow preceding vehicle",
#:   "TWO SLOWPOKES SIDE BY SIDE, nobody gets by",
#:   "The truck in the other lane slackens to keep step with the dawdler and seals the lane.",
#:   "Next-lane van throttles back to the plodder's pace, so no way past.",
#:   "Other lane's coach copies the dawdler ahead; both lanes corked.",
#:   "Have the neighbour ease off and keep abreast of the slow leader.",
#:   "Car beside dropped speed stop now equals crawling lorry ahead stop lane shut",
#:   "Now both of them are slow, next to each other, like twins!",
#:   "taxi in the lane i wanted came down to exactly the pace of the tractor in front of me and stuck there like they were welded together",
#:   "On the second lane the motorcycle becomes as slow as the truck which is before us, and together they make like one gate that stays closed.",
#:   "The adjacent-lane target shall reduce its velocity to that of the slow lead vehicle and hold this side-by-side formation, closing off the lane.",
#:   "V3, occupying the neighbouring lane, shed speed until it equalled that of slow-moving V2 ahead, with the result that V1 found neither lane usable.",
#:   "What makes the fellow in the overtaking lane suddenly content to go no faster than the milk float ahead of us, so that nobody behind can get by?",
#:   "You've a caravan plodding along ahead, and the lorry in your other lane has backed off until he's going just as slowly, so that lane's no good either.",
#:   "I'd been stuck behind the road sweeper for a while. Just when the lane next door looked useful, the hatchback in it slackened off, drew level with the sweeper and stayed there at the same dreary speed, and that was both lanes gone.",
#:   "The actor in the target lane reads the speed of our slow leader and adopts it. From then on the pair rolls abreast, or nearly so, and whatever the ego tries there is no passing slot; expected behaviour is patience.",
#:   "I put it to you that you had no reason to slow down in your lane. You saw the refuse cart creeping along in front of my client, you brought your own vehicle down to its pace, and you remained next to it like a cork in a bottle.",
#:   "Two elephants in a corridor, that's what they looked like from my car. The first had been crawling in front of us all along; the second, in the other lane, had been faster until it, too, fell back to a crawl and shut the way.",
#:   "Cyclist's view from the bus lane: a grey car hung behind a very slow digger, and the bus in the lane beside came off the power and matched that digger mile for mile, so the poor grey car had nowhere whatever to go.",
#:   "Neighbouring bus sinks to the tractor's pace: two-wide plug, no exit.",
#:   "Motorbike in the free lane now crawls abreast of our slow leader.",
#:   "both lanes shut, cheers, the audi's decided to keep the dumper truck company",
#:   "The lorry in the lane we could have used came off the power and fell in alongside the mobile crane, at the crane's own crawl.",
#:   "The target in the adjacent lane adapts to the lead vehicle's low velocity, remains abreast of it and thereby renders the passing lane unavailable.",
#:   "I hoped for the left lane, but the lady in it braked gently down until she was as slow as the caravan before me, and so she remained.",
#:   "We need a coach in the other lane that gives up its speed, takes on that of the dawdling lead car and keeps the lane corked.",
#:   "Forget the other lane for now, because that van's dropped back to the sweeper's fifteen miles an hour and he's sitting next to it like a gatepost.",
#:   "Front one is slow, no problem, I thought, side lane is there; but the side lane truck also reduced and came equal with him, full wall.",
#:   "There was a hay cart, or the modern equivalent of it, in front of us. The lane alongside had been flowing nicely, with a taxi in it doing twice our speed. Then the taxi lost its appetite, came down to hay-cart pace, and there they were, shoulder to shoulder, with the whole county behind them.",
#:   "One plodder you can live with. What did for us was that the second vehicle, which was in the lane we meant to use and had a clear road, shed its extra speed until it was doing neither more nor less than the plodder, whom it then escorted as far as the roundabout.",
#:   "Observe the two velocity curves. The lower one is the slow leader and is flat throughout; the upper, belonging to the truck in the target lane, bends downwards at the trigger until it lies on top of the first, and from there the ego has no lane to pass in.",
#:   "\"Like a pair of nuns,\" my wife said. The first, a dustcart, had been holding us up for a mile. Her companion, a hatchback in the next lane, had been getting on well enough until it drew in its horns, and now they went along side by side and filled the road.",
#:   "He'll tell you there was nothing to stop anybody from overtaking. There was: him. He brought his minibus down from fifty to the eighteen that the road roller ahead of my client was managing, kept it at that, and so his lane was of no more use than hers.",
#:   "I ride with a club and we're told not to do this. A motorcycle in the outside lane shut off until it was toddling along level with a horsebox, and behind the pair of them a grey car couldn't go round by either lane.",
#:   "Watch the window between the two tailgates, the one ahead of you and the one a lane over. It's stopped closing. The pickup over there was getting away from that mower and has now sunk to the mower's pace, so there's no lane for you to go to.",
#:   "Everything seemed to go thick, as in a dream. In front there was the old Trabant with its blue smoke; beside it, where I'd hoped to slip by, the coach's great wheels turned slower and slower until the two were locked in step, and they stayed so.",
#:   "Passengers asked support why the robotaxi hadn't overtaken the gritter. Support looked: the neighbouring lane was occupied by an SUV that had cut its pace to exactly the gritter's, a little way along from it, and that held this position for three kilometres.",
#:   "Two of my own kind it was, I'm ashamed to say. One was grinding up the bank in front of a car at twenty. The other had been going well in lane two, and he eased off and eased off till he was grinding next to his mate, and that was the hill closed.",
#:   "It should be noted that V3 did not brake sharply. Over some eight seconds it merely relinquished the speed advantage it had in the adjacent lane, until its speed was the same as that of V2, the slow vehicle in front of V1; after that no passing lane remained.",
#:   "Sweeper ahead, and now the next lane has come down to sweeper speed too.",
#:   "Two tailgates abreast, same dismal pace. Nobody's getting by.",
#:   "Neighbour throttled back to our dawdler's 20; pass no longer available.",
#:   "The coach in the lane we hoped for had been gaining on the milk float ahead of us; it isn't now, they're as one, and we're shut in.",
#:   "You could have laid a plank over the two roofs, the slow tractor's and the minibus's in the other lane, since the second had sunk to the first's speed.",
#:   "Give the lane next to ours a motorbike which loses its extra pace as it nears the leader's level and then crawls in step with it, so nobody can slip through.",
#:   "All three of us were doing nineteen by then: the crane, which could do no more, the hatchback in the next lane, which could, and I, who'd been shut behind them.",
#:   "In consequence of V3's having relinquished its surplus of speed in the adjacent lane, the slow-moving V2 and V3 formed a closed front ahead of V1.",
#:   "Links was the lane free, I put already the blinker, but the truck there becomes slower and slower till he marches in the same step with the caravan before me.",
#:   "I'd worked out a nice little plan. The gritter could have the lane it was in, and I'd have the other one, as soon as that taxi was through. The taxi was never through. Its brake lamps glowed for a bit, gently, about level with the gritter, and from then on the two kept time like a pair of clocks.",
#:   "\"Rolling roadblock\" sounds deliberate, and it may not have been. One lorry was labouring up the bank ahead of us as slow as a barge. A second, in the free lane, had been coming up to it well; somewhere by the chapel its driver saw no more reason to hurry, and the free lane had a barge in it as well.",
#:   "See the strip of sunlight on the tarmac between those two, the digger ahead and the van to its right? It was getting longer, which would have meant a way round for you. It's been the same length now for a minute. The van's down to digger speed, so stop leaning to your right and settle in.",
#:   "The queue behind us blamed us. I'd have liked to show them what I was looking at: in front of my bonnet the back of a combine, and where the overtaking lane should have begun the back of a people carrier, whose driver had eased off until the two of them were advancing like a couple at the altar.",
#:   "For the blocked-lane series the second agent must not start out slow. It begins with a surplus of some thirty km/h, so that the ego will plan on its being gone. It then sheds this surplus, matches the slow leader in the neighbouring lane to within half a metre per second, and holds that.",
#:   "There was nothing wrong with the bus. My learned friend has had it examined. It went from fifty to sixteen, in the lane which the plaintiff had indicated for, because its driver wished to chat through the window to the driver of the dustcart, who was doing sixteen before her. And chat they did, for a mile.",
#:   "A cyclist sees how little they all gain. There was a grey car held up by a mobility scooter, and next to it a lane with a sports coupé in it. That coupé could've been in the next county. Instead it folded its wings and puttered on beside the scooter, and I, on my three gears, passed the lot.",
#:   "Was there a moment when one might have gone? Between the horsebox in front and the motorbike coming by it on the other lane, yes, if the motorbike had kept on going by. Its engine note sank instead. It hung there, at the horsebox's shoulder and the horsebox's speed, and the moment was over for good.",
#:   "Robotaxi log, in plain words. I'm behind a slow thing. I ask for the next lane; somebody fast is in it, so I wait for the somebody to clear off. The somebody becomes exactly as slow as the slow thing, and stays level with it. I ask again every ten seconds. I have now asked forty-one times.",
#:   "When I was a young man on the wagons, you flashed and the other fellow dropped back behind you. Yesterday's fellow dropped back, too, but only as far as the road roller's elbow, me being stuck behind the road roller; there he hung, at roller pace, in the only other lane that the Lord has provided.",
#:   "First I was thinking, only one problem is there, one water tanker, leaking also, full slow in front. Then the problem got a brother. Side lane Innova was coming fast, I gave respect, I waited, and he pressed brake little by little till tanker's speed was his speed. Two brothers, hand in hand, closed shop.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["LeadingAgent", "advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["slow"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -4.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far ahead of the leading vehicle it stays"

param OPT_ADV_DISTANCE = Range(5, 30)
param OPT_ADV_AHEAD = Range(-4, 14)

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do PaceOnPath(advLane, LeadingAgent, globalParameters.OPT_ADV_AHEAD, LeadingAgent.pose[3] + 0.4)
