race-strip = Course
race-rule = Tous partent en même temps, sur le terrain de cet objet, et c’est le milieu de chacun qui compte à l’arrivée. Modifier cet objet et le terrain est permis, et noté ici ; « Recommencer » rend la course équitable.
race-choose = Course contre
    .paste = Colle un lien, ou choisis ci-dessous
    .link = Lien vers la scène à affronter
    .go = Courir
race-start = Partir
    .hint = Tous depuis le départ, après un compte à rebours
    .again = Recommencer
race-add = Ajouter
    .hint = Un autre objet se joint à la course
race-leave = Quitter
    .hint = Quitter la course ; cet objet continue seul
race-go = Partez !
race-begins = Course contre { $names }. { $start }.
race-left = Course quittée
race-own = { $name } (le tien)
race-other = { $name } (l’autre)
race-yours = Le tien

race-at-start = Au départ
race-so-far = { $verdict }, après { $seconds } s
race-unfair = { $verdict } ; modifié ou déplacé en chemin
race-ahead = { $own ->
    [yes] Le tien est en tête
   *[no] { $name } est en tête
}
race-ahead-by = { $own ->
    [yes] Le tien a { $distance } d’avance
   *[no] { $name } a { $distance } d’avance
}
race-close = Aucun des deux n’est en tête
    .many = Aucun n’est en tête
race-is-first = { $own ->
    [yes] Le tien gagne, après { $seconds } s
   *[no] { $name } gagne, après { $seconds } s
}
race-was-first = { $own ->
    [yes] Le tien a gagné, après { $seconds } s
   *[no] { $name } a gagné, après { $seconds } s
}
race-alone = { $own ->
    [yes] Le tien a gagné ; { $fates }
   *[no] { $name } a gagné ; { $fates }
}
race-won = { $own ->
    [yes] Le tien a gagné, avec { $seconds } s d’avance
   *[no] { $name } a gagné, avec { $seconds } s d’avance
}
race-won-before = { $own ->
    [yes] Le tien a gagné, { $seconds } s avant { $next }
   *[no] { $name } a gagné, { $seconds } s avant { $nextOwn ->
        [yes] le tien
       *[no] { $next }
    }
}
race-both = Les deux en même temps, après { $seconds } s
race-several = { $names } en même temps, après { $seconds } s
race-nobody = Personne n’a gagné : { $fates }
race-exploded = { $who ->
    [first] Le tien a explosé
    [own] le tien a explosé
    [both] les deux ont explosé
    [all] tous ont explosé
   *[other] { $name } a explosé
}
race-fell = { $who ->
    [first] Le tien a fait une chute
    [own] le tien a fait une chute
    [both] les deux ont fait une chute
    [all] tous ont fait une chute
   *[other] { $name } a fait une chute
}
race-away = { $who ->
    [first] Le tien a pris l’autre direction
    [own] le tien a pris l’autre direction
    [both] les deux ont pris l’autre direction
    [all] tous ont pris l’autre direction
   *[other] { $name } a pris l’autre direction
}
race-misfit = { $who ->
    [first] Le tien ne va pas sur ce terrain
    [own] le tien ne va pas sur ce terrain
    [both] les deux ne vont pas sur ce terrain
    [all] aucun ne va sur ce terrain
   *[other] { $name } ne va pas sur ce terrain
}
race-late = { $who ->
    [first] Le tien a mis plus de { $limit } s
    [own] le tien a mis plus de { $limit } s
    [both] les deux ont mis plus de { $limit } s
    [all] tous ont mis plus de { $limit } s
   *[other] { $name } a mis plus de { $limit } s
}

race-finish = Arrivée, { $way }
race-to = { $distance } devant
    .behind = { $distance } derrière
race-named = { $name }, { $way }

race-full = une course ne peut pas avoir plus de { $count } objets
race-unknown = { $text } n’est ni un lien vers une scène ni le nom d’une scène
