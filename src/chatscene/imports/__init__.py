"""Before the method: scenarios of other tools' formats, made programs of this world or refused by name."""
