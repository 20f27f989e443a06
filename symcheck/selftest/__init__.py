"""Plants faults and counts those that go unnoticed: the error rate of the audit itself."""
