race-strip = Yarış
race-rule = Hepsi bu cismin arazisinde, aynı anda başlar; bitişte her birinin ortası sayılır. Bu cismi ve araziyi değiştirmek serbesttir ve buraya not edilir; “Yeniden yarış” yarışı yine adil yapar.
race-choose = Rakip seç
    .paste = Bir bağlantı yapıştır veya aşağıdan seç
    .link = Yarışılacak sahnenin bağlantısı
    .go = Yarış
race-start = Başlat
    .hint = Hepsi geri sayımdan sonra baştan başlar
    .again = Yeniden yarış
race-add = Ekle
    .hint = Yarışa bir cisim daha katılır
race-leave = Çık
    .hint = Yarıştan çık; bu cisim tek başına devam eder
race-go = Başla!
race-begins = Yarış başlıyor; rakip: { $names }. { $start }.
race-left = Yarıştan çıkıldı
race-own = { $name } (seninki)
race-other = { $name } (öteki)
race-yours = Seninki

race-at-start = Başlangıçta
race-so-far = { $verdict }, geçen süre { $seconds } s
race-unfair = { $verdict }; yolda değiştirildi veya hareket ettirildi
race-ahead = { $own ->
    [yes] Seninki önde
   *[no] { $name } önde
}
race-ahead-by = { $own ->
    [yes] Seninki { $distance } önde
   *[no] { $name } { $distance } önde
}
race-close = İkisi de önde değil
    .many = Hiçbiri önde değil
race-is-first = { $own ->
    [yes] Seninki birinci, { $seconds } s sonunda
   *[no] { $name } birinci, { $seconds } s sonunda
}
race-was-first = { $own ->
    [yes] Seninki birinci oldu, { $seconds } s sonunda
   *[no] { $name } birinci oldu, { $seconds } s sonunda
}
race-alone = { $own ->
    [yes] Seninki birinci oldu; { $fates }
   *[no] { $name } birinci oldu; { $fates }
}
race-won = { $own ->
    [yes] Seninki { $seconds } s farkla birinci oldu
   *[no] { $name } { $seconds } s farkla birinci oldu
}
race-won-before = { $own ->
    [yes] Seninki { $seconds } s farkla birinci oldu; ikinci: { $next }
   *[no] { $name } { $seconds } s farkla birinci oldu; ikinci: { $nextOwn ->
        [yes] seninki
       *[no] { $next }
    }
}
race-both = İkisi aynı anda, { $seconds } s sonunda
race-several = { $names } aynı anda, { $seconds } s sonunda
race-nobody = Birinci olan yok: { $fates }
race-exploded = { $who ->
    [first] Seninki patladı
    [own] seninki patladı
    [both] ikisi de patladı
    [all] hepsi patladı
   *[other] { $name } patladı
}
race-fell = { $who ->
    [first] Seninki düştü
    [own] seninki düştü
    [both] ikisi de düştü
    [all] hepsi düştü
   *[other] { $name } düştü
}
race-away = { $who ->
    [first] Seninki ters yöne gitti
    [own] seninki ters yöne gitti
    [both] ikisi de ters yöne gitti
    [all] hepsi ters yöne gitti
   *[other] { $name } ters yöne gitti
}
race-misfit = { $who ->
    [first] Seninki bu araziye uymuyor
    [own] seninki bu araziye uymuyor
    [both] ikisi de bu araziye uymuyor
    [all] hiçbiri bu araziye uymuyor
   *[other] { $name } bu araziye uymuyor
}
race-late = { $who ->
    [first] Seninki { $limit } s sınırını aştı
    [own] seninki { $limit } s sınırını aştı
    [both] ikisi de { $limit } s sınırını aştı
    [all] hepsi { $limit } s sınırını aştı
   *[other] { $name } { $limit } s sınırını aştı
}

race-finish = Bitiş, { $way }
race-to = { $distance } ileride
    .behind = { $distance } geride
race-named = { $name }, { $way }

race-full = bir yarışta en çok { $count } cisim olabilir
race-unknown = { $text } ne bir sahnenin bağlantısı ne de adı
