"""The four generators that the paper compares with: one file each, and what they have in common in `nominal`."""
