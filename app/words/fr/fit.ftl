fit-about = Un tableau déposé sur la page est dessiné par-dessus l’objet, et la scène peut y être ajustée. { $link } en donne un.
    .link = Mesurer dans une vidéo
fit-table = { $count ->
    [one] <b>{ $name }</b> : { $count } ligne. Quelle grandeur est chaque colonne ?
   *[other] <b>{ $name }</b> : { $count } lignes. Quelle grandeur est chaque colonne ?
}
fit-run = Essai
fit-column = comme mass1.x, -mass1.y, 90 - spring0.direction ou une formule ; vide pour l’ignorer
fit-scale = { $unit } par mètre
    .hint = combien mesure un mètre du tableau dans la scène
fit-sought = Que cherche-t-on ?
fit-start = Départ (positions, vitesses)
fit-origin = Origine du tableau
fit-length-scale = Échelle des longueurs
fit-fit = Ajuster
fit-forget = Oublier le tableau
fit-begins = L’ajustement commence…
fit-goes-on = Ajustement : { $what }…
fit-cannot = <b>L’ajustement est impossible</b> : { $why }.
fit-error = Une erreur s’est produite sur le serveur.
fit-no-table = il n’y a pas de tableau
fit-many-masses = une page ajuste au plus { $count } masses ; softrod fit en accepte plus
fit-many-numbers = une page ajuste au plus { $count } nombres ; softrod fit en accepte plus
fit-no-scale = écris combien de { $unit } de la scène font un mètre, 0.000001..1e9, ou fais chercher l’échelle des longueurs
fit-choose = choisis de 1 à { $most } nombres à chercher, et non { $count }
fit-compiling = le solveur est encore en cours de compilation ; réessaie dans un instant
fit-changed = la scène a été modifiée entre-temps ; ajuste-la de nouveau
fit-left = { $column } : il reste { $noise }.
