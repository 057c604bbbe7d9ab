language-name = Español
language-direction = ltr
language-comma = { $before }, { $after }
language-semicolon = { $before }; { $after }
