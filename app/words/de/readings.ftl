# Was ein Schritt einer Lektion misst, verlangt und beim Laufen tut.

reading-stretch = Dehnung
reading-force = Kraft
reading-length = Länge
reading-angle = Winkel
reading-torque = Drehmoment
reading-speed = Geschwindigkeit
reading-vx = Geschwindigkeit vx
reading-vy = Geschwindigkeit vy
reading-momentum-x = Impuls in x-Richtung
reading-momentum-y = Impuls in y-Richtung
reading-distance = Abstand
reading-time-step = Zeitschritt als Teil seiner Grenze
reading-of = { $owner ->
    [mass] { $what } von Masse { $number }
    [spring] { $what } von Feder { $number }
    [joint] { $what } von Gelenk { $number }
   *[body] { $what } des Körpers
  }
reading-period = Periodendauer von { $what }
reading-period-of = { $owner ->
    [mass] Periodendauer von Masse { $number }
    [spring] Periodendauer von Feder { $number }
    [joint] Periodendauer von Gelenk { $number }
   *[body] Periodendauer des Körpers
  }

goal-between = { $reading }: { $low } bis { $high }
goal-least = { $reading }: mindestens { $low }
goal-most = { $reading }: höchstens { $high }
goal-held = { $goal }, { $seconds } s lang

run-choice = { $choice }: { $option }
run-many = { $count ->
   *[other] { $count } Massen werden zur Seite gezogen und losgelassen
  }
run-pull = Masse { $mass } wird { $way } gezogen und losgelassen
run-way =
  .right = { $length } nach rechts
  .left = { $length } nach links
  .down = { $length } nach unten
  .up = { $length } nach oben
run-ways = { $one } und { $other }
run-led = { $count ->
    [one] Masse { $masses } wird auf einem Kreis von { $radius } geführt, { $times }-mal in der Sekunde
   *[other] Massen { $masses } werden auf einem Kreis von { $radius } geführt, { $times }-mal in der Sekunde
  }
run-rests = { $count ->
    [one] der Muskel an Gelenk { $joints } ruht
   *[other] die Muskeln an den Gelenken { $joints } ruhen
  }
run-muscles = { $count ->
    [one] ein Muskel bewegt sich zu einem anderen Zeitpunkt oder um einen anderen Winkel
   *[other] { $count } Muskeln bewegen sich zu einem anderen Zeitpunkt oder um einen anderen Winkel
  }
