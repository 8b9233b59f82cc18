"""What every plug-in of a kind owes, as a function that a plug-in's own tests can call.

::

    from chatscene.testing import check_ego, check_sampler

    def test_my_ego_keeps_the_contract():
        check_ego("my_stack.driving:make_ego")

The project's own tests call the same functions over what is packaged. No test runner is needed: what is broken is a
`ContractBroken`, an `AssertionError` that says which rule.
"""

from chatscene.testing.contract import ContractBroken
from chatscene.testing.egos import check_ego
from chatscene.testing.encoders import check_encoder
from chatscene.testing.executors import check_executor
from chatscene.testing.exporters import check_exporter
from chatscene.testing.generators import check_generator
from chatscene.testing.language_models import check_language_model
from chatscene.testing.readers import check_reader
from chatscene.testing.samplers import check_sampler
from chatscene.testing.simulators import check_simulator

__all__ = [
    "ContractBroken",
    "check_ego",
    "check_encoder",
    "check_executor",
    "check_exporter",
    "check_generator",
    "check_language_model",
    "check_reader",
    "check_sampler",
    "check_simulator",
]
