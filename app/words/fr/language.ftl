language-name = Français
language-direction = ltr
language-quoted = « { $text } »
