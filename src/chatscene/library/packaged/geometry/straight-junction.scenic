#: origin = "own code"
#: [slots]
#: maneuver = "straight"
#: [variants]
#: straight-junction                          = { place = "junction", origin = "base scenario crossing-negotiation; own code" }
#: straight-four-way                          = { place = "four-way", crossed = ["left", "right", "oncoming"] }
#: straight-signalised                        = { place = "four-way", crossed = ["left", "right", "oncoming"], control = "signal", origin = "base scenario red-light-running; own code" }
#: straight-stop-sign                         = { place = "four-way", crossed = ["left", "right", "oncoming"], control = "stop-sign", origin = "base scenario crossing-negotiation; own code" }
#: straight-unsignalised                      = { place = "four-way", crossed = ["left", "right", "oncoming"], control = "none", origin = "base scenario crossing-negotiation; own code" }
#: straight-junction-signalised               = { place = "junction", crossed = ["right", "oncoming"], control = "signal" }
#: straight-junction-stop-sign                = { place = "junction", crossed = ["right", "oncoming"], control = "stop-sign" }
#: straight-junction-unsignalised             = { place = "junction", crossed = ["right", "oncoming"], control = "none" }
#: straight-three-way                         = { place = "three-way", origin = "base scenario crossing-negotiation; own code" }
#: straight-three-way-side-left               = { place = "three-way", crossed = ["left"] }
#: straight-three-way-side-left-signalised    = { place = "three-way", crossed = ["left"], control = "signal" }
#: straight-three-way-side-left-stop-sign     = { place = "three-way", crossed = ["left"], control = "stop-sign" }
#: straight-three-way-side-left-unsignalised  = { place = "three-way", crossed = ["left"], control = "none" }
#: straight-three-way-side-right              = { place = "three-way", crossed = ["right", "oncoming"] }
#: straight-three-way-side-right-signalised   = { place = "three-way", crossed = ["right", "oncoming"], control = "signal" }
#: straight-three-way-side-right-stop-sign    = { place = "three-way", crossed = ["right", "oncoming"], control = "stop-sign" }
#: straight-three-way-side-right-unsignalised = { place = "three-way", crossed = ["right", "oncoming"], control = "none" }
#: [descriptions]
#: straight-junction                          = "The ego drives straight through an intersection."
#: straight-four-way                          = "The ego drives straight through a four-way intersection."
#: straight-signalised                        = "The ego drives straight through a signalised intersection on green while crossing traffic has red."
#: straight-stop-sign                         = "The ego goes straight through a four-way intersection with stop signs."
#: straight-unsignalised                      = "The ego goes straight through an unsignalised intersection and must negotiate the crossing."
#: straight-junction-signalised               = "The ego drives straight through an intersection of any kind with traffic lights."
#: straight-junction-stop-sign                = "The ego drives straight through an intersection of any kind with stop signs."
#: straight-junction-unsignalised             = "The ego drives straight through an intersection of any kind without traffic lights or signs."
#: straight-three-way                         = "The ego drives straight past a side road at a three-way intersection."
#: straight-three-way-side-left               = "The ego drives straight through a three-way intersection; the side road joins from the left."
#: straight-three-way-side-left-signalised    = "The ego drives straight through a three-way intersection with traffic lights; the side road joins from the left."
#: straight-three-way-side-left-stop-sign     = "The ego drives straight through a three-way intersection with stop signs; the side road joins from the left."
#: straight-three-way-side-left-unsignalised  = "The ego drives straight through a three-way intersection without traffic lights or signs; the side road joins from the left."
#: straight-three-way-side-right              = "The ego drives straight through a three-way intersection; the side road joins from the right."
#: straight-three-way-side-right-signalised   = "The ego drives straight through a three-way intersection with traffic lights; the side road joins from the right."
#: straight-three-way-side-right-stop-sign    = "The ego drives straight through a three-way intersection with stop signs; the side road joins from the right."
#: straight-three-way-side-right-unsignalised = "The ego drives straight through a three-way intersection without traffic lights or signs; the side road joins from the right."

param signals = 'ego-green'  #: if control signal
crossSignal = "red"  #: if control signal
egoRoute = selectRoute(maneuver="straight", place="$place")  #: unless crossed
egoRoute = selectRoute(maneuver="straight", place="$place", crossed=$crossed)  #: if crossed  #: unless control
egoRoute = selectRoute(maneuver="straight", place="$place", control="$control", crossed=$crossed)  #: if control
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")  #: if crossed left
trafficFromRight = trafficFrom(egoRoute, "right")  #: if crossed right
oncomingTraffic = trafficFrom(egoRoute, "oncoming")  #: if crossed oncoming
