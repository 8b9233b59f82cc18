"""A server of the Model Context Protocol: what chatscene does, as tools of an agent, within one folder."""
