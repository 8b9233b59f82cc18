#: description = "The rider pulls out from the roadside into the ego's lane and accelerates away along it."
#: rephrasings = [
#:   "A scooter shoots out of the side, straight into our lane, and speeds off.",
#:   "The motorcycle entered the travel lane from the shoulder and accelerated.",
#:   "moto pulls out in front, guns it",
#:   "The powered two-wheeler joins the VUT's lane from rest and gathers speed.",
#:   "The bike comes from the side in our lane and makes gas.",
#:   "A courier launches off the pavement and pedals hard down the road before us.",
#:   "The moped kid nips out ahead and opens the throttle.",
#:   "A biker who was standing at the roadside roars off right in front of us.",
#:   "A courier on a bike set off from the roadside into my lane and pedalled like the clappers up the road.",
#:   "The motorcyclist left the shoulder, entered the lane ahead of Unit 1 and rapidly gained speed.",
#:   "MC from edge into lane, opens up, away.",
#:   "The two-wheeler moves from the road edge into the lane of the test vehicle and accelerates in the direction of travel.",
#:   "The bicycle goes from the side on my lane and then rides fast away.",
#:   "Rider joins our lane from the roadside and pulls away ahead, doesn't cross it.",
#:   "He pushed off from the verge, wobbled into her lane and then was off up the street like a shot.",
#:   "Scooter's joining from the side, no signal, he's in your lane, but he's off, he's pulling away.",
#:   "bike came off the side into my lane and then took off down the road fast",
#:   "A moped joined the lane from the roadside and quickly made off down the street.",
#:   "The cyclist quit the verge, entered upon my client's lane and made away along it with increasing haste.",
#:   "One bike from road side came in my lane and raised full throttle, went away straight.",
#:   "Off the side he comes, in front of me, head down and away up the road like the Tour de France.",
#:   "Lane entry of two-wheeler from roadside with subsequent longitudinal acceleration away",
#:   "BIKE JOINS FROM THE SIDE AND TAKES OFF",
#:   "The cyclist slips in from the verge and sprints off along our lane.",
#:   "cyclist sets off from the curb ahead and races along our lane",
#:   "Bike joins from the verge, sprints on in our direction.",
#:   "Pedal courier enters ego lane from edge, speeds off ahead.",
#:   "WHERE DID HE COME FROM? Cyclist jumps in and pedals away",
#:   "Have a racing cyclist leave the roadside and zip off before us.",
#:   "A lad on a bike bumped down off the pavement in front of my car, turned the way I was going and put the hammer down.",
#:   "The bicyclist target leaves the roadside, takes up the VUT's lane and rides on in the same direction as the VUT with increasing speed.",
#:   "She had been waiting by the hedge with one foot on the pedal; then she swung into our lane and went tearing off along the road ahead.",
#:   "A cyclist which was standing at the border has entered in my lane and, standing on the pedals, he has gone away in front of me.",
#:   "From the lay-by a woman on an e-bike steered into our lane and, with the motor whirring, rapidly drew away down the street before us.",
#:   "Look out for the rider at the edge, he's coming in ahead of you, but he's quick and he's going your way, the gap's opening already.",
#:   "I was driving along the seafront when a man in lycra pushed off from the railings and came into my lane just ahead. I had to lift off a bit. He didn't hang about, though: head down, he wound it up and left me behind him.",
#:   "Unit 2, a pedal cycle, was stationary beside the roadway. As Unit 1 approached it moved into the lane ahead, aligned itself with the direction of traffic and gathered speed along the lane until it was travelling at some 30 km/h, without ever crossing to the other side.",
#:   "In this one the rider waits by the roadside until the robotaxi is near, rolls into the lane in front of it, and then pedals off along the very same lane as hard as he can. He neither stops again nor turns off, he simply leaves.",
#:   "There's always one of the food-delivery boys hanging round outside the burger place. Tonight he gets his order, hops off the kerb right into my lane, I hit the brakes, and he's already halfway up the street, his legs going like pistons.",
#:   "The boy had been leaning on the milestone. When the van was almost abreast he kicked away from the grass, slipped into the lane before its bonnet and bent over the handlebars, and by the time the driver had cursed him he was dwindling fast up the road.",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "accelerate"]
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.5
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it rides in the end"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 3.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"

param OPT_ADV_SPEED = Range(4.5, 9)
param OPT_ADV_DISTANCE = Range(3, 20)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(3.5) until abs(offsetFrom(egoRoute, self)) < 3
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
