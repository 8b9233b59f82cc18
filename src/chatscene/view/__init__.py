"""A page on loopback over all runs below a folder, in which a sentence is said, changed and run."""
