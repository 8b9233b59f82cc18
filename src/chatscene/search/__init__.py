"""Steps 5 to 7 of 9: toward collision."""
