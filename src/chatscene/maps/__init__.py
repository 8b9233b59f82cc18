"""Road networks: the packaged town, the reader of users' maps, and the finder of routes on either."""
