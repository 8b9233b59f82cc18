"""Steps 1 and 2 of 9: words."""
