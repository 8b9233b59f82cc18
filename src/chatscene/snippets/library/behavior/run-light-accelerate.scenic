#: description = "The crossing vehicle runs the red light and unexpectedly accelerates."
#: rephrasings = [
#:   "A car ignores the red signal and speeds up into the junction.",
#:   "The adversary jumps the lights, foot to the floor.",
#:   "Cross traffic shoots over the stop line on red, gaining speed.",
#:   "The other driver disregards the signal and surges across.",
#:   "Against the red light a car rushes through faster and faster.",
#:   "he sees red and steps on it",
#:   "Vehicle 2 accelerated through the red signal.",
#:   "red light, speeds up instead of stopping",
#:   "Jumped the red and then, instead of stopping, gave it some welly across the junction.",
#:   "Unit 2 failed to stop for the red signal and accelerated through the intersection.",
#:   "X-traffic jumps red, then speeds up mid-jct.",
#:   "The crossing target passes the red signal and increases its speed within the junction.",
#:   "The truck from the side goes with red and suddenly gives gas.",
#:   "Red-light violator that speeds up after the stop line; arrival-time estimate at the conflict point breaks.",
#:   "It was red for him, but he came on regardless, and halfway he put on speed.",
#:   "He's not stopping for that red, he's actually putting his foot down, hold it!",
#:   "he ran the red and then went even FASTER like bro",
#:   "Having ignored the signal, the lorry gathered pace over the junction rather than braking.",
#:   "You passed the red lamp, and your response, once within the junction, was to press the accelerator?",
#:   "He beat the red light, then inside junction press even more speed.",
#:   "Light's red, he's through it, and the further over he gets the more he gives it.",
#:   "Red-signal violation of crossing vehicle with increasing speed inside intersection.",
#:   "RUNS RED LIGHT THEN STEPS ON IT",
#:   "The crossing van flouted red and surged.",
#:   "Side-street bike defies the red, then whacks the throttle open.",
#:   "Crossing coach, red showing, doesn't brake but gathers speed instead.",
#:   "Let the cross-traffic lorry jump its red and pour on power.",
#:   "His lamp was red, but he drove, and then still faster!",
#:   "Vehicle from the side disobeyed signal, thereafter gaining speed, over.",
#:   "The signal had been against the saloon for some seconds when it came over the line, and to everyone's surprise it then began to go faster and faster.",
#:   "The crossing target violates its red phase, and at a defined distance the throttle is opened so that its velocity rises until it has cleared the junction.",
#:   "Number one, he's got a red and he's coming out regardless. Number two, and who'd expect that, he's now got his boot to the boards.",
#:   "My client had green. The van from Mill Lane did not respect its red light and, far from slowing when it saw her, put on a sudden burst.",
#:   "Since the taxi from the left had red, I was sure he will stop; he has not stopped, he has even made the motor to scream.",
#:   "Why didn't the robotaxi judge the crossing pickup right? Because, having burnt the red at thirty, it all of a sudden went up to fifty inside the crossroads.",
#:   "It's not only that he went through on red, plenty do that here. It's that halfway he seemed to wake up and see my bus, and the only idea that came to him was more gas. The back of that SUV squatted right down and it leapt across in front of me.",
#:   "On the evidence of the signal log, Vehicle 2 entered from the intersecting street three seconds after the onset of red. Its event recorder shows a steady 42 km/h on approach, then, immediately before impact, full accelerator and 61 km/h. The driver offers no explanation of why he sped up.",
#:   "Paper, section four, red violators with late acceleration. The crossing car does not react to its red signal and keeps coming; then, when we're already committed, it stamps on the throttle. Time-to-conflict drops by about a second from one frame to the next. Constant-velocity predictor is useless here.",
#:   "You could hear it more than see it, from the pavement where I was waiting with my bike. The motorcycle's light was as red as a tomato. It didn't lift off for that; it went over the line, there was a sort of shriek, and its front wheel came up as it sped across.",
#:   "My late husband would have had words with him. There he came along the other road, lights dead against him, in one of those big vans, straight into the crossing as if it belonged to him. And then, if you please, he made it go quicker still, right before my eyes.",
#:   "Cross-street moped ignores its red and, mid-junction, suddenly winds it up.",
#:   "Have the crossing SUV come through on red and abruptly gain speed.",
#:   "red for him, doesnt stop, THEN boots it, seriously mate??",
#:   "A bus on the other road treated its red as air, and once over the line it put on an unforeseen spurt that carried it across our front.",
#:   "The crossing target disregards its red aspect at constant approach speed and, at a defined distance from the conflict point, unexpectedly opens the throttle.",
#:   "The light of the lorry from the side was red since a while, he passed it nevertheless, and in the crossing he has started to run still quicker.",
#:   "He's got a red, that van coming from the side, he isn't having it. And now he's speeding up on you, of all the things to do!",
#:   "Your signal was against you and you drove past it; may I ask why, being by then in the junction, you chose to go faster?",
#:   "From nothing to hair-raising: the hatchback slipped by its red lamp at the speed of any law-abiding car, and it then burst forward before the robotaxi's nose.",
#:   "We had green and had had it for ages. From the cross street came a minibus that I took to be slowing, as its light was red. It wasn't slowing. It came in as steady as a clock, and then I heard the turbo whistle and saw it rear up, and what I'd thought I'd just miss, I just didn't.",
#:   "Signal timing confirms that V2's approach was on red when V2, a motorcycle, passed the limit line at approximately 25 mph. Within the intersection V2's speed increased to 43 mph. A witness at the taco stand described the sound as \"like when they pop the clutch\". V1 had entered on green.",
#:   "My worry isn't the red-runner; one brakes, one swears, one lives. It's the red-runner who has second wind. This one, a pickup on the crossing road, sailed in on red at thirty, so I reckoned I'd let him by ahead of me, and out of the blue he was doing sixty and I'd reckoned wrong.",
#:   "Ticket: crossing violator, late boost. Actor on the intersecting arm doesn't obey the red phase. Its speed up to the trigger is unremarkable. From the trigger on it floors it, quite unlike what the track history suggests, so arrival at our path comes some 0.8 s before the prediction. Ego should brake for the lamp violation, not for the boost.",
#:   "From where I stood with the lollipop I had a view of both lamps, green for the Corsa and red for the tipper. The tipper's wheels didn't so much as hesitate. I held up my pole. And he must have seen that, because his exhaust belched black and he thundered across the faster for it.",
#:   "There's a smell of burnt clutch in that video. The saloon on the cross road has no intention of honouring his red: over the line, same pace, la-la-la. A second later somebody seems to kick him. Down goes the tail, up goes the nose, and he's rocketing through in front of us.",
#:   "If she'd only kept to her speed, red or no red, I should have got away with it, for I'd seen her coming over the line and lifted my foot. It was a big silver estate with a dog in the back. What threw me was that it took a great leap forward in the middle, dog and all.",
#:   "It is one kind of sin not to see a red light, and another to see it afterwards. The young man on the motorbike passed under his in a dream. Halfway over the cross he woke, and the only thing that his right hand could think of was to twist. He went by Tomas's bumper like a thrown stone.",
#:   "Dispatcher: report of a coach on Jefferson blowing the signal at Sixth. Caller on Sixth had the green. She states it didn't brake for the light whatsoever, and that once it was in the intersection it sped up, quote, like it was trying to get away from something, unquote.",
#:   "In Madrid this is every day, but here the colleague from the side, with his lamp in red, came in calm, almost elegant. I thought: okay, he'll pass like that, elegant. No señor. When he was in the middle he stepped on it as if the bulls were coming, so I had to throw the lorry on its brakes.",
#:   "From the rickshaw I could hear his engine before I understood it. The signal on his side had gone red long back. The bike came over the line without bother, plain speed, and then the sound jumped up two octaves, and he'd crossed in front of the white car in the time of one sneeze.",
#:   "Crossing van shows its red the finger, then piles on speed.",
#:   "Bus jumps the red sideways-on to us, and suddenly it's galloping.",
#:   "His red, our green, and over the line he pins it",
#:   "A taxi on the cross street treated its red as scenery, and as if that wasn't enough, the pace at which it did so went up with a bound.",
#:   "One reckoned with a motorbike that would slip over on red at the speed it had; one hadn't reckoned with the wrist being wound back right in the box.",
#:   "My lights were with me and his against him. I had still worked out that I'd pass behind him, no, in front, no, he was putting on so much speed.",
#:   "The target on the intersecting path disregards its stop aspect at constant velocity and, on the trigger distance, is switched to high throttle until the conflict zone is cleared.",
#:   "Have an SUV come through on the red from the side road, as if it'd not seen the lamp, and then unexpectedly open up under the ego's nose.",
#:   "The charge is not only that the light was red to you, sir. It is that, having it behind you and my client before you, you chose the loud pedal.",
#:   "The bus shelter is all glass, so I had it from the side. Red for the pickup, I saw that lamp with my own eyes, and he went under it at thirty, say. Everyone about me drew in their breath for the poor robotaxi. That's when we heard his engine drop a gear, and what had been thirty was far more by the time it was opposite.",
#:   "It was the estimate that got us. When a lorry from the side hasn't stopped for its red, the eye makes a guess: it'll be here then, it will be gone then. My eye's guess was sound for one second. After that there was black smoke over the cab, and the thing was arriving well in advance of itself.",
#:   "A red is like a wall, I tell the children in my school bus, and that chap has driven through the wall. On he came over our road, not slow and not fast. \"Will he stop now, miss?\" they asked. He did the other thing. There was a scream from under his bonnet, and he flung himself across ahead of us.",
#:   "Phase log: cross street red since 3.8 s. Loop detector at the stop line: vehicle passes, 36 km/h, no brake. Camera at the centre: 51 km/h. The difference came about within twenty metres, which is nearly everything that a saloon of that type has got. The ego had planned on thirty-six and was shown otherwise.",
#:   "The thing about Nigel's red Alfa, as I now can tell you from the other car, is the sound. I'd already forgiven him the lamp, you know, anyone may dream through a lamp, and I was slowing to let him get over in his dream. Then it sang. It took the rest of the junction in a single gulp, with me standing on everything.",
#:   "Anyone who runs a light out of absent-mindedness lifts off when he notices. It's the ones who know that make my hair curl. This coach on the side road knew. Past the post with its red eye it swam, and with the whole of the crossing in front and us coming up to it, it began to make speed instead of mending its ways.",
#:   "It was a courier, he'd got a box on his back. The lamp that hung over him had turned its redness on ages ago. Under he goes. I brake for where he is, is what one does. But he's lying flat on the tank now, and the howl comes, and where he is has become somewhere else, much nearer to my lane and passing out of it.",
#:   "Radio log, 18:20. Silver hatchback westbound on Fleet, failed to stop for the signal at Pike, signal was red for him. Test vehicle southbound on Pike had green. 18:20, same caller: subject did not slow for her at all, he stepped on it in the intersection. She can still smell it. No collision.",
#:   "In India also red is red. I'm having green, I'm going. From the side comes one minibus, his signal is full red, he is not caring; okay, I adjust, I'm going slow. Then suddenly what has bitten him, I don't know, he's pressing full accelerator in the middle and is flying like airport bus. My adjusting was for a bus that's not flying.",
#:   "Half of this scenario we already had: a vehicle on the crossing road that's blind to its red. The new half comes after the line. The first half makes the ego brake for a thing of such-and-such a speed. The new one takes away such-and-such, as the thing surges, and asks if the ego keeps on looking once it has decided.",
#:   "I looked at him and he looked at me, that's what's so odd. He'd his red above him plain as a cherry, and his truck rolled beneath it all the same. We were looking at each other. I shook my head, he didn't shake his, and his bonnet came up the way they do, and my green road had a truck going over it like a train.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "accelerate"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 2.5
#: unit = "m/s"
#: meaning = "how fast it approaches"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(0.8, 2.5)
param OPT_THROTTLE = Range(0.5, 1)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
