language-name = Deutsch
language-direction = ltr
language-quoted = „{ $text }“
language-comma = { $before }, { $after }
language-semicolon = { $before }; { $after }
