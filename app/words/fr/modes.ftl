modes-strip = Modes propres
modes-close = Fermer les modes propres
    .hint = Fermer
modes-how = Pointe une barre, ou va dessus avec Tab, pour voir sa forme. Monte-la : l’objet oscille ainsi. Appuie et maintiens, ou maintiens Espace : l’objet est excité.
modes-looking = Recherche des modes propres en cours.
modes-none = Pas de modes propres : { $why }.
modes-still = il n’oscille pas autour de sa position de repos
modes-shown = Les modes propres sont affichés au-dessus de la barre de temps
modes-reading = { $swings ->
    [no] Mode { $number } : { $frequency } Hz, { $amplitude }, n’oscille pas, { $share } de l’énergie
   *[yes] Mode { $number } : { $frequency } Hz, { $amplitude }, taux d’amortissement { $damping }, { $share } de l’énergie
}
modes-reading-driven = { $swings ->
    [no] Mode { $number } : { $frequency } Hz, { $amplitude }, n’oscille pas, excité
   *[yes] Mode { $number } : { $frequency } Hz, { $amplitude }, taux d’amortissement { $damping }, excité
}
modes-others = Dans aucun de ceux-ci : les modes plus rapides, et ce qu’un grand mouvement a de plus que les petits : { $share } de l’énergie
    .lacks = Dans aucun de ceux-ci : les modes plus rapides, et ce qu’un grand mouvement a de plus que les petits ; les modes seuls auraient { $share } de plus
    .word = autres
modes-share = { $percent } %
    .least = moins de 0,1 %
modes-bar = Mode { $number }, { $frequency } hertz
    .others = Dans aucun mode
modes-value = { $amplitude }, { $share } de l’énergie
modes-driven = Le mode { $number } est excité
modes-level = Mode { $number } : { $percent } pour cent d’une barre pleine
modes-volume = Volume
modes-sound = Son des modes propres
    .on = Son : activé
    .off = Son : désactivé
