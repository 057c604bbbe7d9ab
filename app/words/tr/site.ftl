site-title = İpler ve yumuşak cisimler
site-about = Her resim hareket eden bir cisim açar: onu sürükle, bük, sayılarını değiştir. Tarayıcıda çalışır, hiçbir yere bir şey gönderilmez.
site-own = Kullanıcı sahneleri
site-find = Sahne bul
site-count = { $count } sahne
site-found = { $found } / { $count } sahne
site-none = Hiçbir sahnede bu sözcüklerin tümü yok.
site-unknown = Burada şu adda bir sahne yok: { $name }.
site-groups = Gruplar
site-dark = Koyu sayfa
site-made = softrod ile yapıldı. Bu sayfalar için sunucu veya ağ gerekmez.

site-bar = Galeri
site-all = Bütün sahneler
    .hint = Bütün sahneler (O)
site-before = Önceki: { $scene }
site-after = Sonraki: { $scene }
site-save = Bu sayfayı tek dosya olarak kaydet
