"""A document that nobody here has seen: its formulas, their letters, what can be said without a declaration, its audit.

`files`, `macros` and `latex`, `markdown` or `restructured` take the formulas from the source; `survey` reads each of
them alone, `letters` joins what is known of the letters, `checks` asks the questions and `structure` looks at the form;
`look` does all of it. `paper` is the vocabulary of an audit that reads what it names, `lock` knows what was accepted,
`asked` decides, `scaffold` writes such an audit and brings it up to date, `rewriting` has its rules, `lint` its gaps.
"""
