#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "base scenario lane-changing; own code"
#: [variants]
#: follow-lane           = { actions = ["follow"], adv_speed = [4, 9] }
#: crawl-in-lane         = { actions = ["slow"], adv_speed = [0.8, 3.2] }
#: oncoming-drive        = { actions = ["oncoming", "follow"], adv_speed = [4, 10], position = "oncoming", origin = "base scenario vehicle-passing; own code" }
#: oncoming-bypass-creep = { actions = ["oncoming", "slow"], adv_speed = [1.5, 3.5], position = "oncoming", maneuver = "bypass", adversaries = ["car", "truck", "bus", "bicycle"], origin = "own code" }
#: [descriptions]
#: follow-lane           = "The car drives along its lane at a steady speed."
#: crawl-in-lane         = "The car drives extremely slowly along its lane."
#: oncoming-drive        = "The oncoming car keeps coming along its lane."
#: oncoming-bypass-creep = "The oncoming car crawls toward the ego while it goes around the obstacle."

param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it drives

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
