"""What holds for every test: none depends on the clock."""

import gc

from hypothesis import HealthCheck, settings

settings.register_profile("any machine", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("any machine")

gc.set_threshold(20_000, 20, 20)  # maps and libraries, which stay, are looked through by the collector less often
