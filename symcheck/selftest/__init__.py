"""Plants faults and counts those that go unnoticed: the error rate of the audit itself.

`run` plants them, `table` shows the counts; `trial` is what a module that declares a class of faults starts from.
"""

__all__ = ["run", "table", "trial"]
