#: description = "The oncoming motorcyclist unexpectedly swerves into the lane the ego is using."
#: rephrasings = [
#:   "A rider coming the other way veers toward the middle of the road.",
#:   "The approaching motorbike jerks over in front of the ego.",
#:   "From ahead, a two-wheeler suddenly leaves its line.",
#:   "The oncoming cyclist lurches sideways before the vehicle.",
#:   "The biker riding toward the ego darts across its lane.",
#:   "the biker coming at us suddenly jinks across",
#:   "A motorcyclist approaching in the opposing lane swerved abruptly.",
#:   "The rider from in front makes a quick movement to our way.",
#:   "A lad on a pushbike coming the other way suddenly swung over into my lane.",
#:   "The motorcyclist, traveling in the opposite direction, veered without warning into the lane occupied by Unit 1.",
#:   "Opp. biker darts into ego's lane. No sign.",
#:   "The oncoming powered two-wheeler target makes a sudden lateral movement into the lane used by the VUT.",
#:   "The man on motorbike comes against me and suddenly changes into my lane.",
#:   "Oncoming two-wheeler jinks into our lane at short range; head-on risk with a VRU.",
#:   "He came pedalling down to meet her and then, heaven knows why, jerked his handlebars over into her lane.",
#:   "Scooter coming towards you, watch him, he's flicked over onto our side!",
#:   "biker coming at us just swung over into OUR lane im shaking",
#:   "An approaching motorcyclist jerked out of his line into the lane of a family car.",
#:   "The rider, coming the other way, quit his side in an instant and was in my client's lane?",
#:   "Opposite side bike fellow suddenly cut into my lane, heart attack I got.",
#:   "Lad on two wheels coming at me throws it over onto my side. Death wish.",
#:   "Sudden lateral incursion of oncoming two-wheeler into ego lane.",
#:   "MOTORCYCLE SWERVES INTO MY LANE HEAD ON",
#:   "The oncoming cyclist jinked into our lane.",
#:   "Moped approaching head on snaps sideways into the lane we're in.",
#:   "Facing cyclist, no warning, lunges over into ego's lane.",
#:   "El ciclista comes front to me and suddenly throws himself on my lane.",
#:   "Opposing motorcycle breaks across to our side, out of the blue.",
#:   "Let the scooter riding toward us veer abruptly into our path.",
#:   "From the other direction came a boy on a bicycle, quite straight, and then with a twist of the bars he was in the lane we needed.",
#:   "A motorcyclist who was about to pass us in the usual way, driver's side to driver's side, pitched over without notice into our very lane.",
#:   "The robotaxi's lane was invaded when an approaching biker, for reasons still unknown, slewed out of his own half of the road.",
#:   "Nobody had given that cyclist a reason; she was coming the other way and all of a sudden her front wheel was pointing at our lane and she was in it.",
#:   "On closing to forty metres, the opposing two-wheeler departs from its line by a sharp steering input towards and into the lane in use by the VUT.",
#:   "Keep left now, that motorbike up ahead that's heading for us has just lurched across, he's in your lane, be ready for him.",
#:   "I deliver parcels, I look at oncoming bikes all day. This one was a courier like me, coming towards my van on his own side, hands on the bars. Then it was as if somebody had kicked him: he shot sideways and was in front of me on my side.",
#:   "V1 was traveling north. V2, a bicycle, was traveling south in the opposing lane. As the distance closed the bicyclist made an abrupt and unexplained lateral movement to the left and entered the lane in which V1 was traveling, placing the two on a collision course.",
#:   "A moth, it may have been, or a spark from his cigarette. The motorcyclist whom they had watched for a mile coming down the valley towards them gave a start, and the machine with him, and it leapt out of its own half of the road into theirs.",
#:   "In scenario 9 the opposing rider travels its normal path at constant speed. When the gap to the ego has shrunk to the set distance it yaws suddenly and moves into the ego's lane. There is neither a turn signal nor an obstacle which would explain it.",
#:   "Me and my sister were counting motorbikes. The fourth was coming at us from the front and then he went zip, over the white line, right into our bit of the road, and Mummy pulled on the wheel and said sorry to him, but it was him!",
#:   "Scooter from the front suddenly pitches into our lane.",
#:   "Approaching pushbike, no sign given, is flung over onto our half.",
#:   "Oncoming courier on two wheels: one twitch, and he's in ego's lane.",
#:   "The motorcyclist was keeping to his side on his way towards us until, for no cause that we could see, he broke out of it into ours.",
#:   "this kid on an ebike coming the opposite way just yeets himself over the line into the lane im driving in",
#:   "An opposing cyclist on a parallel path executes an unannounced sharp lateral manoeuvre which places him within the lane of the ego vehicle.",
#:   "He's coming up on his own side, that moped, no bother to anyone, and whoa, he's jerked it over into your lane, brake!",
#:   "Please let a motorcyclist come the other way and, at close range, veer all at once into the lane which the robotaxi is in.",
#:   "From opposite one Bullet motorcycle was coming nicely in his side, and without any reason he jumped into my side of the road, straight facing me.",
#:   "I had my lamps dipped for him, as one does. His single lamp came on towards us down the other side, and I remember it was steady. Then it darted across the windscreen like a wasp and stopped darting when it was dead in front, in my lane, and I put the car in the ditch sooner than meet it.",
#:   "The statement of the claimant reads as follows. A bicycle was approaching her in the opposite carriageway, ridden by a man in work clothes. When it was no more than two car lengths off it veered suddenly over the centre marking into her lane, with the result that she was obliged to mount the verge.",
#:   "You never quite believe in them until they're on your side, do you? All the way down the hill she'd been a girl on a bicycle who was coming to meet us and would pass us by on the other side. Something buzzed her, I suppose; the handlebars went round, and there she was between our headlamps.",
#:   "A raised drain cover, that's my theory, and I've reported it to the council. The motorbike coming towards my cab hit something, or dodged something. Whichever it was, from one moment to the next he wasn't over there where he belonged but on my side, coming straight at my radiator.",
#:   "From the track file: class two-wheeler, heading opposite to ours, lateral offset constant at minus 3.4 m for six seconds. Within 0.7 s the offset collapses to nil. The predictor, which had seen no indicator and no obstacle in front of the rider, had given the manoeuvre a probability below one percent.",
#:   "I know him, he's the baker's boy, and he'd have been singing. He was riding up the lane to where we were coming down it. We saw his mouth shut and his knee go out, and his front wheel turned in towards us, quick as a fish, and it was in our half of the lane that he was coming on now.",
#:   "Der Radfahrer comes toward to me, correct, on his side, with the bag on the back. I am already thinking on something other. Then he makes a hook, without to look, and he drives now in my lane and his eyes are so big as plates.",
#:   "That's what \"expect the unexpected\" means, by the way, it's not just a sticker. Your biker was approaching on the far side of the line and had no earthly reason to leave it. He left it; he swung bodily over into the lane we're sitting in, and because you'd covered the brake, we're still here to talk about it.",
#:   "At 17:22 V2, a motorized scooter, was southbound, and V1 was northbound. A witness walking on the east sidewalk saw the handlebars of V2 turn abruptly. V2 crossed the center line into the northbound lane directly in the path of V1, whose driver had no opportunity for evasion.",
#:   "It lasted for as long as it takes to say \"oh\". On the left half of the picture, small and upright, a cyclist whom they'd meet by and by; on the right half, theirs, nothing at all. Then the figure toppled sideways, or so it looked, and was pedalling in the right half with its face to them.",
#:   "Two-up on a Vespa, coming the other way, having a chat by the look of it. Pillion points at something, driver looks, and the whole lot lurches over the paint and into my bit of road. I've driven hearses for twenty years and I nearly had my first two walk-ins.",
#:   "Facing biker, far side, far side, our side!",
#:   "The cyclist meeting us wrenches his bars into our lane.",
#:   "Approaching moped kinks over the line, dead at our bonnet.",
#:   "A bell rang, a wheel turned in, and the cyclist who'd been going to pass us by on the far half of the road was riding at us on ours.",
#:   "At set gap, opposing motorcycle: abrupt steering offset towards ego's lane; it continues facing the ego inside that lane, no return, no braking.",
#:   "vespa coming the other way totally chill on its side and then FLICK and im looking at its headlight between mine, what was that",
#:   "In his lane he came, on his Enfield, singing maybe; with no cause he has taken one jerk and in my lane only he is coming on my face.",
#:   "I'd given the approaching courier all the room in the world, I thought, but then it was in my half that his front tyre pointed and went.",
#:   "Her track towards us is a credit to any cyclist as far as the bend; there it leaps into the next lane, the one we were coming along in.",
#:   "A helmet is a small thing to have to look for in a wide windscreen, but I'd found it, low on the right, getting bigger, as you do when somebody's about to go past you. I blinked. It wasn't low on the right now. It was in the dead centre between my wipers, still getting bigger, and there'd been no signal nor any earthly reason.",
#:   "The taxi's skid marks go off to the verge, and it's a fair question what it was that they go away from. There's nothing there; a lane, ours. But a witness behind had seen the oncoming motorcyclist give his machine a violent heave out of the lane that was his and into that one, at forty paces. There wasn't anything for him to dodge, she said.",
#:   "On a hill I see who comes down. A girl on a racing bike was coming down to the van just ahead of me, nice and neat on her own half. A dog barked. And as if the bark had hit her she shot sideways, she was on our half, her front wheel straight at the van's badge.",
#:   "Somebody's got to explain to my robotaxi what a Sunday rider is. It had filed this biker under \"opposing, no conflict\", which was true while he was over there, coming along by the far kerb line. Between one beat of the wipers and the next he'd cast himself over the paint into the lane with us in it, and the file was closed with a bang of brakes.",
#:   "Members of the jury, a lane is a promise. The defendant, on his motorcycle, was approaching the deceased's car and kept that promise to within thirty yards of it. No one had pulled out on him; his road was clear. He then heeled over sharply, of a sudden, and had his front wheel in the lane in which the deceased was driving, with nowhere for her to go.",
#:   "That isn't paint on my number plate, it's from his mudguard. Eight in the morning, sun behind me, all's well, and a postie coming the opposite way on his red bike. He's on his side as per. I look down, I look up, there's a postie bang in the middle of my lane, coming at me, and his side's got nobody in it.",
#:   "It's because the saddle was loose, he said at the hospital. It may be so. What happens when a saddle is loose, seen from in front, is this: a bicycle is coming, on the left of your picture. Then its rider looks astonished; and then he and it aren't on the left, but have veered, quick as a trout, into your lane, coming straight at you.",
#:   "My reading glasses were on, so I saw two of everything. Two motorbikes were coming towards us on the other side of the road, quite upright. Both of them ducked, at the very same time, as you'd expect, and there wasn't so much as an indicator. When I'd got the glasses off there was one, and it was in Harold's lane, with its lamp looking in at us.",
#:   "Sensor note: radial velocity of the opposing two-wheeler unchanged at minus 21 m/s throughout, hence no braking on its part. Bearing, however, jumps from eight degrees left to zero in 0.6 s and remains there. That's to say it left the lane beside ours for ours by a single sharp manoeuvre, and the free-space module had nothing for it to have been avoiding.",
#:   "If one comes to me on a scooter, I have a rule, I look his shoulders. So I looked. The shoulders were calm, he was in his lane, he comes, I come. Suddenly one shoulder falls down, like he has lost a coin, the scooter obeys to the shoulder and she's in my lane, with him, opposite to me, at fifteen metres. In Napoli nobody would be astonished.",
#:   "They would've met as strangers do, on either side of a line, with no more than a glance. The glance was all it took. Seeing, or believing that he saw, a face he knew behind the glass, the rider coming down from the pass let his hand follow his eye; the machine sprang across to where she was, and the face, whosoever's it was, grew very large.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "swerve"]
#: position = "oncoming"
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 40.0
#: unit = "m"
#: meaning = "distance to the ego at which it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.2
#: high = 1.9
#: unit = "m"
#: meaning = "how far it swerves"

param OPT_ADV_SPEED = Range(4, 10)
param OPT_ADV_DISTANCE = Range(12, 40)
param OPT_SWERVE = Range(1.2, 1.9)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
