language-name = Türkçe
language-direction = ltr
language-comma = { $before }, { $after }
language-semicolon = { $before }; { $after }
