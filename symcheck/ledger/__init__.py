"""What an audit leaves: a record for each relation, and the files below generated/."""
