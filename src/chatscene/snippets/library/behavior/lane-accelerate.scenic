#: description = "The car suddenly accelerates and closes the gap."
#: rephrasings = [
#:   "A vehicle speeds up so that the ego cannot move in.",
#:   "The adversary puts its foot down without warning.",
#:   "The neighbouring car surges forward beside the ego.",
#:   "The driver next door floors it and shuts the opening.",
#:   "The motorbike rushes ahead at full throttle.",
#:   "The moment we want over, he puts the hammer down.",
#:   "Vehicle 2 increased its speed considerably in the adjacent lane.",
#:   "It gives much gas and then there is no more hole for us.",
#:   "I went to move over and the bloke floored it to shut the door on me.",
#:   "Unit 2 sped up without warning, eliminating the space available to Unit 1.",
#:   "Truck in next lane, sudden gas, gap gone.",
#:   "The target vehicle abruptly increases its speed such that the available gap diminishes to zero.",
#:   "The bus goes suddenly faster, and there is no more place for me.",
#:   "Gap-closing actor: a > 0 as soon as we go for the slot, denies the merge.",
#:   "There had been room enough, but the rider opened the throttle and swallowed it up before she could take it.",
#:   "You had your gap there and he's just put his foot down and stolen it, so stay where you are.",
#:   "i had the gap n then he just sped up so i couldnt get in, so petty",
#:   "A driver picked up speed all at once and denied the other car the space it was making for.",
#:   "The opening was there, and you, sir, by quickening your pace, extinguished it.",
#:   "I wanted to filter, then the lorry purposely chiong to close the space.",
#:   "Moment I fancy that slot he perks up and plugs it, never fails.",
#:   "Loss of available gap owing to sudden speed-up of neighbouring vehicle",
#:   "SEES MY BLINKER, SPEEDS UP",
#:   "The bus quickens and squashes the gap.",
#:   "I had a nice space beside me till the van gunned it.",
#:   "Lorry alongside suddenly gets a wriggle on, and the hole's gone.",
#:   "Adjacent vehicle: step in throttle, closes available opening.",
#:   "Get the neighbouring bike to spurt forward and fill the space.",
#:   "Was that really necessary, tearing forward to stop anyone getting in?",
#:   "No sooner had a gap appeared in the next lane than the taxi there leapt forward and left us nothing but its rear door to look at.",
#:   "The adjacent target, until then at matched velocity, shall be commanded to full throttle so that the space ahead of it vanishes.",
#:   "The bus had been keeping company with us, then out of nowhere the driver gave it the beans and there was no room in that lane any more.",
#:   "V2, which had travelled parallel with V1, gained speed rapidly and thereby eliminated the interval between itself and the vehicle preceding it.",
#:   "The lorry on the other lane, when he sees the hole, he pushes the gas and the hole is finished, nobody enters.",
#:   "I'd like a saloon next to the AV that out of the blue quickens its pace hard, so that whatever opening there was is taken away.",
#:   "You could see him clock it. There were two car lengths free in his lane, he glanced over, his chin went down, and then that Audi simply charged up the lane until you couldn't have slid a newspaper into the space that was left.",
#:   "I told the officer it wasn't really an overtake. The motorcycle was running next to the robotaxi, quite peaceful, and then its engine screamed and it hurtled up its own lane to the bumper of the car in front, so nobody could get in.",
#:   "Now, that was a lovely opening, and you did well to look for it. But listen to his engine: he's winding it up, he's racing forward, and the door is closed. Some people can't bear to let anyone else have anything.",
#:   "The lady from number nine doesn't like sharing. We were side by side, with a bit of tarmac free in front of her, and all at once her little car bounded forward and gobbled it up, and she stared straight ahead as if butter wouldn't melt.",
#:   "Podcast listeners keep asking about meanness on the road, so here's mine. A truck beside us, cruising, loads of space before his bumper, and the second that space looked useful to anyone, black smoke came out of the stack and he thundered up to shut it.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: leader = false
#: actions = ["accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_THROTTLE = Range(0.5, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
