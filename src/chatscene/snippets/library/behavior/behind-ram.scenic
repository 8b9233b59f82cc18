#: description = "The car behind tailgates the ego and then accelerates into it."
#: rephrasings = [
#:   "The maniac behind hugs our bumper and then gives us a shove.",
#:   "Vehicle 2 followed closely, then accelerated and struck the rear of vehicle 1.",
#:   "Tailgater floors it, rear-end hit.",
#:   "The target closes up behind the VUT and then accelerates toward its rear.",
#:   "He sticks behind us and then gives gas and pushes.",
#:   "A pickup on our tail loses patience and rams.",
#:   "The bus sits on our boot lid until the driver hits the wrong pedal.",
#:   "A lorry looms in the mirror, crawls up and bulldozes on.",
#:   "The van had been glued to my backside for ages and then he just floored it and shunted me.",
#:   "Suspect vehicle followed at an unsafe distance and intentionally rammed Unit 1 from the rear.",
#:   "Truck on rear bumper, then full throttle, rear-end hit.",
#:   "The following vehicle maintains a short headway and subsequently increases speed until it strikes the rear of the test vehicle.",
#:   "Bus behind is too close, then gives gas and crashes in my back.",
#:   "Rear actor closes up and does not stop closing: it speeds up into our rear end, collision from behind expected.",
#:   "They sat on his tail for a mile, and when he would not move over they put their foot down and drove straight into his boot.",
#:   "Unit, the pickup in back of you is bumping you on purpose; he's hanging right there and now he's powering into you.",
#:   "dude behind was so far up my butt and then he literally just sent it into me wtf",
#:   "A motorist was shunted from the rear by a lorry which had been hounding her for some time before putting on speed.",
#:   "Is it not true that you crowded my client's car and thereupon pressed the pedal until your bumper met his?",
#:   "Wah this bus stick so close behind, then suddenly press pedal and bang my backside.",
#:   "Feller's breathing down my neck the whole way, then he gives it welly and caves my rear in.",
#:   "Deliberate rear impact by pursuing vehicle following a period of insufficient separation",
#:   "ROAD RAGE: pickup stalks cammer then PLOUGHS into the back",
#:   "The truck behind presses up and batters us forward.",
#:   "Glued to my tailgate, then he gunned it right into me.",
#:   "Simulate a bumper-riding coach that finally powers into the ego's rear.",
#:   "Mummy, the lorry came really really close and then zoomed into our bum!",
#:   "shunted by close folower who speeded up on me",
#:   "Ambulance practically in our boot, next thing it put its foot down. Crunch.",
#:   "I want a scene where a pickup drives an arm's length from the ego's rear, then opens the throttle and drives right through that remaining arm's length.",
#:   "My rear hatch was crushed because the motorist at my back, who had left no room to begin with, stepped on the gas instead of dropping off.",
#:   "For a kilometre there was hardly a hand's breadth between the cab and the robotaxi, after which the cab surged and buckled the robotaxi's rear panel.",
#:   "The German behind me has hung on my stossstange all the time and then he gave full gas, so he drove me in the back.",
#:   "Test 14: following target at minimal headway; on trigger, target applies throttle and contacts the rear face of the subject vehicle without changing lane.",
#:   "How did the towbar get bent? A fire engine was filling my mirror, nose to tail, and instead of easing away it put on power.",
#:   "What I noticed first was that I could no longer see his headlights, so close was he. Then the engine behind me roared, and before I had understood it the motorbike's front wheel had been driven into my number plate.",
#:   "V2, a box truck, had been trailing V1 with less than half a second of headway. Its recorder shows pedal application rising to one hundred per cent immediately before its front end met V1's back end. No evasive action was taken by either driver.",
#:   "You know that feeling when somebody's reading your bumper stickers with a magnifying glass? That was the SUV at my back. I held my speed, he got cross, hoofed it, and the next I knew my head hit the rest.",
#:   "When you reach my age you don't like being crowded, and this young man in his saloon simply would not leave me any space. I suppose he lost his temper, for he revved up and ran himself into the back of my little Fiesta.",
#:   "The riders of the tour bus told officers that it had been driving on top of the small hatchback for several minutes. Their driver then leaned on the pedal, and the bus gained on the last metre there was and bulldozed the hatchback's rear in.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "accelerate"]
#: leader = false
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -10.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_GAP"
#: low = 1.0
#: high = 4.0
#: unit = "m"
#: meaning = "how much room it leaves between its bumper and the ego's"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.3
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 0.6
#: high = 1.8
#: unit = "s"
#: meaning = "for how long it presses the pedal"

param OPT_ADV_DISTANCE = Range(-10, 15)
param OPT_ADV_GAP = Range(1, 4)
param OPT_THROTTLE = Range(0.3, 1)
param OPT_THROTTLE_TIME = Range(0.6, 1.8)

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12)
