"""A document that nobody here has seen: its formulas, their letters, and what can be said without a declaration.

`files`, `macros` and `latex`, `markdown` or `restructured` take the formulas from the source; `survey` reads each of
them alone, `letters` joins what is known of the letters, `checks` asks the questions and `structure` looks at the form;
`look` does all of it.
"""
