"""A server that speaks the protocol of CARLA 0.9.16 over our bodies: a stand-in, not CARLA."""
