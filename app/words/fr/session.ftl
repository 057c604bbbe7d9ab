session-cannot = Ce n’est pas possible
session-busy = la scène est occupée ; réessaie
session-not-resumed = la reprise a échoué : { $why }

session-exploded = L’objet a explosé
    .setting = Le pas de temps de { $step } s dépasse la limite de stabilité de { $limit } s, fixée par ce réglage : { $setting } { $value }. Le dernier bon état est affiché. Reviens juste avant, réduis l’un ou l’autre, et continue ; ou appuie sur « Réinitialiser ».
    .part = Le pas de temps de { $step } s dépasse la limite de stabilité de { $limit } s, fixée par cette raideur : { $part }. Le dernier bon état est affiché. Reviens juste avant, réduis-la ou choisis l’intégrateur Auto, et continue ; ou appuie sur « Réinitialiser ».
    .otherwise = Arrêté avant le pas { $step } : { $what } ; { $why }. Le dernier bon état est affiché. Reviens juste avant, { $remedy }, et continue ; ou appuie sur « Réinitialiser ».
session-what-number = la masse { $mass } aurait une position ou une vitesse qui n’est pas un nombre fini
session-what-position = la masse { $mass } est allée trop loin (plus de { $limit } px)
session-what-step = aucun pas n’est assez court à partir d’ici
session-what-speed = la masse { $mass } est devenue trop rapide (plus de { $limit } px/s)
session-why-law = la loi de force du tutoriel n’a pas d’énergie et peut faire bouger un objet de plus en plus vite
session-why-violent = l’objet a été déplacé ou réglé trop brutalement
session-why-violent-step = l’objet a été déplacé ou réglé trop brutalement pour ce pas de temps
session-why-small = le pas de temps est sous la limite de stabilité, mais celle-ci vaut pour de petits mouvements autour d’une position ; des mouvements grands ou rapides peuvent la dépasser
session-why-small-law = le pas de temps est sous la limite de stabilité, mais celle-ci vaut pour de petits mouvements autour d’une position ; des mouvements grands ou rapides peuvent la dépasser, et la loi de force du tutoriel n’a pas d’énergie et peut faire bouger un objet de plus en plus vite
session-remedy-law = déplace-le plus doucement, augmente l’amortissement ou choisis une autre loi de force
session-remedy-gently = déplace-le plus doucement ou augmente l’amortissement
session-remedy-step = réduis le pas de temps, choisis l’intégrateur Auto, augmente l’amortissement ou déplace-le plus doucement
session-cause-linear-stiffness = raideur d’étirement
session-cause-linear-damping = amortissement d’étirement
session-cause-angular-stiffness = raideur de flexion
session-cause-angular-damping = amortissement de flexion
session-cause-air-friction = frottement de l’air
session-cause-one-sided = ressorts à sens unique
session-cause-resistance = résistance
session-cause-walls = parois
session-cause-fillings = gaz et liquides
session-cause-contact = contact
session-cause-motors = moteurs
session-cause-pushes = poussées
session-cause-rails = rails

session-shape = Cette forme ne peut pas être gardée
    .line = { $why } La ligne montre où elle va.
    .button = { $why } Le bouton « La garder, { $times } fois plus raide » le permet.
    .both = { $why } La ligne montre où elle va. Le bouton « La garder, { $times } fois plus raide » permet de la garder.
    .text = { $why }

session-back-to = Revenir à « { $scene } »
    .undo = « Annuler » ramène à « { $scene } ».
    .redo = « Rétablir » ramène à « { $scene } ».
session-opening = ouverture de { $scene }
session-own-body = valeurs propres à l’objet
session-own-solver = valeurs propres au solveur

session-replay-ended = La relecture est terminée
    .taken = Tu as repris la main sur la relecture.
    .stuck = Elle ne peut pas continuer : { $why }.
    .agrees = Elle concorde avec le journal : { $verdict }.
    .differs = Elle ne concorde pas avec le journal : elle { $verdict }.
session-replayed = { $checks ->
    [one] { $steps } pas relus ; le contrôle concorde
   *[other] { $steps } pas relus ; les { $checks } contrôles concordent
}
    .digest = { $checks ->
    [one] { $steps } pas relus ; le contrôle concorde, empreinte { $digest }
   *[other] { $steps } pas relus ; les { $checks } contrôles concordent, empreinte { $digest }
}
session-differs = diffère d’abord au pas { $step }, t = { $time } s (contrôle { $check } sur { $checks } ; elle concorde au pas { $agreed }), { $how }
    .elsewhere = diffère d’abord au pas { $step }, t = { $time } s (contrôle { $check } sur { $checks } ; elle concorde au pas { $agreed }), { $how } ; le journal a été enregistré sur { $machine }, ceci est { $here }
session-differs-hidden = non par les positions et les vitesses, mais par ce qu’ont fait les touches, les dégâts ou le frottement
session-differs-apart = plus grande distance notée d’une masse { $distance }
session-differs-unknown = plus grande distance inconnue
session-too-heavy = cette image est trop lourde pour être lue dans une page ; `softrod run --inputs` peut le faire
session-log-plays = un journal est en cours de lecture ; il n’y a rien d’autre à enregistrer

session-awaited = bouge avec NumPy tant que { $what } n’est pas compilé : { $ready } éléments prêts sur { $count }
session-preparing = préparation ({ $what }) : { $ready } éléments prêts sur { $count }

session-errors-kept = Les erreurs ne croissent pas : une tolérance de { $tolerance } est respectée.
    .grow = Les erreurs croissent d’un facteur { $factor } en une seconde : une tolérance de { $tolerance } est respectée.
session-errors-step = Les erreurs ne croissent pas : un pas de temps plus court les réduit.
    .grow = Les erreurs croissent d’un facteur { $factor } en une seconde : un pas de temps plus court les réduit.
session-errors-lost = Les erreurs croissent d’un facteur { $factor } en une seconde : aucune tolérance ne peut garantir où sera l’objet dans { $seconds } s.
    .step = Les erreurs croissent d’un facteur { $factor } en une seconde : aucun pas de temps ne peut garantir où sera l’objet dans { $seconds } s.

session-plot-many = un graphique a de la place pour { $count } grandeurs
session-plot-units = un graphique a de la place pour deux unités, mais pas pour { $units }
session-mode-fast = le mode { $mode } a une période de { $period } s, moins de quatre pas de temps
