time-bar = Temps
    .more = Plus sur le temps
time-go-on = Continuer à partir d’ici
    .word = Continuer
time-speed = Vitesse
    .hint = Secondes simulées par seconde
time-shown = Instant affiché
    .said = { $seconds ->
        [one] { $seconds } seconde
       *[other] { $seconds } secondes
    }
time-lost = Avant { $seconds } s, il s’est passé trop de choses pour tout garder.
time-past = La ligne fine montre ce qui s’est passé avant ton retour en arrière.
time-stands = Moins de mouvement est souhaité : l’objet reste immobile jusqu’à ce que tu appuies sur Lancer.
