language-name = Deutsch
language-direction = ltr
language-quoted = „{ $text }“
