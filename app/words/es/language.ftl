language-name = Español
language-direction = ltr
language-quoted = «{ $text }»
