hud-stopped = angehalten
hud-past = Rückblick
hud-paused = Pause
hud-rest = in Ruhe
hud-slow = verlangsamt: { $factor } × Echtzeit
hud-behind = so schnell kann der Körper nicht folgen: Die Hand ist { $distance } zurück
hud-broken = { $count ->
    [one] { $count } Feder gebrochen
   *[other] { $count } Federn gebrochen
}
hud-yielded = { $count ->
    [one] { $count } Feder bleibend verformt
   *[other] { $count } Federn bleibend verformt
}
hud-squeezed = gestaucht
    .stretched = gedehnt
hud-step = Zeitschritt { $step } ms, { $percent } % der Grenze
    .unstable = Zeitschritt { $step } ms, { $percent } % der Grenze: instabil
    .explodes = Zeitschritt { $step } ms, { $percent } % der Grenze: instabil, explodiert bei Berührung

card-sine = Sinus
card-cosine = Kosinus
card-angle = Winkel
card-rest-angle = Ruhewinkel
card-of = von { $count }
card-mass = Masse { $mass }
card-joint = Gelenk { $joint }
    .of = Gelenk { $joint } (von { $count } hier)
card-x = x
card-y = y
card-speed = Tempo
card-stiffness = Steifigkeit

rates-factor = Faktor zur Echtzeit
rates-steps = Schritte pro Sekunde
rates-solver = Löser, je Bild
rates-behind = Uhr im Rückstand um
rates-rejected = verworfen pro Sekunde
rates-fallbacks = Ersatzschritte

errors-title = Vorhersagbarkeit
    .compiled = kommt, sobald sie übersetzt ist
    .held = keine Masse ist frei
errors-grow = Fehler wachsen
    .measured = wird gemessen, eine Sekunde lang
errors-factor = Fehler wachsen, letzte Sekunde
errors-rate = Rate
errors-time = Zeit bis zum e-fachen
    .none = keine
errors-solver = ihr Löser, je Bild

tuning-slowest = langsamste Schwingung
tuning-elastic = langsamste elastische
tuning-fastest = schnellste Schwingung
tuning-calm = ruhig nach
    .after = { $time }, auf ein Zehntel
    .never = nie: ungedämpft
tuning-sag = Durchhang unter Schwerkraft
    .loads = Durchhang unter Lasten
    .value = { $sag }, Masse { $mass }
tuning-stable = stabil bis { $step } ms
    .always = stabil bei jedem Schritt
tuning-spring = Feder { $spring } allein
tuning-spring-fastest = schnellste Feder allein
tuning-rate = { $frequency } Hz, { $period }, Dämpfungsgrad { $ratio }
    .undamped = { $frequency } Hz, { $period }, ungedämpft
    .none = keine
tuning-one-linear-stiffness = 1 % mehr Steifigkeit der Federn
tuning-one-angular-stiffness = 1 % mehr Steifigkeit der Gelenke
tuning-one-gravity = 1 % mehr Schwerkraft
tuning-more-sag = { $sag } mehr Durchhang
tuning-less-sag = { $sag } weniger Durchhang
tuning-faster = { $percent } % schneller
tuning-slower = { $percent } % langsamer

ghost-title = Geist
    .compiled = { $ghost }: kommt, sobald er übersetzt ist
    .tolerance = Toleranz / { $finer }
    .step = Schritt / { $finer }
ghost-distance = Abstand jetzt
ghost-worst = größter Abstand
ghost-solver = Löser des Geists, je Bild
ghost-error = jeder Fehler wächst
    .factor = × { $factor } in einer Sekunde
ghost-stopped = Geist angehalten
    .why = er ist explodiert

energy-title = Energie
    .compiled = wird verfolgt, sobald sie übersetzt ist
energy-unit = Einheit
energy-kinetic = Bewegung
energy-gravity = Höhe
    .loads = Höhe und Lasten
energy-linear = Federn
energy-angular = Drehfedern
energy-walls = Tiefe in Wänden
energy-fillings = Gase und Flüssigkeiten
energy-contact = Kontakt
energy-anchors = Arbeit deiner Hand
energy-damping = durch Dämpfung verloren
energy-air = an Luft und Medium verloren
energy-friction = an Wände, Boden, Kontakt verloren
energy-plastic = durch bleibende Verformung verloren
energy-broken = durch Brechen verloren
energy-law = vom Gesetz des Tutorials erzeugt
energy-keys = Arbeit der Tasten
energy-muscles = Arbeit der Muskeln
energy-motors = Arbeit der Motoren
energy-changes = Änderungen von Einstellungen
energy-fallbacks = in Ersatzschritten verloren
energy-residual = Rest: Fehler des Verfahrens

about-edit = Name und Text bearbeiten
    .new = Dieser Szene einen Namen geben und sagen, was sie zeigt
