"""The verbs of the command line as functions, and what they come to; `import chatscene` has them by their names.

A folder may be left out: a new one is made in the system's temporary folder then, and stays. Errors are those of
`chatscene.errors`, the same that the command line shows.
"""
