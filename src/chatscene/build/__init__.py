"""From a situation to a program: a query for the place, a start and a plan for everybody, timed to meet the ego."""
