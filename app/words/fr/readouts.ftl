hud-stopped = arrêté
hud-past = retour en arrière
hud-paused = en pause
hud-rest = au repos
hud-slow = ralenti : { $factor } × le temps réel
hud-behind = l’objet ne peut pas suivre si vite : la main est { $distance } trop loin
hud-broken = { $count ->
    [one] { $count } ressort cassé
   *[other] { $count } ressorts cassés
}
hud-yielded = { $count ->
    [one] { $count } ressort déformé de façon permanente
   *[other] { $count } ressorts déformés de façon permanente
}
hud-squeezed = comprimé
    .stretched = étiré
hud-step = pas de temps { $step } ms, { $percent } % de la limite
    .unstable = pas de temps { $step } ms, { $percent } % de la limite : instable
    .explodes = pas de temps { $step } ms, { $percent } % de la limite : instable, explose si on y touche

card-sine = sinus
card-cosine = cosinus
card-angle = angle
card-rest-angle = angle au repos
card-of = sur { $count }
card-mass = Masse { $mass }
card-joint = Articulation { $joint }
    .of = Articulation { $joint } (sur { $count } ici)
card-x = x
card-y = y
card-speed = vitesse
card-stiffness = raideur

rates-factor = facteur de temps réel
rates-steps = pas par seconde
rates-solver = solveur, par image
rates-behind = retard de l’horloge
rates-rejected = rejetés par seconde
rates-fallbacks = pas de secours

errors-title = prévisibilité
    .compiled = arrive une fois compilée
    .held = aucune masse n’est libre
errors-grow = croissance des erreurs
    .measured = en cours de mesure, pendant une seconde
errors-factor = croissance des erreurs, dernière seconde
errors-rate = taux
errors-time = temps pour croître d’un facteur e
    .none = aucun
errors-solver = son solveur, par image

tuning-slowest = oscillation la plus lente
tuning-elastic = oscillation élastique la plus lente
tuning-fastest = oscillation la plus rapide
tuning-calm = calme après
    .after = { $time }, au dixième
    .never = jamais : non amorti
tuning-sag = affaissement dû à la pesanteur
    .loads = affaissement dû aux charges
    .value = { $sag }, masse { $mass }
tuning-stable = stable jusqu’à { $step } ms
    .always = stable quel que soit le pas
tuning-spring = ressort { $spring } seul
tuning-spring-fastest = ressort seul le plus rapide
tuning-rate = { $frequency } Hz, { $period }, taux d’amortissement { $ratio }
    .undamped = { $frequency } Hz, { $period }, non amortie
    .none = aucune
tuning-one-linear-stiffness = 1 % de plus de raideur des ressorts
tuning-one-angular-stiffness = 1 % de plus de raideur des articulations
tuning-one-gravity = 1 % de plus de pesanteur
tuning-more-sag = affaissement augmenté de { $sag }
tuning-less-sag = affaissement diminué de { $sag }
tuning-faster = { $percent } % plus rapide
tuning-slower = { $percent } % plus lent

ghost-title = fantôme
    .compiled = { $ghost } : arrive une fois compilé
    .tolerance = tolérance / { $finer }
    .step = pas / { $finer }
ghost-distance = distance actuelle
ghost-worst = plus grande distance
ghost-solver = solveur du fantôme, par image
ghost-error = toute erreur croît
    .factor = × { $factor } en une seconde
ghost-stopped = fantôme arrêté
    .why = il a explosé

energy-title = énergie
    .compiled = est suivie une fois compilée
energy-unit = unité
energy-kinetic = cinétique
energy-gravity = altitude
    .loads = altitude et charges
energy-linear = ressorts linéaires
energy-angular = ressorts angulaires
energy-walls = enfoncement dans les parois
energy-fillings = gaz et liquides
energy-contact = contact
energy-anchors = travail de ta main
energy-damping = perdue par amortissement
energy-air = perdue dans l’air et le milieu
energy-friction = perdue contre parois, sol, contact
energy-plastic = perdue en déformation permanente
energy-broken = perdue en ruptures
energy-law = créée par la loi du tutoriel
energy-keys = travail des touches
energy-muscles = travail des muscles
energy-motors = travail des moteurs
energy-changes = changements de réglages
energy-fallbacks = perdue dans les pas de secours
energy-residual = reste : erreur de la méthode

about-edit = Modifier le nom et le texte
    .new = Nommer cette scène et dire ce qu’elle montre
