reading-stretch = allongement
reading-force = force
reading-length = longueur
reading-angle = angle
reading-torque = couple
reading-speed = vitesse
reading-vx = vitesse vx
reading-vy = vitesse vy
reading-momentum-x = quantité de mouvement selon x
reading-momentum-y = quantité de mouvement selon y
reading-distance = distance
reading-time-step = pas de temps, en fraction de sa limite
reading-of = { $owner ->
    [mass] { $what } de la masse { $number }
    [spring] { $what } du ressort { $number }
    [joint] { $what } de l’articulation { $number }
   *[body] { $what } de l’objet
  }
reading-period = période ({ $what })
reading-period-of = { $owner ->
    [mass] période de la masse { $number }
    [spring] période du ressort { $number }
    [joint] période de l’articulation { $number }
   *[body] période de l’objet
  }

goal-between = { $reading } : de { $low } à { $high }
goal-least = { $reading } : au moins { $low }
goal-most = { $reading } : au plus { $high }
goal-held = { $goal }, pendant { $seconds } s

run-choice = { $choice } : { $option }
run-many = { $count ->
    [one] { $count } masse est tirée sur le côté puis lâchée
   *[other] { $count } masses sont tirées sur le côté puis lâchées
  }
run-pull = la masse { $mass } est tirée { $way } puis lâchée
run-way =
  .right = de { $length } vers la droite
  .left = de { $length } vers la gauche
  .down = de { $length } vers le bas
  .up = de { $length } vers le haut
run-ways = { $one } et { $other }
run-led = { $count ->
    [one] la masse { $masses } est menée le long d’un cercle de rayon { $radius }, { $times } fois par seconde
   *[other] les masses { $masses } sont menées le long d’un cercle de rayon { $radius }, { $times } fois par seconde
  }
run-rests = { $count ->
    [one] le muscle de l’articulation { $joints } est au repos
   *[other] les muscles des articulations { $joints } sont au repos
  }
run-muscles = { $count ->
    [one] un muscle agit à un autre moment ou d’un autre angle
   *[other] { $count } muscles agissent à un autre moment ou d’un autre angle
  }
