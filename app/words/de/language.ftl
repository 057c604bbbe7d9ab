language-name = Deutsch
language-direction = ltr
language-comma = { $before }, { $after }
language-semicolon = { $before }; { $after }
