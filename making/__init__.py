"""What makes the files that chatscene packages: its maps and the weights of its reader. None of it is in the wheel."""
