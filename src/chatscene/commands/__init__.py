"""The command line: one verb or family of verbs a file."""

from chatscene.files.class_code import keep_class_code

keep_class_code()
