#: description = "The rider ahead starts to wobble, loses balance and falls in the lane."
#: rephrasings = [
#:   "The cyclist in front gets the wobbles and comes off right before us.",
#:   "The bicyclist lost control, fell, and came to rest in the lane of travel ahead of Vehicle 1.",
#:   "bike ahead wobbles, rider down",
#:   "The target ahead oscillates laterally and becomes stationary on the VUT's path.",
#:   "The cyclist before us has trouble with the balance and falls down.",
#:   "A front wheel caught in the tram rail, the biker sways and tumbles.",
#:   "The scooter shakes from side to side and then lies on the tarmac.",
#:   "Overloaded, the bike up ahead snakes about until it topples over.",
#:   "The poor bugger in front started wobbling on his bike and went over in the road.",
#:   "The bicyclist ahead lost control, began to sway, and fell to the pavement in the travel lane.",
#:   "MC ahead unstable, goes down, lying in lane.",
#:   "The leading two-wheeler shows increasing instability and topples over, remaining in the lane.",
#:   "The man with bicycle before me shakes left and right and falls down on the road.",
#:   "Lead rider: growing wobble, tip-over, stationary obstacle at ground level in our lane.",
#:   "The front wheel shivered, she fought it for a yard or two, and then she came off and lay there before him.",
#:   "Biker's got a tank slapper on, he's losing it, he's down, rider down in your lane.",
#:   "the guy on the bike started shaking all over and then ate it right in front of me",
#:   "A cyclist lost her balance and came down in the path of following traffic.",
#:   "The bicycle began to oscillate, the rider could not master it, and he was cast upon the road.",
#:   "Cycle in front started shaking, balance gone, and the fellow fell down in the road.",
#:   "Wibbling about like jelly, that rider, and next thing he's flat on the deck ahead of me.",
#:   "Loss of balance and fall of preceding two-wheeler rider into own lane",
#:   "BIKER WOBBLES AND WIPES OUT ahead of me",
#:   "The scooterist in front teeters and tumbles.",
#:   "Postman's bike ahead shimmies, tips, and dumps him on the tarmac.",
#:   "Motorcyclist in front fought the handlebars and ended up lying in our lane.",
#:   "Ahead: rider swaying, balance lost, down he goes.",
#:   "Let the leading cyclist totter and then drop onto the road.",
#:   "Splat went my brother off his bicycle after wiggling before the car.",
#:   "A carrier bag had got caught in her spokes, so the woman we were following on the bicycle began to rock from side to side and finally crashed onto the road.",
#:   "The preceding two-wheeler executes lateral oscillations of growing size for three seconds and then comes to rest, lying on its side, within the lane of the VUT.",
#:   "was about thirty yards behind this scooter when the back end startd snaking left n right and then he parted company with it middle of the lane",
#:   "Please put a cyclist ahead of our robotaxi who becomes shaky, cannot catch his balance any more and keels over so that he lies in front of us.",
#:   "Officers were told that the motorcycle leading the insured's vehicle developed a speed wobble which its rider couldn't control, and that both rider and machine finished up on the asphalt.",
#:   "The uncle on the cycle ahead was carrying two gas cylinders, he went shaking this side that side, and then cycle and cylinders and uncle, all fell in my way.",
#:   "See him in front, with the phone in one hand? His front wheel's going all over, little left, little right. Give him more room. More. And there you are, he's come off, he's sprawled in our lane, so it's a good thing you listened to me.",
#:   "V1 was following a bicycle at fifteen miles per hour. The bicyclist, age seventy-one, was seen to waver with increasing swings for some yards, after which he toppled to the pavement in the lane ahead of V1 and did not get up before its arrival.",
#:   "Diesel on the road, nothing you can do. I was leading the group on my old Triumph when the bars started to slap from lock to lock, I thought I'd got it, I hadn't, and next I'm on my back in the lane looking at the bumper of the car that'd been behind me.",
#:   "Bug: perception loses a fallen VRU. The lead cyclist rides normally, then oscillates about the lane centre, then tips and is at ground level, stationary. From that frame on the track is dropped as debris although he's lying right in our lane, twelve metres off.",
#:   "For a moment it was almost pretty, the way the girl on the bicycle in front of them swung to one side and the other like a leaf coming down. Then the swings grew too wide for her, and she fell, and the bicycle lay ticking in their lane.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "stop"]
#: position = "ahead"
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.0
#: high = 1.6
#: unit = "m"
#: meaning = "how far it wobbles to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.0
#: high = 3.6
#: unit = "s"
#: meaning = "how long a full swing takes"
#: [[parameters]]
#: name = "OPT_ADV_TIME"
#: low = 6.0
#: high = 8.0
#: unit = "s"
#: meaning = "how long it wobbles before it falls"

param OPT_ADV_SPEED = Range(4, 6)
param OPT_ADV_AMPLITUDE = Range(1, 1.6)
param OPT_ADV_PERIOD = Range(3, 3.6)
param OPT_ADV_TIME = Range(6, 8)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) for globalParameters.OPT_ADV_TIME seconds
    do Halt()
