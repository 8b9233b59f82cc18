#: description = "The pedestrian crosses in fits and starts, stopping again and again."
#: rephrasings = [
#:   "A person moves over the road in short bursts with a pause after each.",
#:   "The walker repeatedly halts and sets off while crossing the lane.",
#:   "The pedestrian jerks across: a few steps, a stop, a few steps more.",
#:   "Someone crosses the carriageway stop-and-go, impossible to predict.",
#:   "The cyclist pedals over in spurts, standing still between them.",
#:   "She goes, stops, goes, stops: we can't make out what she wants.",
#:   "The pedestrian crossed intermittently, halting several times in the roadway.",
#:   "ped crosses in bursts, stop-start",
#:   "This girl on her phone kept stopping and starting all the way over the road.",
#:   "Ped x-ing: go, stop, go, stop, go.",
#:   "The pedestrian target crosses with repeated alternation of walking and standstill phases.",
#:   "The man goes, stands, goes, stands, many times until other side.",
#:   "Crosser with several dwells, start/stop cycles all across the lane.",
#:   "He took a few steps, froze, took a few more and froze again, and so he jerked his way over like a clockwork toy.",
#:   "He's walking, he's stopped, he's walking, he's stopped again, he just can't make up his mind.",
#:   "he was crossing like red light green light, stop go stop go stop",
#:   "The pedestrian advanced a few steps at a time, pausing over and over before reaching the far pavement.",
#:   "She walked, she stood, she walked, she stood; how many times, madam, four, five?",
#:   "The fellow is crossing in instalments, walking stopping walking stopping.",
#:   "Two steps and a rest, two steps and a rest, are we playing grandmother's footsteps?",
#:   "Intermittent crossing motion of pedestrian with multiple standstills in the carriageway",
#:   "PEDESTRIAN KEEPS PAUSING - stop motion crossing",
#:   "The woman jerks across the street, halting time after time.",
#:   "drunk lad crosing in jerks forward freeze forward freeze forward",
#:   "Have an old woman get over the road in many little instalments.",
#:   "Crossing ped halts, restarts, halts, restarts; prediction useless.",
#:   "Every few paces the boy with the kite came to a standstill while crossing.",
#:   "Across by fits: walk, wait, walk, wait, walk, wait.",
#:   "On her way over the road the lady with the pram kept pulling up, setting off again and pulling up once more, four or five times before she was across.",
#:   "The dummy's crossing motion consists of short bursts at 1.4 m/s, each followed by a standstill, the pattern being repeated for the full width of the carriageway.",
#:   "I must have braked half a dozen times, because whenever I believed the man would go he stood, and whenever I believed he'd stand he went another few feet.",
#:   "Give me a tourist who crosses our street staring at a map, taking three steps, stopping, taking three more, stopping again, and so forth till the other kerb.",
#:   "El niño crosses, he stops himself, he crosses a little more, again he stops, again he goes, so many times that I cannot calculate him.",
#:   "Don't guess with that one on the road, she sets off, she sticks, she sets off, she sticks, so we'll wait until she's on the pavement.",
#:   "You know the way a robin goes over a lawn? He was like that, the gentleman in the mac. A little run of steps and a stop, another little run and another stop, right over the street, and my number nine bus creeping and braking in time with him.",
#:   "Several witnesses concur that Pedestrian 1 did not cross the roadway in a continuous movement. She would advance a yard or two, stand, advance and stand again, and this cycle had taken place at least five times when V1 reached the crosswalk.",
#:   "Dash-cam gold: bloke's got a toddler's dropped biscuits or something to look at, so he makes a couple of steps over the road and stops, couple of steps and stops, and I'm counting out loud, six stops, seven stops, and he's still not at the far kerb.",
#:   "Please file under prediction. A pedestrian crosses ahead of the AV, and the velocity is a square wave: on for a second, zero for a second, on again, zero again. Each zero makes the planner release the brake, and each restart makes it slam it on.",
#:   "The lady was using a new hip, she told us later. It allowed her three steps at a time, and between one set of three and the next she had to stand and collect herself, and in this manner, starting and stopping, she won her way to the opposite side.",
#:   "Ped's over the street in hiccups, stock-still between each.",
#:   "Two paces, freeze, two paces, freeze: grandpa on his way across.",
#:   "Make a toddler cross in dribs and drabs, halting each time.",
#:   "He did it in portions, the gentleman with the dog, and after each portion of road they both stood a while before they undertook another.",
#:   "Repeatedly, from one kerb to the other, the pedestrian target shall walk for one second and stand for one second.",
#:   "I have counted five times that the young man stood still and five times that he went again, until he was finally on the other side.",
#:   "Because the woman kept freezing and thawing the whole way over the road, the subject vehicle's planner changed its mind at every few steps.",
#:   "texting girl, road, three steps, stops to type, three steps, stops to type, repeat till far pavement, me slowly losing the will to live",
#:   "Is the old lady crossing or isn't she, the learner asks, and the answer is both by turns: a bit of walking, a bit of standing, and so on.",
#:   "It's the tap of the stick I remember. Tap, tap, tap, nothing. Tap, tap, tap, nothing. My window was down, I was waiting, and the blind gentleman went from my left to my right in exactly this manner, and during each of the nothings he held up his face as if to smell whether I was there.",
#:   "Bus drivers have a name for those, we call them Morse coders. This one had a wheeled bag with a bad wheel, so she'd pull it a yard and it'd jam, she would stop and kick it, pull it another yard, stop and kick it again, right the way over my road. I made it seven kicks.",
#:   "The pedestrian's own account was that he \"kept checking.\" He entered from the east curb, took some steps and checked, that is, stood; took some steps and stood; and had done this four or five times when V1 reached him. He was then two steps short of the west curb and in motion.",
#:   "My son plays a game in which you may only move while the music's on. I told myself that the boy in front of our car was playing it also, as he'd run his couple of steps and stop dead, couple of steps and stop dead, with no music that we could hear, all over the street to the other side.",
#:   "On the velocity plot it looks like a comb. Each tooth is a little burst of walking at 1.3 m/s and between the teeth there's zero, and the comb is as long as the road is wide. No tooth tells you about the next one, so our robotaxi started six times and braked six times.",
#:   "She'd be all right once she was over, that's what she kept saying, and she said it every time she came to a halt. I was the one holding up the cars. A few steps, then her hip locked and she stood; when it let go there were a few steps more; and so in seven or eight goes we got her to the chemist's.",
#:   "Insured requests reimbursement of his clutch. The third party, a man looking for a contact lens, crossed the carriageway before him and did so by advancing, remaining, advancing and remaining, without let-up, up to the opposite kerb. The insured was obliged to move off and halt in the same rhythm.",
#:   "Please don't give me just one pause in the middle, we have that already. This walker should be pausing all the time. On with him for a second, off with him for a second or two, on, off, on, off, the whole breadth of the roadway, and nothing in his bearing to announce which is next.",
#:   "Sie ging, sie stand, sie ging, sie stand. The grandmother with the two sticks, I mean, who wanted to come over in front of my delivery van. With each little start I braked more and with each standing I thought now she lets me. It has repeated itself until she was at the other pavement.",
#:   "He moved across the square of light as a chessman is moved, by separate decisions. There was a step and a step, and then he was put down; and after a time he was taken up and put down once more, further over. The driver, whose lamps made the light, could not have told which of the stops would be the last.",
#:   "Junction camera shows an adult with pushchair. Southbound traffic is held up for thirty-eight seconds. Subject advances approximately one metre, ceases, advances approximately one metre, ceases, the cycle being repeated from the near kerb to the far. Reason unknown, a sleeping infant has been suggested.",
#:   "Three steps, statue, three steps, statue, until she'd crossed.",
#:   "The man with the map got over the street in instalments.",
#:   "Let somebody cross in dribs and drabs, freezing time and again.",
#:   "Every time I let the brake up he'd moved off, and every time he'd moved off he stuck again, so we did the whole width of the road in duet.",
#:   "The red coat was a metre on, then a metre on, then a metre on, with a long look at the sky each time, all the way to the other pavement.",
#:   "Between kerb and kerb the pedestrian target shall alternate between 1 s of motion and 1.5 s of rest, the number of cycles being given by the road's width.",
#:   "My dog pulls, I follow, he sniffs, I stand, and in that way, with eight or nine sniffs, we got across in front of the driverless car.",
#:   "No, don't wave her on, she's moving when you wave and standing when you don't, leave her, she'll be done after a few more of these.",
#:   "Seven times the auntie was stopped and seven times she was started before the far side has come, and my auto was coughing all the time.",
#:   "It was like watching the minute hand of a station clock. It stands, and you'd swear it was broken; it jumps; it stands. The gentleman with the oxygen bottle on wheels stood, went a yard, stood, went a yard. There are eleven yards of roadway at that spot, and I had my engine off by the third.",
#:   "I'd like to report not an accident but a nuisance. I drive the school bus. There is a woman who each morning films herself going over the road by the baths. She takes some paces. She stops for the pose. Some more paces, another pose. I've had up to ten poses between the two pavements, and you can't tell how long she'll hold one.",
#:   "Shuttle's speed in km/h, from the log: 9, 0, 6, 0, 5, 0, 6, 0, 4, 0. No fault was found in the drive. The fault was walking across ahead of it, a man looking at his shoes, and each of those zeros belongs to two steps that he took and each of those sixes to a halt he made, as far as the opposite kerb.",
#:   "In the game of chess you touch a piece and then you must move it. Out there someone was touching and moving himself, square by square. He'd be on the manhole. He'd think. He'd be on the white arrow, and think. On the crack, and think. That was my lane, the other lane, the gutter, and I daren't drive on any of his thinks.",
#:   "The footprints in the snow are quite something. They come in bunches. There's a bunch of three by the east curb, then two feet side by side, deep; a bunch of three, then two side by side; and so on, six bunches in total, the last at the west curb. V1's tracks, which come up to the fourth, are equally full of stops.",
#:   "What do you do when you can't predict somebody? You don't. This lad has his phone out, he's walking with his thumbs. When he types, he's rooted. When he's sent it, he's off, two steps, and there's the answer, so he's rooted. He's been doing it since the kerb and will do it to the other one. Handbrake.",
#:   "My hip's metal and my knee is plastic, and they don't talk to one another. So the way I get to the baker's is a bit of a hobble and a bit of a hold, and again, a bit of a hobble, a bit of a hold, right over Mill Road. I know that it's hard on the nerves. The young man got out and asked if I was stuck.",
#:   "A crowd on the terrace had started to count aloud. On \"four\" the bride, who'd lost a heel, was at the near wheel track. She stood. On \"five\" she was at the middle line, and stood. On \"six,\" on \"seven,\" on \"eight\" likewise. At \"nine\" there was a cheer as she gained the church side, and the hearse which had been waiting drove on.",
#:   "The lamp of the car made a stage of the lane, and on it the old actor performed as of old. He advanced. He was struck by something and remained so. He advanced, and was struck afresh. There was no telling what it was, or how often it might strike yet; the other pavement, when he had gained it at last, received him like the wings.",
#:   "I don't want him slow, and I don't want one dramatic pause. I'd like a stutter. Let the pedestrian go at a normal walk, but for a second only, and be as still as a post for the next, then go, be a post, go, be a post, from our left-hand kerb until the right-hand one, while the AV is coming up.",
#:   "So viele Male! Always I thought, now she goes through, she was going quite normal. And clack, she is standing, like one has taken the battery out. I roll, clack, somebody has put the battery in. I stop, battery out. We had this perhaps eight times, she and I, until she was at the side of the pharmacy and the battery could stay in.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes in a burst"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 20.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_BURST"
#: low = 0.6
#: high = 1.2
#: unit = "s"
#: meaning = "how long a burst lasts"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 0.8
#: unit = "s"
#: meaning = "how long it stands between bursts"

param OPT_ADV_SPEED = Range(1.5, 4)
param OPT_ADV_DISTANCE = Range(20, 48)
param OPT_ADV_BURST = Range(0.6, 1.2)
param OPT_STOP_TIME = Range(0.3, 0.8)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 18)
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_ADV_BURST seconds
        do Halt() until self.pose[3] < 0.1
        do Halt() for globalParameters.OPT_STOP_TIME seconds
