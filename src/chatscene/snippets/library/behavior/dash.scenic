#: description = "The pedestrian dashes across the road at a run."
#: rephrasings = [
#:   "A runner sprints over the street in front of the ego and does not slow down.",
#:   "The pedestrian races through the lane from one kerb to the other.",
#:   "A child chasing a ball tears across the carriageway.",
#:   "Someone bolts over the road at top speed right before the vehicle.",
#:   "The person hurries across flat out, without looking.",
#:   "This kid legs it across right before our bumper.",
#:   "The pedestrian darted into the path of Vehicle 1 while running.",
#:   "The child target crosses the VUT's path at running speed.",
#:   "Some kid bolted over the road right in front of me, going like the clappers.",
#:   "Juvenile pedestrian darted into the street and ran to the other side.",
#:   "Child darts out, running, straight over.",
#:   "The child pedestrian target accelerates from rest to running speed and passes in front of the VUT.",
#:   "A boy runs suddenly over the street to other side.",
#:   "Dart-out ped, runs all the way through without stopping or turning back.",
#:   "She broke into a run off the pavement and was over to the other side in three breaths.",
#:   "Kid's making a run for it, he's going right over, brakes!",
#:   "little kid just ran out n over the road my mom screamed",
#:   "A schoolboy tore over the road chasing a football, missing a car by inches.",
#:   "The child did not walk, he ran, and he kept running until he had reached the opposite pavement?",
#:   "One small boy suddenly came running and crossed full road, so dangerous.",
#:   "Nipper goes haring over in front of my cab, not a glance left or right.",
#:   "Sudden running crossing by pedestrian from roadside.",
#:   "KID BOLTS ACROSS STREET - TOO CLOSE",
#:   "A girl rocketed over the road on foot.",
#:   "Girl hurtling from verge to verge, flat-out, never breaking stride.",
#:   "Foot-race over the highway: jogger sprinting right through your path",
#:   "Have somebody pelt over the street before the AV, start to finish.",
#:   "Il court, he runs like a crazy from one trottoir to other.",
#:   "Pedestrian, running, kerb to kerb, no pause. Nearside to offside.",
#:   "The old soldier surprised us all: seeing the bus on the far side about to leave, he took off and galloped over the whole street without once slackening.",
#:   "I'd barely noticed the woman with the shopping bags before she was off at full tilt, and before I'd touched the pedal she had reached the far pavement.",
#:   "He'd got to the opposite kerb by the time I stopped shaking, having come out at a flat run and kept it up all the way over.",
#:   "A pupil late for school hurled himself over the carriageway at top speed yesterday, passing just in front of a robotaxi and disappearing through the gates on the other side.",
#:   "For VRU case 7 the dummy shall be released from standstill, reach 3 m/s within one metre and maintain that speed until it has cleared the far lane.",
#:   "Watch that teenager with the headphones, she's not going to wait, is she? There, off like a greyhound, and she's run clean across to the other side.",
#:   "I was cycling behind the driverless car, so I had a perfect view of it. A man in a suit, briefcase flapping, broke from between the planters and raced over the road as fast as his legs would carry him, and he was on the far side before the car had finished reacting.",
#:   "Vehicle 1 was travelling north at approximately 28 mph. The pedestrian, who had been standing on the west sidewalk, took off running on an eastbound path through the travel lanes and maintained that run until she was safely upon the east sidewalk. No contact occurred.",
#:   "It was like when we play tag. The big boy said \"catch me\" and he ran super fast over the whole road, right in front of Daddy's car, and he didn't stop till he was at the ice cream shop, and Daddy said a word.",
#:   "I want the system to meet a person in a real hurry. They wait at the roadside, and once we're close they set off like a sprinter from the blocks and rush over the entire carriageway to the other side, neither slowing in our lane nor thinking better of it.",
#:   "You must understand, in my city the people they cross how they want. This time one fellow with a helmet in hand suddenly went full speed running over the road just ahead of my car, and he finished the crossing also running, not looking once.",
#:   "Pensioner at a gallop, this pavement to that pavement, no let-up.",
#:   "Runner crosses! Never broke step, up the far kerb and gone.",
#:   "Zoom went the boy, all the way to the other side.",
#:   "Until yesterday I'd have said no woman in heels could cover the width of Fleet Street in three seconds, but she did it before our taxi's very lamps.",
#:   "V1 braked for a male pedestrian who left the east curb at a sprint; he attained the west curb still sprinting and was not struck.",
#:   "Someone's hat blew to the opposite footpath, you say, and its owner pelted after it over the entire roadway, before your bumper, without a check?",
#:   "Simulate an impatient commuter: stands at the edge, then legs pumping across both lanes as we come, and it isn't till the far kerb that the pumping ends.",
#:   "Der Mann stands quiet at the roadside, suddenly he gives full gas with his legs and is over the street, he stopped not once.",
#:   "Keep your foot over that brake, because those lads race one another to the chippy; there goes the first, hell for leather, clean over to the far side.",
#:   "We'd both had a long shift and there was hardly a soul about. I remember a flash of orange on the left, which was a hi-vis jacket, then the same jacket between our headlights, then the same jacket going up the steps of the station on the right, all of it in the time it takes to sneeze.",
#:   "Trainers squeaking on wet tarmac was what made me look up from my sandwich. A lad of about sixteen had launched himself off the pavement in front of a blue car and he kept those trainers squeaking all the way to the opposite side, never a stutter, though the car's horn was going like billy-o.",
#:   "I'm told it was only her bus that she wanted. She'd been waiting as good as gold by the pillar box. Then she hitched up her coat and she flew, and she was still flying when she went between the bollards over the road, and behind her there was a smell of my brake pads.",
#:   "The plaintiff's own account is that he \"thought he could make it\". He made it. He ran out of the doorway of the betting shop, he ran through the path of my client's lorry, he ran on to the pavement beyond. It was the motorcyclist who braked behind my client that did not fare so well.",
#:   "Pedestrian speed profile, dart-out subtype: standing for 2.0 s at the kerb, then a steep rise to 4.5 m/s, after which the curve is flat until the far boundary of the road is reached. There is no plateau of hesitation and no drop in front of the vehicle under test; the runner simply clears.",
#:   "When you're a cabby you learn that drunks dawdle and thieves don't. This fella had a handbag under his arm that didn't match his shoes. He hit the road at a full run right ahead of me and left it at a full run on the other side, and the lady who owned the bag was still shouting.",
#:   "Was it a fox? That's what we asked each other in the car, it went so quick. But foxes don't wear school blazers. He must have started from behind the hedge, passed through the beam of our lights with his satchel straight out behind him, and dived in at the gates opposite.",
#:   "Between the ice-cream van and the swings lies Marsh Lane, and on that lane was I, at twenty, thank heaven. A small girl with a cone in each hand made the trip without any idea of me. Her little legs were a blur from the one verge to the other, and she didn't spill a drop.",
#:   "I do not blame the robot car, it braked very correct. The person was waiting with the telephone in the hand, then it looks at the tram, which is arriving, and it runs. It runs off our sidewalk, it runs in front, it runs up on the island for the tram, everything in one piece, without a stop.",
#:   "Hold the trigger until the car is close enough that a person would think twice. This person doesn't. They go from standing to flat out within a stride or so, and what the ego sees is a side-on sprinter who's out of its lane again almost as soon as they're in it, bound for the far side.",
#:   "On this week's episode, near misses. Dave from Hull was driving his nan to bingo when a jogger he'd taken for a stationary one, you know, stretching against a wall, pushed off that wall like a swimmer and went straight over the road in front of him. Didn't slow in the middle, either. Nan applauded.",
#:   "One kerb to the other in two heartbeats: the newspaper boy.",
#:   "sis ran over like the floor was LAVA, whole road, no stops",
#:   "Child target: rest, sprint, far pavement. Single burst, perpendicular path.",
#:   "What I braked for was a streak of school uniform, which had been at the bakery before me and was at the bank, opposite, before my tyres stopped squealing.",
#:   "Nobody walks a road that way: knees up, scarf level in the wind, from our left-hand footpath to the right-hand one without so much as a look.",
#:   "She'd left one of her shoes in our lane, and by the time we noticed it she was on the far pavement, hopping, such was her hurry over.",
#:   "Give me a jogger who treats our road as the last twenty metres of a race, with the tape on the opposite kerb, and who goes through it at our front.",
#:   "Because the rain had come down all at once, a man with a folder on his head pelted from the arcade on this side to the arcade on that one, right before our tram.",
#:   "By V1's driver the pedestrian was perceived as \"a blur, then a back\": running legs leaving the nearside kerb, and, before the brakes bit, a back vanishing into the crowd opposite.",
#:   "I keep the window open for the smoke, so I got the sound of it. Slap, slap, slap, slap, quick as clapping, starting at my left ear. It went by in front of the grille while I was still finding the pedal, and it finished at my right, on the other pavement, without there having been a single beat missing.",
#:   "The bus for the airport was on the other side with its doors already hissing. You can guess the rest. There was a girl at the kerb with a rucksack; then there was no girl at the kerb, there was a rucksack bouncing before my bumper; then there was a bus with its doors shut and her inside it. I'd got down to about five miles an hour.",
#:   "Exhibit C is the shop camera, four frames a second. In frame one the young man has both feet on the eastern pavement. In frame two he's in the nearer lane, leaning like a sprinter. In frame three, the further lane. In frame four he is on the western pavement. My client, I submit, had three quarters of a second to make his acquaintance.",
#:   "I am a cyclist and I was drafting the car, so I had no warning except its brake lamps. I looked left, nothing, looked right, and there was the reason: some old boy in a raincoat just reaching the opposite verge, arms still pumping. To be there by then he must have covered the lanes at a rate I couldn't have held on my bike.",
#:   "Our test manager was not satisfied with the walking dummies. \"People in a hurry exist,\" he said. So in run 30 the mannequin is held at the edge until the ego is close. Then the belt takes it over the entire width at five metres per second, and the run only counts if it gets to the opposite edge without any change in that figure.",
#:   "The dog came first and got over, God forgive me. I'm seventy-nine. But where a dog has gone there's a boy to follow, and there he was, all elbows, so quick that I saw him on my left and on my right and can't tell you about the middle. I'd only just begun to press the brake when he was hugging it on the far grass.",
#:   "Ladies and gentlemen of the podcast, an experiment. Say \"one elephant\". In that time the lady at the crossing place who isn't at the crossing place leaves the pavement with her skirt in her fist. Say \"two elephant\". She's in front of us, going like a hare. Say \"three elephant\". She has the opposite railings in her hands, and I've coffee all over the dash.",
#:   "The funny thing is I never saw him start. I noticed pigeons go up on the left and a cap in the air. Under the cap, when I looked, was nobody. He was already past my nearside lamp, then past the offside one, and the last of him was a pair of soles going up on to the other footway. The cap came down on my bonnet. Still got it.",
#:   "Para mí it was a ghost. The street is empty, I go tranquil at forty. From behind the ice cream cart a woman in white comes as the wind, all the street from this border to the other, and I hear her sandals, taca taca taca. When my car is finally stopped, the only thing that moves is a curtain in the door at the other side.",
#:   "Tell the pupil to name what's about to happen, and mine said: he's going to wait. Fair enough. But his weight was on the front foot, his eyes were on the betting shop opposite, and it was two minutes to the off. I had the dual brake down while he was still a yard from our wing, and when we'd stopped rocking he'd been in the shop some time.",
#:   "Nothing in the reconstruction requires the runner to have paused, and the blood pressure monitor on her wrist says she did not. It shows rest up to 09:14:06. For the following three seconds, which is the time needed for eleven metres of carriageway, it shows the effort of someone going all out. At 09:14:09, by which moment V1 was braking, she was on the other side.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to run"

param OPT_ADV_SPEED = Range(3.5, 7)
param OPT_ADV_DISTANCE = Range(6, 18)

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
