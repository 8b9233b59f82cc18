#: description = "The pedestrian runs into the road, falls, gets up again and limps on slowly."
#: rephrasings = [
#:   "She comes a cropper in the road, picks herself up and hobbles off.",
#:   "The non-motorist fell while running across the roadway, rose, and continued at a slow walk.",
#:   "ped runs, falls, gets up, limps away",
#:   "The target decelerates from running speed to rest in the lane and resumes at 1 m/s.",
#:   "The boy falls on the street, stands up and goes slowly further with pain in the leg.",
#:   "A runner trips, stays down for a moment and drags himself over to the other side.",
#:   "Somebody sprains an ankle halfway over and hobbles the rest.",
#:   "Mid-dash the walker goes sprawling, then scrambles up and limps clear.",
#:   "A chap ran out, went flat on his face, picked himself up and hobbled off.",
#:   "The pedestrian ran into the roadway, fell, got to his feet and continued slowly with a limp.",
#:   "Ped runs in, down, up, hobbles on slow.",
#:   "The pedestrian target runs into the carriageway, falls, rises and proceeds at reduced speed.",
#:   "A woman runs on the street, falls down, stands up and goes slowly with hurt leg.",
#:   "Ped with fall + recovery: running, zero speed on the ground, then 0.5 m/s shuffle to the far side.",
#:   "She came out running, went sprawling, and after a moment dragged herself up and hobbled on her way.",
#:   "He's down, no, he's back on his feet, he's dragging that leg, give him time to get across.",
#:   "guy ran out, totally ate it, got up n hobbled the rest of the way. felt bad",
#:   "A woman running into the road took a tumble, regained her feet and dragged herself on.",
#:   "He ran, he went down, he rose, and he continued, lame, at a much reduced pace?",
#:   "One man came running, fell on the road, then got up and went limping limping.",
#:   "Charges out, takes a header, scrapes himself up and drags his leg over. Take your time, son.",
#:   "Fall of running pedestrian in carriageway with slow impaired continuation.",
#:   "GUY RUNS OUT, FACEPLANTS, LIMPS AWAY",
#:   "The runner tumbled, rose and shambled on.",
#:   "kid ran out went facedown in the road got up hopped off on one leg",
#:   "Simulate a jogger who dashes out, trips, rises, hobbles onward.",
#:   "Up got the woman who had sprinted and fallen, and off she limped.",
#:   "Ped: fast entry, tumble in lane, recovery, lame walk to far kerb.",
#:   "Limping off the road: the student who'd charged in and gone sprawling.",
#:   "A man late for his tram raced off the kerb, caught his toe, hit the ground in my lane, struggled to his feet and went on lamely, holding his knee.",
#:   "The target is to enter at 3 m/s, drop to rest in the lane as if fallen, remain there for a given time and then move on at 0.7 m/s.",
#:   "I saw the little girl tear into the street, I saw her tumble, and when she'd stood up again she could only drag herself on because her ankle was hurt.",
#:   "We need a pedestrian who rushes out into the ego's lane, loses his footing, lies there a moment, gets upright and proceeds at a slow, injured gait.",
#:   "Lady has come running in chappals, slipped in the middle, somehow got up, and then with paining foot she went little by little to other side.",
#:   "Give him time, he came pelting out, he's had a nasty spill right here, he's up now, but look how he's dragging himself, he can't go any quicker.",
#:   "It was icy and she was in heels. She flew out between the parked cars after her bus and both feet went from under her just where I needed to be. A second or two on the ground, then upright, shoe in hand, and she went on like a wounded hen.",
#:   "Pedestrian 1 entered the roadway at a run from the west. He lost his footing and was on the pavement in V1's lane for approximately three seconds. He stood without assistance and continued eastward at a markedly reduced speed, favoring the left leg.",
#:   "One for the compilation. Guy in a suit legs it into traffic with his coffee, the coffee goes one way, he goes the other, belly flop in front of my car. Then he peels himself off the tarmac and waddles away, ever so slowly, as though it'd been planned.",
#:   "I'm not as young as I was and I shouldn't have run, I know it. Out into the road I went and down I came on my hip. When I had managed to get up the car was still waiting for me, so I shuffled on over with my bad leg as best I could.",
#:   "He burst from the doorway and into the street as if all hell were behind him; a cobble took his foot, and he measured his length before the headlamps. Slowly he raised himself, slowly, with one leg trailing, he moved on out of the light.",
#:   "Sprinted in, went sprawling, stood, then hobbled away over the road.",
#:   "Running ped trips in lane, rises, drags a leg onward.",
#:   "Let a schoolkid tear out, tumble, get up and limp off.",
#:   "The waiter ran into the street after a guest, slipped on a tram rail, lay there, came up with a torn knee and hobbled on at a miserable pace.",
#:   "The dummy enters running, is halted in the lane as by a fall, and after the dwell resumes at a third of its former speed.",
#:   "She has come running, she fell down flat in front of my car, after some time she stood up, and with one leg paining she slowly slowly went.",
#:   "A teenager galloped off the kerb, one lace undone, and you can guess: splat, a groan, back on his feet, and off at a sorry shuffle.",
#:   "It took V1 a long wait, as the man who'd run out and come down hard in its lane could, once he was up, only put weight on one foot.",
#:   "control, jogger's run out and gone over in front of me, wait, he's getting up, he's all right, well he's limping across, dead slow, I'm holding traffic",
#:   "Her tights were done for, that's what she minded. She'd seen her tram, so she bolted over the pavement and into our lane, and there the heel stuck and she did not. She sat on the ground for a moment looking at it. Then she got up and went on to the tram stop with one shoe on, step by painful step.",
#:   "We could see only down to his waist, because of the bonnet. So we saw the upper half of a boy come flying out, and then no boy. We held our breath. The upper half came up again after two or three seconds, white in the face, and bobbed away to the other side much slower than it had come, dipping at every second step.",
#:   "The plaintiff doesn't contend that my client's car touched him. He contends that he ran into the road, that he measured his length upon it by reason of a loose drain cover, that he got to his feet, and that he was making his lame way to the farther side when he was alarmed by my client's horn.",
#:   "When somebody has fallen in front of you and is up again, don't think the show is over. This lad came pelting out and he went flat on his chest. He's standing now, good. But see how he's holding his thigh, he'll be half a minute getting to that kerb, so neutral and handbrake.",
#:   "Motion profile of VRU 6: 3.4 m/s at entry, 0 m/s for two and a half seconds in the ego's lane with the bounding box at knee height, box upright again, then 0.6 m/s with a marked asymmetry between steps. The ego took the last phase for standing and tried to pass behind her, which it must not.",
#:   "It had snowed, and the children were let out early. The smallest of them charged into the road after his cap, both boots shot from beneath him, and he was a bundle in front of the car. Presently the bundle unrolled, put its cap on and proceeded to the opposite gate, very slowly, favouring its left foot and howling.",
#:   "I haven't run since I was sixty and now you know why. The pharmacist shouted that I'd forgotten my card, and I turned and ran, in the road I mean. Down I went on both hands in front of a taxi. He waited like an angel while I collected myself, and while I crept with my poor ankle to the pavement.",
#:   "For the video I'd call it \"Three acts of a Monday.\" Act one, businessman at full gallop into my lane. Act two, businessman on his stomach in my lane, papers everywhere. Act three, he's vertical again, and he goes off to the far side like a pirate with a wooden leg, taking about a week over it.",
#:   "Chauffeur's note, house of the ambassador. A photographer rushed into the carriageway before the car and, being encumbered, fell. I had already stopped. He rose after some seconds, refused assistance and continued to the opposite side with a pronounced limp, so that it was a good while before I could drive on.",
#:   "We want an injury in the crossing, without any contact. A person runs off the kerb as the AV comes near. In its lane he goes down and stays down for as long as the parameter says. He's then on his feet again, but hurt, and finishes the crossing at half a metre a second.",
#:   "Das Mädchen ran after the ball. I was braking already, and in this moment she did fall over the ball, exactly on my lane. She lay, she stood up, she looked at the knee. Then she went further, but not as before, she pulled the one leg behind her, and I waited with my warning lights.",
#:   "Galloped out, down he went, up he came, lame and slow.",
#:   "Sprint, splat, stagger up, hobble across: poor postman.",
#:   "Make the runner hit the deck in our lane, rise, and limp.",
#:   "The first half of the road cost her two seconds, her knees and a shoe, and the second, after she'd got herself off the tarmac, cost her the best part of a minute.",
#:   "We had stopped for a boy at full tilt, we stayed for a boy on his belly, and then we went on staying for a boy with one good leg.",
#:   "Pelting out after his hat, the old fellow measured his length in front of us, got up by stages, and nursed a hip over to the far pavement.",
#:   "The target enters at 3.4 m/s, is at zero as though fallen, and after the dwell continues in the same direction at 0.6 m/s.",
#:   "He has run like the wind, he has fallen like a sack, he has stood up like my grandfather, and like my grandfather he finished the crossing.",
#:   "Don't you creep forward because he's on his feet: he came flying out, he came down hard, and he can only drag that leg along.",
#:   "The knee of my jeans is in evidence bag four. It was whole when I left the kerb, and I left it at a rate of knots, my bus was in. It wasn't when I next stood up. In between I'd been nose down in front of a car, for how long I don't know. The bus didn't wait for somebody who goes a yard a second and says ow.",
#:   "What struck me, from my saddle, was the shoes. There'd been two pairs of sounds, as it were. Coming out into the lane it went tatatatata. There was a slap and then quiet, and I saw hands on the road and a car stopped short of them. And what took her over to the other side went tock, and drag, and tock, and drag.",
#:   "Blood was found at a point 1.4 metres inside the lane of Vehicle 1, with drops from there to the opposite curb at intervals which a physician describes as those of a short, uneven walk. From the near curb to that point there was none, but a skid of a rubber sole. Nobody had been struck; the vehicle's front was clean.",
#:   "He's up, he's up, all stations, stand easy, he's up. That was our streaker. He'd come over the barrier and was going flat out, into the road, into lane one, where he went over his own feet. He's on his way again to the far side, but I can tell you that he won't be outrunning anyone, he's got hold of his ankle.",
#:   "In the tenth of the forty crossings the volunteer truly hurt himself, and we kept the data. Up to the middle of the ego's lane they show a man running. They show him there at rest, with the height of a suitcase, for 3.1 seconds. And then he's a man again, but one who needs nine steps for what had taken him three.",
#:   "Would you mind telling it once more, and slowly? I saw a pram rolling, sir. I saw its owner coming after, fast as she could, out past the bollards. I braked for her. She was gone from the windscreen, I thought, where is she? A hand came up on my bonnet, and a face. She went on to the pram, sir, but hopping.",
#:   "That puddle had been waiting for someone all winter. It got the notary's clerk, who came flying from the door with a letter held high and no thought but the mail coach. He sat in it, before our wheels, quite still. When he had risen he and the letter went on towards the coach, dripping, with a gait like a broken chair.",
#:   "For my son it was the best part of the whole holiday. A man dressed as a banana came charging into the street, tripped over his own skin, and lay on his back in front of our taxi, stuck. He rolled, he got on his knees, he got on his feet. One foot didn't work. It's a long way over for a banana with one foot.",
#:   "Dynamic phases for VRU \"casualty\": (a) fast entry from the side, (b) sudden arrest in the ego lane with posture change, (c) rest, (d) posture restored, (e) departure towards the far edge with strongly reduced pace, asymmetrical. Most stacks cope with (a) to (c). In (e) they get impatient, and ours drove up to within a metre.",
#:   "The bonnet's high on these trucks. One moment I've a lad in a hi-vis tearing over in front of me, and then there's nothing, and you don't go when there's nothing, not if there's been something. I'd got down one step to look. He was pulling himself up by my bumper. Off he went to the other pavement, at about the pace of the moon.",
#:   "Sie lief dem Zug nach, she ran for the train, in high shoes, over the street without a look. In the middle, ratsch, she was lying there, and I stood already on my brakes. My wife wanted to go out and help. But the lady came on her legs again, waved, and went further, in small steps and very crooked, until the station door.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "hesitate", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.8
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 32.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.3
#: high = 1.6
#: unit = "m"
#: meaning = "how far from the ego's line it falls"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.8
#: high = 1.8
#: unit = "s"
#: meaning = "how long it is down"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 0.6
#: high = 1.1
#: unit = "m/s"
#: meaning = "how fast it limps on"

param OPT_ADV_SPEED = Range(2.8, 5)
param OPT_ADV_DISTANCE = Range(10, 32)
param OPT_STOP_DISTANCE = Range(0.3, 1.6)
param OPT_STOP_TIME = Range(0.8, 1.8)
param OPT_SLOW_SPEED = Range(0.6, 1.1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_SLOW_SPEED)
