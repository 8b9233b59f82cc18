"""Programs by an enemy, what each tries, and what stops it."""
