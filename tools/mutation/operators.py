"""The operators: each names edits of a body, (operator, start, end, replacement), and none looks at any test.

What they make need not compile; what doesn't is dropped when the mutants are built.
"""

from mutation.operators_flow import FLOW
from mutation.operators_types import TYPES
from mutation.operators_values import VALUES

OPERATORS = {**VALUES, **FLOW, **TYPES}


def edits_of(body, context):
    """All edits, in the order of the operators and then of the source.

    @param context  a mutation.operators_types.Context
    """
    for name, operator in OPERATORS.items():
        for start, end, text in operator(body, context):
            yield name, start, end, text
